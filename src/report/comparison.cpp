// SPDX-License-Identifier: Apache-2.0
// This file writes compare.html, two runs side by side.
#include <fmt/format.h>

#include <array>
#include <compare>
#include <set>
#include <sstream>
#include <utility>

#include "model/case.hpp"
#include "output/files.hpp"
#include "report/html.hpp"
#include "report/metric_rows.hpp"
#include "report/report.hpp"
#include "report/report_parts.hpp"
#include "report/viewer_files.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* compared_metrics[] = {"cut_through_time",
                                            "front_speed",
                                            "front_depth",
                                            "kerf.depth",
                                            "kerf.margin",
                                            "kerf.top.width",
                                            "kerf.middle.width",
                                            "kerf.bottom.width",
                                            "kerf.taper",
                                            "kerf_width",
                                            "fractured_fraction",
                                            "pieces",
                                            "exposure.greatest_feed",
                                            "exposure.possible_feed",
                                            "energy_drift",
                                            "end_time",
                                            "particles",
                                            "wall_time"};

struct Side {
  Json result;
  const ComparedRun* run;
  bool has_jet() const { return !run->description.jets.empty(); }
};

std::string column(const Side& side) {
  const std::string drawing = kerf_figure(side.result, side.run->description);
  return fmt::format("<div>\n<h2>{}</h2>\n<p class=\"meta\">{}</p>\n{}{}</div>\n",
                     html::escape(side.result.at("title").get<std::string>()),
                     html::escape(side.run->folder.string()),
                     verdict_part(side.result, side.has_jet()),
                     drawing.empty() ? last_picture(side.result, side.run->folder) : drawing);
}

std::string metrics_table(const std::array<Side, 2>& sides) {
  std::string rows;
  for (const char* name : compared_metrics) {
    const ResultMetric* metric = find_result_metric(name);
    if (metric == nullptr) continue;
    const bool is_known = find_value(sides[0].result, name) || find_value(sides[1].result, name);
    if (!is_known) continue;
    rows += fmt::format(
        "<tr data-key=\"{}\"><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        name, label_html(metric->label), value_html(sides[0].result, *metric),
        value_html(sides[1].result, *metric),
        difference_html(sides[0].result, sides[1].result, *metric));
  }
  return "<h2>Numbers</h2>\n<table id=\"kerf-numbers\" tabindex=\"0\"><thead><tr><th "
         "scope=\"col\">number</th><th "
         "scope=\"col\">first</th><th scope=\"col\">second</th><th scope=\"col\">difference"
         "</th></tr></thead><tbody>\n" +
         rows + "</tbody></table>\n";
}

// A line of a case with the table that it is in.
struct CaseLine {
  std::string table;  // its heading, with the name of an entry of a list
  std::string text;
  auto operator<=>(const CaseLine&) const = default;
};

// Returns the lines of the tables of a case. Entries of lists are told apart by their names, which
// are their first keys.
std::vector<CaseLine> lines_of(const ComparedRun& run) {
  std::istringstream text(read_file(run.folder / "case.used.toml"));
  std::vector<CaseLine> lines;
  std::string table;
  for (std::string line; std::getline(text, line);) {
    if (line.empty()) continue;
    if (line.starts_with("[")) {
      table = line;
      continue;
    }
    if (table.ends_with("]]") && line.starts_with("name = ")) table += "  # " + line;
    lines.push_back({table, line});
  }
  return lines;
}

// Returns the lines of one case that the other does not have, each table with its heading.
std::string own_lines(const ComparedRun& run, const ComparedRun& other) {
  const std::vector<CaseLine> theirs = lines_of(other);
  const std::set<CaseLine> known(theirs.begin(), theirs.end());
  std::string text, table;
  for (const CaseLine& line : lines_of(run)) {
    if (known.count(line) != 0) continue;
    if (line.table != table) text += html::escape(line.table) + "\n";
    table = line.table;
    text += html::escape(line.text) + "\n";
  }
  // It scrolls, so that the keyboard must reach it.
  const std::string start =
      fmt::format("<div><pre tabindex=\"0\" role=\"region\" aria-label=\"What only {} has\">",
                  html::escape(run.folder.string()));
  return start + (text.empty() ? std::string("nothing of its own\n") : text) + "</pre></div>\n";
}

constexpr const char* header = "<header>\n<h1>Two runs side by side</h1>\n</header>\n";

std::string differing_lines(const ComparedRun& first, const ComparedRun& second) {
  return "<h2>Where the cases differ</h2>\n<div class=\"compared\">\n" + own_lines(first, second) +
         own_lines(second, first) + "</div>\n";
}

Side side_of(const ComparedRun& run) {
  const auto file = run.folder / "result.json";
  Json result = read_result(file);
  // The table of both runs has units that depend on it.
  using_result(file, [&] { static_cast<void>(result.at("dimension").get<int>()); });
  return {std::move(result), &run};
}

std::array<Side, 2> sides_of(const ComparedRun& first, const ComparedRun& second) {
  return {side_of(first), side_of(second)};
}

std::string columns(const std::array<Side, 2>& sides) {
  std::string text = "<div class=\"compared\">\n";
  for (const Side& side : sides)
    text += using_result(side.run->folder / "result.json", [&] { return column(side); });
  return text + "</div>\n";
}

bool has_ended(const ComparedRun& run) {
  return std::filesystem::exists(run.folder / "result.json");
}

}  // namespace

void write_comparison(const ComparedRun& first, const ComparedRun& second) {
  const auto sides = sides_of(first, second);
  const std::string body =
      header + columns(sides) + metrics_table(sides) + differing_lines(first, second);
  write_file(first.folder / "compare.html", html::page("Two runs side by side", body));
}

std::string moving_comparison(const ComparedRun& first, const ComparedRun& second,
                              const std::string& runs) {
  std::string body = header;
  body += html::section("kerf-compared", "<p>This browser shows no moving pictures.</p>\n");
  if (has_ended(first) && has_ended(second)) {
    const auto sides = sides_of(first, second);
    body += metrics_table(sides) + columns(sides);
  } else {
    body +=
        "<p class=\"meta\">The numbers are here once both runs have ended and the page is loaded "
        "again.</p>\n";
  }
  body += differing_lines(first, second);
  if (const std::string_view script = viewer_text("script"); !script.empty())
    body += html::data_script("kerf-compared-runs", runs) +
            fmt::format("<script>{}</script>\n", script);
  return html::page("Two runs side by side", body);
}

}  // namespace kerf
