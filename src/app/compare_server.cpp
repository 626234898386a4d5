// SPDX-License-Identifier: Apache-2.0
#include "app/compare_server.hpp"

#include <fmt/format.h>

#include "app/run_folder.hpp"
#include "report/report.hpp"

namespace kerf {

CompareServer::Part::Part(const std::filesystem::path& run_folder, const std::string& own_place)
    : folder(run_folder), description(case_of_run(run_folder)), view(run_folder, own_place) {}

CompareServer::CompareServer(const std::filesystem::path& first,
                             const std::filesystem::path& second)
    : LocalServer("kerf view --compare"), first_(first, "first/"), second_(second, "second/") {
  get("", RunView::page_type, [this](const auto&) { return page(); });
  serve_files(*this, first_.view, "first/");
  serve_files(*this, second_.view, "second/");
}

std::string CompareServer::page() {
  return moving_comparison({first_.folder, first_.description},
                           {second_.folder, second_.description},
                           fmt::format("[{},{}]", first_.view.run_json(), second_.view.run_json()));
}

}  // namespace kerf
