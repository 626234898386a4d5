// SPDX-License-Identifier: Apache-2.0
#include "app/cost_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

#include "app/case_changes.hpp"
#include "core/error.hpp"
#include "input/overlay.hpp"
#include "input/read.hpp"
#include "output/readable.hpp"
#include "study/local_executor.hpp"

namespace kerf {

namespace {

constexpr double noticeable = 1.1;    // gain
constexpr double least_across = 6.0;  // particles across a jet, as in a draft in 3D

std::string as_text(const toml::table& table) {
  std::ostringstream text;
  text << table;
  return text.str();
}

// Returns the pace of a changed case: it differs as those of typical cases do.
Pace pace_of_changed(const CostedCase& costed, const Case& changed) {
  const Pace before = typical_pace(costed.description, 1), after = typical_pace(changed, 1);
  Pace pace = costed.pace;
  pace.particle_step *= after.particle_step / before.particle_step;
  pace.particle_row *= after.particle_row / before.particle_row;
  pace.rows = after.rows;
  return pace;
}

std::string changed_text(const std::string& text, const CaseChange& change) {
  const std::string base = change.to_plane ? as_text(as_plane_case(toml::parse(text))) : text;
  return overlay(base, change.changes);
}

// Returns the case with the change; nothing if the reader refuses it, or it gains nothing.
std::optional<Advice> advised(const CostedCase& costed, const CaseChange& change) {
  Advice advice;
  advice.lines = change.lines;
  advice.condition = change.condition;
  advice.before = run_cost(costed.numbers, costed.pace);
  try {
    advice.text = changed_text(costed.text, change);
    Case changed = parse_case(advice.text, costed.file, quick_look);
    if (change.ends_at > 0.0) changed.time.end = change.ends_at;
    advice.after = run_cost(derive(changed), pace_of_changed(costed, changed));
  } catch (const UserError&) {
    return {};
  } catch (const toml::parse_error&) {
    return {};
  }
  const bool gains = advice.before.seconds > noticeable * advice.after.seconds ||
                     advice.before.memory > noticeable * advice.after.memory;
  if (!gains) return {};
  return advice;
}

std::vector<CaseChange> possible_changes(const CostedCase& costed) {
  const toml::table written = toml::parse(costed.text);
  std::vector<CaseChange> changes;
  for (const auto& change :
       {draft_quality(costed.description, written),
        usual_end(costed.description, written, costed.file), shorter_path(costed.description),
        stationary_stop(costed.description), spacing_of_jet(costed.description, written),
        double_spacing(costed.description, written), smaller_piece(costed.description),
        smaller_depth(costed.description), graded_spacing(costed.description),
        symmetry_planes(costed.description), plane_case(costed.description)})
    if (change) changes.push_back(*change);
  return changes;
}

// Returns the key of a line, with its table.
std::string key_of_line(const std::string& line) {
  return line.substr(0, line.find('='));
}

// Applies one kind of change after the other, each to the case that the ones before have made.
std::optional<Advice> all_together(const CostedCase& costed) {
  CostedCase current = costed;
  Advice all;
  all.before = all.after = run_cost(costed.numbers, costed.pace);
  const auto apply = [&](const std::optional<CaseChange>& change) {
    if (!change || all.after.seconds < long_run / 6.0) return;
    const auto step = advised(current, *change);
    if (!step) return;
    current.text = step->text;
    const Case changed = parse_case(current.text, current.file, quick_look);
    current.pace = pace_of_changed(current, changed);
    current.description = changed;
    current.numbers = derive(changed);
    for (const std::string& line : step->lines) {
      std::erase_if(all.lines, [&](const std::string& before) {
        return key_of_line(before) == key_of_line(line);
      });
      all.lines.push_back(line);
    }
    all.text = step->text;
    all.after = step->after;
  };
  apply(usual_end(current.description, toml::parse(current.text), current.file));
  apply(shorter_path(current.description));
  apply(spacing_of_jet(current.description, toml::parse(current.text)));
  apply(smaller_piece(current.description));
  apply(smaller_depth(current.description));
  apply(draft_quality(current.description, toml::parse(current.text)));
  apply(graded_spacing(current.description));
  apply(plane_case(current.description));
  while (current.numbers.jet_resolution >= 2.0 * least_across && all.after.seconds > long_run) {
    const double seconds = all.after.seconds;
    apply(double_spacing(current.description, toml::parse(current.text)));
    if (all.after.seconds == seconds) break;
  }
  if (all.text.empty()) return {};
  return all;
}

// A change alone, and what it gains.
struct SingleAdvice {
  CaseChange change;
  Advice advice;
};

bool is_accepted(const std::string& text, const std::string& file) {
  try {
    parse_case(text, file, quick_look);
    return true;
  } catch (const UserError&) {
    return false;
  }
}

// Notes for each piece of advice those before it with which the reader does not accept it.
void note_alternatives(const CostedCase& costed, std::vector<SingleAdvice>& list) {
  for (std::size_t j = 1; j < list.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (!is_accepted(changed_text(list[i].advice.text, list[j].change), costed.file))
        list[j].advice.instead_of.push_back(i);
}

// Returns the places of other advice in the list, in words: "the 1st and 3rd line".
std::string places_text(const std::vector<std::size_t>& places) {
  constexpr std::array endings{"st", "nd", "rd"};
  std::vector<std::string> words;
  for (const std::size_t place : places)
    words.push_back(fmt::format("{}{}", place + 1, place < endings.size() ? endings[place] : "th"));
  const std::string last = words.back();
  words.pop_back();
  return words.empty() ? last : fmt::format("{} and {}", fmt::join(words, ", "), last);
}

std::string times(double ratio, const char* more, const char* less) {
  return ratio >= 1.0 ? fmt::format("{:.3g} times {}", ratio, more)
                      : fmt::format("{:.3g} times {}", 1.0 / ratio, less);
}

}  // namespace

std::string Advice::sentence() const {
  return fmt::format(
      "{}  # {}, {}: {}, {}{}{}", fmt::join(lines, "; "),
      times(before.particles / after.particles, "fewer particles", "more particles"),
      times(before.seconds / after.seconds, "faster", "slower"), duration_text(after.seconds),
      readable(after.memory, "B"), condition.empty() ? "" : "; " + condition,
      instead_of.empty() ? "" : fmt::format("; instead of the {} line", places_text(instead_of)));
}

std::vector<Advice> cost_advice(const CostedCase& costed) {
  std::vector<SingleAdvice> single;
  for (CaseChange& change : possible_changes(costed))
    if (auto advice = advised(costed, change))
      single.push_back({std::move(change), std::move(*advice)});
  std::sort(single.begin(), single.end(), [](const SingleAdvice& a, const SingleAdvice& b) {
    return a.advice.after.seconds < b.advice.after.seconds;
  });
  note_alternatives(costed, single);
  std::vector<Advice> list;
  for (SingleAdvice& each : single) list.push_back(std::move(each.advice));
  const auto all = all_together(costed);
  const bool is_new = all && std::none_of(list.begin(), list.end(), [&](const Advice& advice) {
                        return advice.lines == all->lines;
                      });
  if (is_new && list.size() > 1) list.push_back(*all);
  return list;
}

bool is_cheap(const RunCost& cost, double memory) {
  return cost.memory <= memory && cost.seconds <= long_run;
}

std::string advice_text(const CostedCase& costed, double memory) {
  const RunCost cost = run_cost(costed.numbers, costed.pace);
  if (is_cheap(cost, memory)) return "";
  std::string text = "\nWhat to change\n";
  if (cost.memory > memory)
    text += fmt::format("  The run does not fit into the memory of this machine, {}.\n",
                        readable(memory, "B"));
  for (const Advice& advice : cost_advice(costed))
    text += fmt::format("  - {}\n", advice.sentence());
  text +=
      "  - kerf run --device gpu  # on an NVIDIA GPU, with a Kerf that was built for it; what that "
      "gains depends on the GPU (docs/gpu.md)\n";
  return text;
}

void refuse_beyond_memory(CostedCase costed, int threads, const std::string& remedy) {
  const double memory = available_memory();
  if (costed.numbers.memory <= memory) return;
  costed.pace = typical_pace(costed.description, threads);
  throw UserError(fmt::format(
      "{}: the run needs about {} for {} particles. Allowed: at most {}, the memory of this "
      "machine that is free. Change the case, or run it with {}.\n{}",
      costed.file, readable(costed.numbers.memory, "B"), costed.numbers.particles_expected,
      readable(memory, "B"), remedy, advice_text(costed, memory)));
}

}  // namespace kerf
