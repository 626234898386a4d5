// SPDX-License-Identifier: Apache-2.0
#include "study/limit_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "geometry/jet_direction.hpp"
#include "input/problems.hpp"
#include "input/read.hpp"
#include "input/refine.hpp"
#include "input/units.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "output/files.hpp"
#include "study/coarser_spacings.hpp"
#include "study/layout.hpp"
#include "study/read_condition.hpp"
#include "study/read_study.hpp"
#include "study/used_materials.hpp"

namespace kerf {

namespace {

// A case with what the question refers to.
struct Asked {
  const LimitQuestion& question;
  std::string file;
  Case description;
};

[[noreturn]] void refuse(const Asked& asked, const std::string& what, const std::string& remedy) {
  throw UserError(fmt::format("{}: --of {}: {}. {}.", asked.file, asked.question.of, what, remedy));
}

const LimitQuantity* find_quantity(const std::string& name) {
  const auto& all = limit_quantities();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const LimitQuantity& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

// Returns the quantities that have a key in such a case, with commas between.
std::string quantities_of(const Case& description) {
  std::vector<std::string_view> names;
  for (const LimitQuantity& each : limit_quantities())
    if (!(description.machine ? each.of_machine : each.of_jet).empty()) names.push_back(each.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

// Returns the path of the only component of the traverse of a jet that is not 0.
std::string traverse_path(const Asked& asked, const std::string& key) {
  const Jet& jet = asked.description.jets.front();
  int moving = -1, count = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (jet.traverse[static_cast<std::size_t>(axis)] != 0.0) moving = axis, ++count;
  if (count == 1) return fmt::format("{}.{}", key, moving);
  refuse(asked,
         fmt::format("jet.{}.traverse is ({:g}, {:g}, {:g}) m/s; the feed is searched along one "
                     "axis. Allowed: one component other than 0 m/s, the others 0 m/s",
                     jet.name, jet.traverse[0], jet.traverse[1], jet.traverse[2]),
         "Let the nozzle travel along x, such as traverse = [\"10 mm/s\", \"0 m/s\"], or write a "
         "[machine] with a traverse_speed");
}

std::string path_of(const Asked& asked) {
  const Case& description = asked.description;
  const LimitQuantity* quantity = find_quantity(asked.question.of);
  if (!quantity) return asked.question.of;
  if (description.jets.empty())
    refuse(asked, "the case has no jet", "Add a [machine] or a [[jet]]");
  const std::string_view key = description.machine ? quantity->of_machine : quantity->of_jet;
  if (key.empty())
    refuse(asked,
           fmt::format("a case with a {} has no such limit. Allowed: {}, or the path of a key",
                       description.machine ? "[machine]" : "[[jet]]", quantities_of(description)),
           description.machine ? "Ask for the pressure, from which the speed follows"
                               : "Write the jet as a [machine], or ask for another quantity");
  if (description.machine) return std::string(key);
  const std::string path = fmt::format("jet.{}.{}", description.jets.front().name, key);
  return key == "traverse" ? traverse_path(asked, path) : path;
}

bool is_least(const Asked& asked, const std::string& path) {
  const std::string& find = asked.question.find;
  if (!find.empty()) return find == "least";
  if (const LimitQuantity* quantity = find_quantity(asked.question.of)) return quantity->least;
  if (path.starts_with("materials.")) return false;  // a stronger material is harder to cut
  refuse(asked, "the program does not know whether this key has a least or a greatest value",
         "Add --find least or --find greatest");
}

KeyPath key_of(const Asked& asked, const toml::table& base) {
  KeyPath path = find_key_path(path_of(asked), base);
  const bool is_usable = path.problem.empty() && path.is_number();
  if (is_usable) {
    const std::string unused = unused_material(path, used_materials(asked.description, {}));
    if (!unused.empty())
      refuse(asked, unused + ". Allowed: a key of a material that is used",
             "Correct the name, or give the material to a body");
    return path;
  }
  std::vector<std::string> words;
  for (const LimitQuantity& each : limit_quantities()) words.emplace_back(each.name);
  const std::string guess = closest(asked.question.of, words);
  refuse(asked,
         fmt::format("{}. Allowed: {}, or the path of a key that holds one number, such as "
                     "materials.NAME.failure_strain",
                     path.problem.empty() ? "the key does not hold one number" : path.problem,
                     quantities_of(asked.description)),
         guess.empty() ? "docs/keys.md has all keys" : fmt::format("Did you mean \"{}\"?", guess));
}

double read_number(const Asked& asked, const KeyPath& path, const char* option,
                   const std::string& text) {
  const Quantity quantity = read_value(text, path.unit());
  if (!quantity.problem.empty() || !in_range(*path.key, quantity.value) || quantity.value <= 0.0)
    throw UserError(fmt::format(
        "{}: {} \"{}\": {}. Allowed for {}: {}, greater than 0. Write a text such as "
        "\"{}\".",
        asked.file, option, text,
        quantity.problem.empty() ? "the value is out of range" : quantity.problem, path.text,
        allowed_text(*path.key), path.unit().empty() ? "0.5" : example_of(path.unit())));
  return quantity.value;
}

// Reads the stated value and chooses the range around it.
Axis axis_of(const Asked& asked, toml::table& base, double& stated) {
  Axis axis;
  axis.path = key_of(asked, base);
  const toml::node* node = find_value(base, axis.path);
  Problems problems(asked.file);
  if (node) {
    problems.mention(axis.name(), static_cast<int>(node->source().begin.line), "");
    stated = AxisReader(problems, base).number(axis.path, axis.name(), *node).value_or(0.0);
    axis.shown_unit = unit_of(*node);
  }
  problems.throw_if_any();
  axis.is_reversed = asked.question.of == "feed" && stated < 0.0;
  stated = axis.of_case(stated);
  if (!(stated > 0.0))
    refuse(asked,
           fmt::format("the case states {}; the search starts from the stated value. Allowed for "
                       "{}: {}, greater than 0",
                       node ? fmt::format("{} = {:g}", axis.name(), stated) : "no " + axis.name(),
                       axis.name(), allowed_text(*axis.path.key)),
           "State a value at which the cut is tried first");
  const LimitQuestion& question = asked.question;
  const double most = axis.path.key->range.maximum;
  double low = stated / limit_range_factor, high = std::min(most, stated * limit_range_factor);
  if (!question.from.empty()) low = read_number(asked, axis.path, "--from", question.from);
  if (!question.to.empty()) high = read_number(asked, axis.path, "--to", question.to);
  if (low >= high)
    throw UserError(fmt::format(
        "{}: the range of {} ends at {:g} {}, which is not above its beginning, {:g} {}. Correct "
        "--from or --to.",
        asked.file, axis.name(), high, axis.path.unit(), low, axis.path.unit()));
  axis.values = {low, high};
  axis.is_range = axis.is_logarithmic = true;
  return axis;
}

// Removes times of outputs, which may lie beyond the end of a shorter run.
void drop_output_times(toml::table& base) {
  if (toml::table* output = base["output"].as_table())
    for (const char* key : {"frame_interval", "frame_times", "picture_times", "series_interval"})
      output->erase(key);
}

// Has the nozzle stand in every run as it does in that of the case.
void hold_motion(const Case& description, toml::table& base) {
  if (stands_for_traverse(description))
    base["machine"].as_table()->insert_or_assign("motion", "standing");
}

LimitEnd end_of(const Asked& asked, const toml::table& base, bool is_feed) {
  const Case& description = asked.description;
  LimitEnd end;
  end.end = description.time.end;
  end.follows = description.machine && !base["time"]["end"];
  if (!travels(description) && !is_feed) return end;
  const Jet& jet = description.jets.front();
  end.start = jet.start + std::max(jet.dwell, jet.standoff / jet.speed);
  if (!is_feed || end.follows || stands_for_traverse(description)) return end;
  end.path = traverse_speed(jet) * (end.end - end.start);
  if (end.path <= 0.0)
    refuse(asked,
           fmt::format("{} = {:g} s is before the jet travels over the workpiece, from {:g} s on",
                       end_key, end.end, end.start),
           "Raise time.end, or lower the dwell");
  return end;
}

// Refuses a depth of the cut that no run can reach.
void refuse_beyond_thickness(const Asked& asked, const Condition& condition) {
  const auto& workpiece = asked.description.workpiece;
  const bool is_depth = condition.metric == "kerf.depth" || condition.metric == "front_depth";
  if (!workpiece || !is_depth || !condition.at_least || condition.bound <= workpiece->size[1])
    return;
  refuse(asked,
         fmt::format("--where \"{}\" wants more than the thickness of the workpiece. Allowed: at "
                     "most {:g} mm",
                     asked.question.where, 1e3 * workpiece->size[1]),
         "State a smaller depth, or leave out --where to ask for cut-through");
}

ThresholdGoal goal_of(const Asked& asked, const LimitPlan& plan, Axis axis) {
  const LimitQuestion& question = asked.question;
  constexpr int converged_layouts = 3;
  ThresholdGoal goal;
  goal.least = is_least(asked, axis.name());
  if (!question.where.empty())
    goal.condition = read_where(question.where, asked.description.dimension);
  else if (stands_for_traverse(asked.description))
    goal.condition = {std::string(certain_feed), asked.description.machine->traverse_speed, true};
  else if (travels(asked.description))
    goal.condition = {"kerf.through_share", 0.95, true};
  refuse_beyond_thickness(asked, goal.condition);
  goal.tolerance = question.tolerance;
  goal.most_runs = question.most_runs;
  goal.draft =
      question.converge ? 1.0 / draft_ratio(refined(asked.description, question.refinement)) : 1.0;
  const int asked_layouts =
      question.layouts > 0 ? question.layouts : (question.converge ? converged_layouts : 1);
  goal.repeats = has_other_layouts(asked.description) ? asked_layouts : 1;
  goal.start = std::clamp(plan.stated, axis.values.front(), axis.values.back());
  goal.axis = std::move(axis);
  return goal;
}

}  // namespace

const std::vector<LimitQuantity>& limit_quantities() {
  static const std::vector<LimitQuantity> all{
      {"feed", "machine.traverse_speed", "traverse", false, "greatest traverse speed that cuts"},
      {"pressure", "machine.pressure", "", true, "least pump pressure that cuts"},
      {"jet_speed", "", "speed", true, "least jet speed that cuts"},
      {"orifice", "machine.orifice_diameter", "", true, "least orifice diameter that cuts"},
      {"jet_width", "", "width", true, "least width of a plane jet that cuts"},
      {"standoff", "machine.standoff", "", false, "greatest standoff that cuts"}};
  return all;
}

LimitPlan plan_limit(const std::filesystem::path& case_file, const LimitQuestion& question) {
  const std::string text = read_file(case_file);
  const Asked asked{question, case_file.string(), parse_case(text, case_file.string())};
  LimitPlan plan;
  plan.quantity = question.of;
  plan.is_own_range = question.from.empty() && question.to.empty();
  plan.study = plan_of_case(case_file, text, asked.description);
  StudyPlan& study = plan.study;
  study.refinement = question.refinement;
  Axis axis = axis_of(asked, study.base, plan.stated);
  const bool is_feed = find_quantity(question.of) && question.of == "feed";
  plan.end = end_of(asked, study.base, is_feed);
  if (travels(asked.description)) plan.feed = traverse_speed(asked.description.jets.front());
  hold_motion(asked.description, study.base);
  drop_output_times(study.base);
  const KeyPath end_path = find_key_path(std::string(end_key), study.base);
  if (!plan.end.follows) set_number(study.base, end_path, plan.end.end);
  plan.by_exposure = is_feed && stands_for_traverse(asked.description);
  if (plan.by_exposure) plan.jet_speed = asked.description.jets.back().speed;
  if (plan.end.path > 0.0) {
    Axis end;
    end.path = end_path;
    end.shown_unit = "ms";
    study.axes.push_back(std::move(end));
  }
  study.threshold = goal_of(asked, plan, std::move(axis));
  study.repeats = study.threshold->repeats;
  plan.held = held_in(plan, asked.description);
  return plan;
}

Trial with_end(const LimitPlan& plan, Trial trial) {
  if (plan.end.path > 0.0) {
    const double speed = trial.setting.numbers.at(plan.study.threshold->axis.name());
    trial.setting.numbers[std::string(end_key)] = plan.end.at(speed);
  }
  return trial;
}

}  // namespace kerf
