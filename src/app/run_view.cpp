// SPDX-License-Identifier: Apache-2.0
#include "app/run_view.hpp"

#include <fmt/format.h>

#include <mutex>

#include "app/local_server.hpp"
#include "app/run_folder.hpp"
#include "model/case.hpp"
#include "report/html.hpp"
#include "report/report.hpp"
#include "report/report_figures.hpp"
#include "report/viewer_data.hpp"

namespace kerf {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// Returns the time of cut-through from the series, s; -1 if there is none.
double cut_time_of(const SeriesTable& series) {
  const auto time = series.numbers("time"), cut = series.numbers("cut_through");
  for (std::size_t i = 0; i < cut.size(); ++i)
    if (cut[i] != 0.0) return time[i];
  return -1.0;
}

}  // namespace

struct RunView::State {
  State(const fs::path& run_folder, std::string place_of_files)
      : folder(run_folder),
        place(std::move(place_of_files)),
        description(case_of_run(run_folder)),
        packer(description) {}

  bool is_live() const { return !fs::exists(folder / "result.json"); }

  Json run() {
    packer.add_frames(frame_files(folder));
    Json run = packer.head();
    run["live"] = is_live();
    run["frames"] = Json::array();
    for (std::size_t n = 0; n < packer.frames(); ++n) {
      Json entry = packer.entry(n);
      // The fields are part of the address, as the bytes depend on them.
      entry["url"] = fmt::format("{}frame/{}?fields={}", place, n, run.at("fields").size());
      run["frames"].push_back(std::move(entry));
    }
    if (fs::exists(folder / "series.csv")) {
      const SeriesTable series(folder / "series.csv", description);
      run["curves"] = viewer_curves(report_figures(series, description), series.numbers("time"),
                                    cut_time_of(series));
    }
    return run;
  }

  std::string page() {
    if (!is_live()) return report_page(folder, description, run());
    const std::string body = fmt::format(
        "<header>\n<h1>{}</h1>\n<p class=\"meta\">The run is in progress; this page follows "
        "it.</p>\n</header>\n{}{}",
        html::escape(description.title),
        html::section("kerf-viewer", "<p>This browser shows no moving pictures.</p>\n"),
        html::section("kerf-curves", ""));
    return html::page(description.title, body + viewer_script(run()));
  }

  fs::path folder;
  std::string place;
  Case description;
  ViewerPacker packer;
  std::mutex mutex;  // one request at a time reads the folder
};

RunView::RunView(const fs::path& folder, const std::string& place)
    : state_(std::make_unique<State>(folder, place)) {}
RunView::~RunView() = default;

std::string RunView::page() {
  const std::lock_guard hold(state_->mutex);
  return state_->page();
}
std::string RunView::run_json() {
  const std::lock_guard hold(state_->mutex);
  return state_->run().dump();
}
std::string RunView::frame(std::size_t number) {
  const std::lock_guard hold(state_->mutex);
  if (number >= state_->packer.frames())
    throw RefusedRequest(
        http_status::not_found,
        fmt::format("there is no frame {}: the run has {}\n", number, state_->packer.frames()));
  return state_->packer.pack(number);
}

void serve_files(LocalServer& server, RunView& view, const std::string& place) {
  server.get(place + "run.json", RunView::json_type,
             [&view](const auto&) { return view.run_json(); });
  server.get(place + RunView::frame_pattern, RunView::frame_type,
             [&view](const auto& parts) { return view.frame(std::stoul(parts[1])); });
}

}  // namespace kerf
