// SPDX-License-Identifier: Apache-2.0
#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "model/case.hpp"
#include "output/files.hpp"
#include "report/html.hpp"
#include "report/metric_rows.hpp"
#include "report/report_figures.hpp"
#include "report/report_parts.hpp"
#include "report/viewer_data.hpp"
#include "report/viewer_files.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_points = 1000;  // of a curve
constexpr std::size_t most_picture_bytes = 6'000'000;
constexpr std::size_t least_scene_bytes = 1'000'000;
constexpr std::size_t page_reserve = 500'000;  // bytes, for the rest of the page

std::string heading(const Json& result) {
  return fmt::format(
      "<header>\n<h1>{}</h1>\n<p class=\"meta\">Case <code>{}</code> · {} dimensions · formulation "
      "{} · {} precision · Kerf {}</p>\n</header>\n",
      html::escape(result.at("title").get<std::string>()),
      html::escape(result.at("case").get<std::string>()),
      result.at("dimension").get<int>() == 2 ? "two" : "three",
      result.at("formulation").get<std::string>(), result.at("precision").get<std::string>(),
      result.at("version").get<std::string>());
}

struct Figure {
  const char* key;  // path in result.json
  std::string note = {};
};

void add_cut(std::vector<Figure>& figures, const Json& result) {
  figures.push_back({"cut_through_time"});
  figures.push_back({"front_speed"});
  figures.push_back(
      {"front_depth",
       "where the water is, in dents too; the face counts as it has come towards the nozzle"});
  if (result.contains("kerf")) {
    figures.push_back(
        {"kerf.depth",
         is_parted(result)
             ? "where material is gone; below it parted " + loss_words(result.at("kerf"))
             : "where material is gone" + standing_words(result.at("kerf"))});
    figures.push_back({"kerf.middle.width", "where material is gone, at half its depth"});
  }
  figures.push_back(
      {"kerf_width",
       "at the end, at half the depth of the water front, what was pushed aside too"});
  figures.push_back({"fractured_fraction"});
  figures.push_back({"regime"});
}

std::string key_figures(const Json& result, bool has_jet) {
  std::vector<Figure> figures;
  if (has_jet) add_cut(figures, result);
  figures.push_back({"energy_drift"});
  figures.push_back({"wall_time"});
  std::string text = "<dl class=\"figures\">\n";
  for (const Figure& figure : figures) {
    const ResultMetric& metric = *find_result_metric(figure.key);
    text += fmt::format("<div><dt>{}</dt><dd{}>{}</dd>", label_html(metric.label),
                        html::key_mark(figure.key), value_html(result, metric, 3));
    if (!figure.note.empty()) text += fmt::format("<dd class=\"note\">{}</dd>", figure.note);
    text += "</div>\n";
  }
  return text + "</dl>\n";
}

// The sign has the same meaning as the colour.
std::string validity(const Json& result) {
  std::string text = "<h3>What this run can and cannot promise</h3>\n<ul class=\"validity\">\n";
  for (const Json& flag : result.at("validity")) {
    const auto state = flag.at("state").get<std::string>();
    const char* sign = state == "good" ? "✓" : state == "warning" ? "!" : "·";
    text += fmt::format("<li class=\"{}\"><b>{}</b><span>{}</span></li>\n", state, sign,
                        html::escape(flag.at("sentence").get<std::string>()));
  }
  return text + "</ul>\n";
}

// Returns a link to the page of the study where the folder is that of one of its runs.
std::string study_link(const fs::path& folder) {
  const fs::path study = fs::absolute(folder).lexically_normal().parent_path().parent_path();
  if (!fs::exists(study / "study.db")) return "";
  return "<p class=\"meta\"><a href=\"../../study.html\">All runs of the study</a></p>\n";
}

constexpr const char* no_viewer =
    "<p class=\"remark\">This Kerf was built without the viewer: pictures instead of the moving "
    "scene; see docs/development.md, \"Build\", and <code>kerf report OUT --movie</code>.</p>\n";

