// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "input/parse_toml.hpp"
#include "input/read.hpp"
#include "input/section.hpp"
#include "model/case.hpp"
#include "output/files.hpp"
#include "study/case_maker.hpp"
#include "study/layout.hpp"
#include "study/read_study.hpp"
#include "study/run_table.hpp"
#include "study/study_plan.hpp"
#include "study/used_materials.hpp"

namespace kerf {

namespace {

namespace fs = std::filesystem;

bool is_range(const toml::table& table) {
  return table.contains("from") || table.contains("to");
}

// Refuses a file that describes a case.
void refuse_case(StudySection& top, const fs::path& file) {
  if (top.has("base")) return;
  for (const char* key : {"dimension", "machine", "body", "jet"})
    if (top.has(key)) {
      top.refuse(key, "this is a case, which has no settings to vary, and not a study",
                 "a study, which names its case by `base`",
                 fmt::format("Use \"kerf run {0}\", or write a study with base = \"{1}\"",
                             file.string(), file.filename().string()));
      return;
    }
}

// Returns the text of the case that `base` names; nothing, with a problem noted, when there is
// none.
std::string base_text(StudySection& top, const fs::path& study,
                      std::span<const EmbeddedText> templates, std::string& name) {
  name = top.text("base");
  const fs::path beside = study.parent_path() / name;
  if (fs::is_regular_file(beside)) {
    name = beside.string();
    return read_file(beside);
  }
  std::vector<std::string> names;
  for (const EmbeddedText& entry : templates) {
    if (entry.name == name) return std::string(entry.text);
    names.emplace_back(entry.name);
  }
  const std::string guess = closest(name, names);
  if (top.has("base"))
    top.refuse("base", "there is no such file beside the study, and no such case",
               "a file, or one of the cases that \"kerf new\" lists",
               guess.empty() ? "Correct the name" : fmt::format("Did you mean \"{}\"?", guess));
  return "";
}

void read_set(StudySection& top, AxisReader& reader, StudyPlan& plan) {
  const toml::table* set = top.table("set");
  if (!set) return;
  const auto is_value = [](const toml::table&) { return false; };
  for_each_key(*set, "", is_value, [&](const std::string& path, const toml::node& node) {
    const std::string reported_key = "set." + path;
    reader.note("set", path, reported_key, node);
    if (const auto key = reader.key(path, reported_key)) set_key(plan.base, *key, node);
  });
}

// Returns whether the table has entries, also refused ones.
bool read_vary(StudySection& top, AxisReader& reader, StudyPlan& plan) {
  const toml::table* vary = top.table("vary");
  if (!vary) return false;
  for_each_key(*vary, "", is_range, [&](const std::string& path, const toml::node& node) {
    const std::string reported_key = "vary." + path;
    reader.note("vary", path, reported_key, node);
    if (auto axis = reader.axis(path, reported_key, node)) plan.axes.push_back(std::move(*axis));
  });
  // TOML does not keep the order of keys: the order of the lines is restored.
  const auto line = [&](const Axis& axis) {
    std::uint32_t found = 0;
    for_each_key(*vary, "", is_range, [&](const std::string& path, const toml::node& node) {
      if (path == axis.name()) found = node.source().begin.line;
    });
    return found;
  };
  std::stable_sort(plan.axes.begin(), plan.axes.end(),
                   [&](const Axis& a, const Axis& b) { return line(a) < line(b); });
  return !vary->empty();
}

void read_design(StudySection& top, bool varies, StudyPlan& plan) {
  const toml::table* table = top.table("design");
  const bool is_wanted = table || !(top.has("search") || top.has("calibrate"));
  if (!is_wanted) return;
  const toml::table empty;
  StudySection section(top.problems(), table ? *table : empty, "design");
  Design design;
  design.kind = static_cast<DesignKind>(section.word("type", design_words, 0));
  if (design.kind != DesignKind::grid)
    design.runs = static_cast<std::size_t>(section.whole("runs", 1, most_runs));
  if (design.kind == DesignKind::latin_hypercube)
    design.seed = static_cast<std::uint64_t>(section.whole("seed", 0, 2147483647, 1));
  section.refuse_unknown();
  if (!varies)
    top.refuse("vary", "nothing is varied", "at least one key of the case",
               "Add [vary] with a line such as \"machine.pressure\" = [\"1 MPa\", \"2 MPa\"]");
  double settings = 1.0;
  for (const Axis& axis : plan.axes) settings *= static_cast<double>(axis.levels());
  if (design.kind == DesignKind::grid && settings > most_runs)
    top.refuse("vary", fmt::format("the grid has {:.3g} settings", settings),
               fmt::format("at most {}", most_runs),
               "Take fewer values, or a Latin hypercube: [design] type = \"latin_hypercube\"");
  plan.design = design;
}

// Refuses varied keys beside a search that does not use them.
void check_use_of_axes(StudySection& top, const StudyPlan& plan) {
  if (plan.axes.empty() || plan.design || plan.optimum) return;
  top.refuse("vary", "neither the search nor the calibration varies these keys",
             "[vary] with a [design], or none",
             "Add [design] type = \"grid\" to run them too, or remove [vary]");
}

// Refuses repeats of a case in which nothing depends on the seeds.
void check_repeats(StudySection& top, const StudyPlan& plan, const Case& base) {
  const bool is_random = has_random_layout(base);
  const bool is_varied = std::any_of(plan.axes.begin(), plan.axes.end(), [](const Axis& axis) {
    return axis.name().ends_with(".jitter");
  });
  if (plan.repeats == 1 || is_random || is_varied) return;
  top.refuse("repeats", "no body of the case has a random layout, so all repeats are the same run",
             "1", "Give a body jitter, [set] \"body.NAME.jitter\" = 0.2, or remove the key");
}

// Refuses varied keys of materials that no run uses.
void check_materials(StudySection& top, const StudyPlan& plan, const Case& base) {
  const std::vector<std::string> used = used_materials(base, all_axes(plan));
  const auto check = [&](const std::string& reported_key, const Axis& axis) {
    const std::string problem = unused_material(axis.path, used);
    if (!problem.empty())
      top.problems().add({reported_key, problem, "a key of a material that is used",
                          "Correct the name, or give the material to a body"});
  };
  for (const Axis& axis : plan.axes) check("vary." + axis.name(), axis);
  if (plan.threshold) check("search.key", plan.threshold->axis);
  if (!plan.calibration) return;
  check("calibrate.key", plan.calibration->axis);
  for (const Axis& axis : plan.calibration->at_axes) check("calibrate.at." + axis.name(), axis);
}

// Returns the base with the keys of [set].
Case case_with_set(const StudyPlan& plan) {
  std::ostringstream written;
  written << plan.base;
  try {
    return parse_case(written.str(), plan.base_name);
  } catch (const UserError& error) {
    throw refused_case(plan.file, "[set]", error, plan.base_name);
  }
}

}  // namespace

StudyPlan plan_of_case(const fs::path& case_file, const std::string& text,
                       const Case& description) {
  StudyPlan plan;
  plan.name = case_file.stem().string();
  plan.file = case_file.string();
  plan.title = description.title;
  plan.text = text;
  plan.base_name = case_file.string();
  plan.base = toml::parse(text);
  plan.dimension = description.dimension;
  return plan;
}

StudyPlan parse_study(const std::string& text, const fs::path& file,
                      std::span<const EmbeddedText> templates) {
  constexpr double least_refinement = 0.01, most_refinement = 100.0;
  const toml::table table = parse_toml(text, file.string());
  Problems problems(file.string());
  StudySection top(problems, table, "");
  StudyPlan plan;
  plan.name = file.stem().string();
  plan.file = file.string();
  plan.text = text;
  refuse_case(top, file);
  problems.throw_if_any();
  plan.title = top.text("title", plan.name);
  const std::string base = base_text(top, file, templates, plan.base_name);
  problems.throw_if_any();
  parse_case(base, plan.base_name);  // problems of the case itself refer to its own file
  plan.base = toml::parse(base);
  plan.refinement = top.number("refine", least_refinement, most_refinement, 1.0);
  plan.repeats = top.whole("repeats", 1, 1000, 1);
  plan.metrics = top.metrics("metrics");
  AxisReader reader(problems, plan.base);
  read_set(top, reader, plan);
  plan.dimension = plan.base["dimension"].value_or(plan.dimension);
  const bool varies = read_vary(top, reader, plan);
  read_design(top, varies, plan);
  read_goals(top, reader, plan);
  reader.refuse_repeated();
  check_use_of_axes(top, plan);
  top.refuse_unknown();
  problems.throw_if_any();
  const Case with_set = case_with_set(plan);
  check_repeats(top, plan, with_set);
  check_materials(top, plan, with_set);
  problems.throw_if_any();
  return plan;
}

StudyPlan read_study(const fs::path& file, std::span<const EmbeddedText> templates) {
  return parse_study(read_file(file), file, templates);
}

}  // namespace kerf
