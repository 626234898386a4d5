// SPDX-License-Identifier: Apache-2.0
#include "report/report.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "output/files.hpp"
#include "report/html.hpp"
#include "report/json_number.hpp"
#include "report/report_figures.hpp"
#include "report/viewer_data.hpp"
#include "report/viewer_files.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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

// The sign says the same as the colour.
std::string verdict(const Json& result, bool has_jet) {
  const bool through = result.at("cut_through").get<bool>();
  const char* kind = !has_jet ? "none" : through ? "yes" : "no";
  const char* sign = !has_jet ? "" : through ? "<b>✓</b>" : "<b>✗</b>";
  return fmt::format("<p class=\"verdict {}\">{}{}</p>\n", kind, sign,
                     html::escape(result.at("verdict").get<std::string>()));
}

double value_of(const Json& result, const char* key) {
  return kerf::value_of(result.at(key));
}

std::string percent(double share) {
  return html::number(100.0 * share, 3) + "\u202f%";
}

std::string key_figures(const Json& result, bool has_jet) {
  std::vector<std::pair<std::string, std::string>> figures;
  const auto add = [&](const char* name, std::string value) {
    figures.emplace_back(name, std::move(value));
  };
  if (has_jet) {
    add("cut through after", html::quantity(value_of(result, "cut_through_time"), "s", 3));
    add("speed of the water front", html::number(value_of(result, "front_speed"), 3) + "\u202fm/s");
    add("front depth", html::quantity(value_of(result, "front_depth"), "m", 3));
    add("kerf width at half depth", html::quantity(value_of(result, "kerf_width"), "m", 3));
    add("solid fractured", percent(value_of(result, "fractured_fraction")));
    add("regime", html::escape(result.at("regime").get<std::string>()));
  }
  add("energy unaccounted for", percent(value_of(result, "energy_drift")));
  add("computing time", html::quantity(value_of(result, "wall_time"), "s", 3));
  std::string text = "<dl class=\"figures\">\n";
  for (const auto& [name, value] : figures)
    text += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, value);
  return text + "</dl>\n";
}

// The sign says the same as the colour.
std::string validity(const Json& result) {
  std::string text = "<h3>What this run can and cannot promise</h3>\n<ul class=\"validity\">\n";
  for (const Json& flag : result.at("validity")) {
    const auto state = flag.at("state").get<std::string>();
    const char* sign = state == "good" ? "✓" : state == "warning" ? "!" : "·";
    text += fmt::format("<li class=\"{}\"><b>{}</b>{}</li>\n", state, sign,
                        html::escape(flag.at("sentence").get<std::string>()));
  }
  return text + "</ul>\n";
}

std::string pictures(const Json& result, const fs::path& folder) {
  const Json& list = result.at("pictures");
  if (list.empty()) return "";
  // A picture of a 3D case holds two panels and wants the whole width.
  const bool wide = result.at("dimension").get<int>() == 3;
  std::string text = fmt::format("<div class=\"pictures{}\">\n", wide ? " wide" : "");
  for (const Json& picture : list)
    text +=
        fmt::format("<figure><img alt=\"The particles at {:.4g} ms\" src=\"{}\"></figure>\n",
                    1e3 * picture.at("time").get<double>(),
                    html::png_address(read_file(folder / picture.at("file").get<std::string>())));
  return "<h2>The run</h2>\n" + html::section("kerf-viewer", text + "</div>\n");
}

Json read_result(const fs::path& path) {
  if (!fs::exists(path))
    throw UserError(fmt::format("there is no {}: the run has not ended yet. Go on with it by 'kerf "
                                "run CASE --out {} --resume'.",
                                path.string(), path.parent_path().string()),
                    exit_files);
  return Json::parse(read_file(path));
}

}  // namespace

void write_report(const fs::path& folder, const Case& description) {
  constexpr std::size_t budget = 10'000'000;  // bytes of frames
  Json run;
  if (!viewer_text("script").empty()) {  // else nobody would show them
    ViewerPacker packer(description);
    packer.look_at(frame_files(folder));
    run = packer.head();
    run["live"] = false;
    run["frames"] = viewer_frames(packer, budget);
  }
  write_file(folder / "report.html", report_page(folder, description, std::move(run)));
}

std::string report_page(const fs::path& folder, const Case& description, Json run) {
  const fs::path result_path = folder / "result.json";
  try {
    const Json result = read_result(result_path);
    const SeriesTable series(folder / "series.csv", description);
    const bool has_jet = !description.jets.empty();
    const bool through = result.at("cut_through").get<bool>();
    const double cut_time = through ? value_of(result, "cut_through_time") : -1.0;
    const auto figures = report_figures(series, description);
    const std::vector<double> time = series.numbers("time");
    std::string body = heading(result) + verdict(result, has_jet) + key_figures(result, has_jet) +
                       validity(result) + pictures(result, folder) + kerf_part(result) +
                       "<h2>Curves</h2>\n" +
                       html::section("kerf-curves", report_plots(figures, time, cut_time)) +
                       report_tables(result, description);
    run["curves"] = viewer_curves(figures, time, cut_time);
    return html::page(description.title, body + viewer_script(run));
  } catch (const Json::exception& error) {
    throw UserError(fmt::format("{} is damaged ({}). Make it again with 'kerf run CASE --out {} "
                                "--resume'.",
                                result_path.string(), error.what(), folder.string()),
                    exit_files);
  }
}

}  // namespace kerf