// Returns evenly spaced pictures, at most `budget` bytes.
std::string pictures(const Json& result, const fs::path& folder, std::size_t budget) {
  const Json& list = result.at("pictures");
  if (list.empty()) return "";
  std::size_t largest = 1;
  for (const Json& picture : list) {
    const fs::path file = file_of(folder, picture);
    if (fs::exists(file)) largest = std::max<std::size_t>(largest, fs::file_size(file) * 4 / 3);
  }
  const std::size_t last = list.size() - 1, most = std::max<std::size_t>(2, budget / largest);
  const std::size_t stride = std::max<std::size_t>(1, (last + most - 2) / (most - 1));
  // A picture of a 3D case has two panels and takes the full width.
  const bool wide = result.at("dimension").get<int>() == 3;
  std::string text = fmt::format("<div class=\"pictures{}\">\n", wide ? " wide" : "");
  const auto add = [&](const Json& picture) { text += picture_figure(folder, picture); };
  for (std::size_t n = 0; n < last; n += stride) add(list[n]);
  add(list[last]);
  text += "</div>\n";
  if (stride > 1)
    text += fmt::format(
        "<p class=\"remark\">Some of {} pictures; all are in "
        "<code>pictures/</code>.</p>\n",
        list.size());
  return html::section("kerf-viewer", text);
}

// Returns the case as it was run, in a folded element that opens for printing.
std::string used_case(const fs::path& folder) {
  return fmt::format(
      "<h2>The case</h2>\n<details class=\"case\"><summary>What was run, with all defaults: "
      "case.used.toml</summary>\n<pre>{}</pre></details>\n"
      "<script>addEventListener(\"beforeprint\", () => "
      "document.querySelectorAll(\"details\").forEach((part) => part.open = true));</script>\n",
      html::escape(read_file(folder / "case.used.toml")));
}

// The parts of a page; the moving scene stands between `above` and `below`.
struct Parts {
  std::string above, below;
  Json curves;

  std::size_t size() const {
    return above.size() + below.size() + curves.dump().size() + viewer_text("script").size() +
           viewer_text("style").size();
  }
  std::string page(const std::string& title, Json run, const std::string& remark) const {
    if (!run.is_null()) run["curves"] = curves;
    return html::page(title, above + remark + below + (run.is_null() ? "" : viewer_script(run)));
  }
};

Parts parts_of(const fs::path& folder, const Case& description) {
  const Json result = read_result(folder / "result.json");
  const SeriesTable series(folder / "series.csv", description);
  const bool has_jet = !description.jets.empty();
  const bool through = result.at("cut_through").get<bool>();
  const double cut_time = through ? value_of(result.at("cut_through_time")) : -1.0;
  auto figures = report_figures(series, description);
  std::vector<double> time = series.numbers("time");
  thin_figures(figures, time, most_points);
  Parts parts;
  parts.above = heading(result) + study_link(folder) + verdict_part(result, has_jet) +
                first_screen(result, description, last_picture(result, folder)) +
                key_figures(result, has_jet) + intervals_table(result) + validity(result) +
                "<h2>The run</h2>\n";
  parts.below = pictures(result, folder, most_picture_bytes) + kerf_part(result, description) +
                "<h2>Curves</h2>\n" +
                html::section("kerf-curves", report_plots(figures, time, cut_time)) +
                used_case(folder) + report_tables(result, description);
  parts.curves = viewer_curves(figures, time, cut_time);
  return parts;
}

// Returns a remark on particles and frames that the scene leaves out.
std::string scene_remark(const ViewerPacker& packer, std::size_t frames) {
  std::string left_out;
  if (packer.share() < 1.0)
    left_out = fmt::format("{} of the particles, drawn larger,", html::percent(packer.share()));
  if (frames < packer.frames())
    left_out +=
        fmt::format("{}{} of {} frames", left_out.empty() ? "" : " and ", frames, packer.frames());
  if (left_out.empty()) return "";
  return fmt::format(
      "<p class=\"remark\">The moving scene shows {}, to keep this page small; "
      "<code>kerf view OUT</code> shows all.</p>\n",
      left_out);
}

}  // namespace

void write_report(const fs::path& folder, const Case& description) {
  const Parts parts =
      using_result(folder / "result.json", [&] { return parts_of(folder, description); });
  Json run;
  std::string remark = no_viewer;
  if (!viewer_text("script").empty()) {
    ViewerPacker packer(description);
    packer.add_frames(frame_files(folder));
    const std::size_t used = parts.size() + page_reserve;
    const std::size_t budget =
        std::max(least_scene_bytes, report_limit - std::min(report_limit, used));
    packer.fit(budget);
    run = packer.head();
    run["live"] = false;
    run["frames"] = viewer_frames(packer, budget);
    remark = scene_remark(packer, run["frames"].size());
  }
  write_file(folder / "report.html", parts.page(description.title, std::move(run), remark));
}

std::string report_page(const fs::path& folder, const Case& description, Json run) {
  const Parts parts =
      using_result(folder / "result.json", [&] { return parts_of(folder, description); });
  const bool has_viewer = !run.is_null() && !viewer_text("script").empty();
  return parts.page(description.title, std::move(run), has_viewer ? "" : no_viewer);
}

}  // namespace kerf
