// SPDX-License-Identifier: Apache-2.0
#include "app/compare_server.hpp"

#include <fmt/format.h>

#include "app/run_folder.hpp"
#include "report/report.hpp"

namespace kerf {

CompareServer::Part::Part(const std::filesystem::path& run_folder, const std::string& own_place)
    : folder(run_folder),
      place(own_place),
      description(case_of_run(run_folder)),
      view(run_folder, own_place) {}

CompareServer::CompareServer(const std::filesystem::path& first,
                             const std::filesystem::path& second)
    : LocalServer("kerf view --compare"), first_(first, "first/"), second_(second, "second/") {
  get("", RunView::page_type, [this](const auto&) { return page(); });
  set_routes(first_);
  set_routes(second_);
}

void CompareServer::set_routes(Part& part) {
  get(part.place + "run.json", RunView::json_type,
      [&part](const auto&) { return part.view.run_json(); });
  get(part.place + RunView::frame_pattern, RunView::frame_type,
      [&part](const auto& parts) { return part.view.frame(std::stoul(parts[1])); });
}

std::string CompareServer::page() {
  return moving_comparison({first_.folder, first_.description},
                           {second_.folder, second_.description},
                           fmt::format("[{},{}]", first_.view.run_json(), second_.view.run_json()));
}

}  // namespace kerf
