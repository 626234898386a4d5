// SPDX-License-Identifier: Apache-2.0
#include "app/verify_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "core/error.hpp"
#include "output/files.hpp"
#include "report/picture.hpp"
#include "report/plot.hpp"
#include "verification/table.hpp"

namespace kerf {

namespace {

// The program writes the part of the page between these lines.
constexpr std::string_view table_begin = "<!-- kerf verify: begin -->\n";
constexpr std::string_view table_end = "<!-- kerf verify: end -->";
constexpr int plot_points = 400;
constexpr double picture_scale = 0.5;
// The names of palette::curves.
constexpr const char* colour_names[] = {"blue",   "vermilion", "green",  "purple",
                                        "orange", "sky blue",  "yellow", "black"};

std::string draw_curves(const CheckCurves& curves) {
  double first = std::numeric_limits<double>::infinity(), last = 0.0;
  for (const TimeSeries& series : curves.series) {
    if (series.time.empty()) continue;
    first = std::min(first, series.time.front());
    last = std::max(last, series.time.back());
  }
  Plot plot{{"time", "s"}, {curves.quantity, curves.unit}};
  for (int i = 0; i < plot_points; ++i)
    plot.x.push_back(first + (last - first) * i / (plot_points - 1));
  for (std::size_t run = 0; run < curves.runs.size(); ++run) {
    Curve curve{curves.runs[run], {}, palette::curves[run % palette::curves.size()], Stroke::full};
    for (const double time : plot.x) curve.y.push_back(value_at(curves.series[run], time));
    plot.curves.push_back(curve);
  }
  if (curves.reference)
    plot.curves.push_back({"reference", std::vector<double>(plot.x.size(), *curves.reference),
                           palette::ink, Stroke::dashed});
  return draw_plot(plot);
}

std::string caption_of(const CheckCurves& curves) {
  std::string caption = curves.quantity + ": ";
  for (std::size_t run = 0; run < curves.runs.size(); ++run)
    caption += fmt::format("{}{} {}", run == 0 ? "" : ", ",
                           colour_names[run % std::size(colour_names)], curves.runs[run]);
  return caption + (curves.reference ? "; dashed: the reference" : "");
}

// Writes figures and returns the Markdown that shows them, by case.
class Figures {
 public:
  explicit Figures(const std::filesystem::path& page)
      : link_(std::filesystem::path("images") / page.stem()), folder_(page.parent_path() / link_) {
    std::filesystem::create_directories(folder_);
  }

  void add(const CheckCurves& curves) {
    const std::string name = file_name_of(curves.case_name + " " + curves.quantity);
    add(curves.case_name, name + ".svg", caption_of(curves), draw_curves(curves));
  }
  void add(const RunImage& image) {
    const std::string name = file_name_of(image.case_name + " " + image.run);
    add(image.case_name, name + ".png",
        fmt::format("{}, {:.4g} ms", image.run, 1e3 * image.frame.time),
        draw_picture(image.frame, image.description, picture_scale));
  }
  // Removes the figures that `page` does not show.
  void remove_all_but_those_of(const std::string& page) const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      if (page.find(entry.path().filename().string()) == std::string::npos)
        std::filesystem::remove(entry.path());
  }
  const std::map<std::string, std::string>& by_case() const { return by_case_; }

 private:
  void add(const std::string& case_name, const std::string& file, const std::string& caption,
           const std::string& content) {
    write_file(folder_ / file, content);
    by_case_[case_name] +=
        fmt::format("![{}]({}/{})\n*{}*\n\n", caption, link_.string(), file, caption);
  }

  std::filesystem::path link_;  // from the page to the folder
  std::filesystem::path folder_;
  std::map<std::string, std::string> by_case_;
};

constexpr std::string_view section_begin = "### `";

// Returns the sections between the marks of a page by "NAME/", which is also their order.
std::map<std::string, std::string> sections_of(const std::string& text) {
  std::map<std::string, std::string> sections;
  for (auto begin = text.find(section_begin); begin != std::string::npos;) {
    const auto next = text.find(section_begin, begin + 1);
    const std::string section = text.substr(begin, next - begin);
    const auto name_end = section.find('`', section_begin.size());
    sections[section.substr(section_begin.size(), name_end - section_begin.size()) + "/"] = section;
    begin = next;
  }
  return sections;
}

}  // namespace

void write_verification_page(const std::filesystem::path& page,
                             const std::vector<VerificationCase>& cases, const Findings& findings,
                             TableKind kind, bool keeps_others) {
  std::string text = read_file(page);
  const auto begin = text.find(table_begin);
  const auto end = text.find(table_end);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw UserError(fmt::format("{} has no marks for the table. Write the lines\n{}{}\nat its "
                                "position.",
                                page.string(), table_begin, table_end),
                    exit_files);
  Figures figures(page);
  for (const CheckCurves& curves : findings.curves) figures.add(curves);
  for (const RunImage& image : findings.images) figures.add(image);
  const auto first = begin + table_begin.size();
  auto sections = keeps_others ? sections_of(text.substr(first, end - first))
                               : std::map<std::string, std::string>{};
  for (const VerificationCase& entry : cases) {
    const auto shown = figures.by_case().find(entry.name);
    sections[entry.name + "/"] = to_markdown(
        entry, findings, kind, shown == figures.by_case().end() ? std::string() : shown->second);
  }
  std::string table;
  for (const auto& [name, section] : sections) table += section;
  text.replace(first, end - first, table);
  write_file(page, text);
  figures.remove_all_but_those_of(text);
}

}  // namespace kerf
