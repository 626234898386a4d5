// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "input/overlay.hpp"
#include "input/read.hpp"
#include "input/refine.hpp"
#include "input/units.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"
#include "verification/plan.hpp"

namespace kerf {

namespace {

std::string_view find_text(std::span<const EmbeddedText> texts, const std::string& name) {
  for (const EmbeddedText& entry : texts)
    if (entry.name == name) return entry.text;
  return {};
}

std::string as_text(const toml::node& node) {
  if (const auto text = node.value<std::string>()) return *text;
  if (const auto flag = node.value_exact<bool>()) return *flag ? "true" : "false";
  if (const auto number = node.value<double>()) return shortest(*number);
  throw std::logic_error("reference.toml: neither a text nor a number");
}

// Every key of a table that holds one value.
Parameters parameters_of(const toml::table& table, const std::string& where) {
  Parameters result(where);
  for (const auto& [key, node] : table)
    if (node.is_value()) result.set(std::string(key.str()), as_text(node));
  return result;
}

struct Sources {
  std::span<const EmbeddedText> folders;
  std::span<const EmbeddedText> templates;
};

PlannedRun read_run(const toml::table& table, const std::string& owner, const Sources& sources) {
  const Parameters keys = parameters_of(table, owner + "/reference.toml, a run");
  PlannedRun run;
  run.name = keys.text("name");
  const std::string base = keys.text("case", "case");
  std::string_view text = find_text(sources.folders, owner + "/" + base);
  if (text.empty()) text = find_text(sources.templates, base);
  if (text.empty()) keys.fail(fmt::format("run \"{}\" names no case", run.name));
  const toml::table* changes = table["override"].as_table();
  run.case_text = changes ? overlay(text, *changes) : std::string(text);
  run.refinement = keys.number("refine", "", 1.0);
  run.sample_interval = keys.number("sample", "s", 0.0);
  run.is_long = keys.text("long", "false") == "true";
  if (keys.has("picture")) run.picture_time = keys.number("picture", "s");
  if (const auto unread = keys.unread(); !unread.empty())
    keys.fail(fmt::format("unknown key \"{}\"", unread.front()));
  return run;
}

// A number, or a formula of numbers.
double evaluated(const std::string& formula) {
  return Expression(formula, {}).evaluate(0.0);
}

std::optional<double> optional_value(const Parameters& keys, const std::string& key) {
  if (!keys.has(key)) return std::nullopt;
  return evaluated(keys.text(key));
}

// "finest", "every run", or "from NAME".
std::string read_judged_from(const Check& check) {
  const std::string judge = check.parameters.text("judge", "finest"), from = "from ";
  if (judge == "finest") return "";
  if (judge == "every run") return check.runs.front();
  const std::string run = judge.starts_with(from) ? judge.substr(from.size()) : "";
  if (std::count(check.runs.begin(), check.runs.end(), run) == 0)
    check.parameters.fail(
        fmt::format("judge = \"{}\" is not \"finest\", \"every run\" or \"from\" "
                    "and one of its runs",
                    judge));
  return run;
}

// A name, or several.
std::vector<std::string> read_names(const toml::table& table, const Parameters& keys,
                                    const std::string& key) {
  const toml::array* written = table[key].as_array();
  if (written == nullptr) return {keys.text(key)};
  std::vector<std::string> names;
  for (const toml::node& name : *written) names.push_back(as_text(name));
  return names;
}

// The numbers of the runs over which the exponent is found.
std::vector<double> read_exponent_over(const toml::table& table, const Check& check) {
  const toml::array* written = table["exponent_over"].as_array();
  if (written == nullptr) return {};
  std::vector<double> numbers;
  for (const toml::node& number : *written) numbers.push_back(evaluated(as_text(number)));
  if (numbers.size() != check.runs.size() || numbers.size() < 2)
    check.parameters.fail("exponent_over has a number for each of two or more runs");
  return numbers;
}

Check read_check(const toml::table& table, const std::string& owner) {
  Check check;
  check.parameters = parameters_of(table, owner + "/reference.toml, a check");
  const Parameters& keys = check.parameters;
  check.quantity = keys.text("quantity");
  check.runs = read_names(table, keys, "runs");
  if (table.contains("relative_to")) check.relative_to = read_names(table, keys, "relative_to");
  if (table.contains("interval")) check.interval = read_names(table, keys, "interval");
  check.unit = keys.text("unit", "1");
  check.reference = optional_value(keys, "reference");
  check.tolerance = optional_value(keys, "tolerance");
  check.scatter = optional_value(keys, "scatter");
  check.at_least = optional_value(keys, "at_least");
  check.at_most = optional_value(keys, "at_most");
  check.judged_from = read_judged_from(check);
  check.exponent_over = read_exponent_over(table, check);
  check.is_calibrated = keys.text("calibrated", "false") == "true";
  check.of_mean = keys.text("mean", "false") == "true";
  check.plot = keys.text("plot", "false") == "true";
  check.source = keys.text("source");
  if (check.reference.has_value() != check.tolerance.has_value())
    keys.fail("a reference goes with a tolerance");
  if (check.scatter && !check.reference) keys.fail("a scatter goes with a reference");
  if (check.of_mean && !check.exponent_over.empty())
    keys.fail("mean and exponent_over exclude each other");
  if (!check.interval.empty() && (check.runs.size() > 1 || !check.relative_to.empty()))
    keys.fail("an interval goes with one run and without relative_to");
  return check;
}

// The moves that a case does not allow: its table [refuses], with a reason for each.
PlacementRefusals read_refusals(const toml::table& table, const std::string& owner) {
  const toml::table* written = table["refuses"].as_table();
  if (!written) return {};
  const Parameters keys = parameters_of(*written, owner + "/reference.toml, refuses");
  const PlacementRefusals refuses{keys.text("turned", ""), keys.text("mirrored", ""),
                                  keys.text("moved", ""), keys.text("standoff", "")};
  if (const auto unread = keys.unread(); !unread.empty())
    keys.fail(
        fmt::format("unknown key \"{}\"; the kinds of moves are turned, mirrored, moved and "
                    "standoff",
                    unread.front()));
  return refuses;
}

VerificationCase read_verification(const std::string& name, const Sources& sources) {
  const toml::table table = toml::parse(find_text(sources.folders, name + "/reference"));
  VerificationCase result;
  result.name = name;
  result.title = table["title"].value_or(std::string());
  for (const toml::node& node : *table["run"].as_array())
    result.runs.push_back(read_run(*node.as_table(), name, sources));
  for (const toml::node& node : *table["check"].as_array())
    result.checks.push_back(read_check(*node.as_table(), name));
  result.refuses = read_refusals(table, name);
  for (const Check& check : result.checks)
    for (const auto& runs : {check.runs, check.other_runs()})
      for (const std::string& run : runs) (void)result.run(run);
  return result;
}

}  // namespace

std::vector<std::string> Check::other_runs() const {
  std::vector<std::string> others = relative_to;
  others.insert(others.end(), interval.begin(), interval.end());
  return others;
}

bool Check::judges(const std::string& run, const std::vector<std::string>& made) const {
  if (judged_from.empty()) return run == made.back();
  const auto index_of = [this](const std::string& name) {
    return std::find(runs.begin(), runs.end(), name);
  };
  return index_of(run) >= index_of(judged_from);
}

Case PlannedRun::description() const {
  return refined(parse_case(case_text, name), refinement);
}

const PlannedRun& VerificationCase::run(const std::string& wanted) const {
  const auto found = std::find_if(runs.begin(), runs.end(),
                                  [&](const PlannedRun& run) { return run.name == wanted; });
  if (found == runs.end())
    throw std::logic_error(fmt::format("{}/reference.toml: there is no run \"{}\"", name, wanted));
  return *found;
}

bool VerificationCase::keep_runs(const std::vector<std::string>& names) {
  const auto is_kept = [&](const PlannedRun& run) {
    return std::count(names.begin(), names.end(), run.name) > 0;
  };
  if (std::none_of(runs.begin(), runs.end(), is_kept)) return false;
  for (PlannedRun& run : runs) {
    run.is_left_out = !is_kept(run);
    run.is_long = false;
  }
  return true;
}

std::vector<std::string> VerificationCase::due_runs(const Check& check, bool all) const {
  const auto is_due = [&](const std::string& wanted) {
    const PlannedRun& planned = run(wanted);
    return !planned.is_left_out && (all || !planned.is_long);
  };
  std::vector<std::string> due;
  const auto others = check.other_runs();
  if (!std::all_of(others.begin(), others.end(), is_due)) return due;
  std::copy_if(check.runs.begin(), check.runs.end(), std::back_inserter(due), is_due);
  return due;
}

std::vector<VerificationCase> read_verification_cases(std::span<const EmbeddedText> folders,
                                                      std::span<const EmbeddedText> templates) {
  constexpr std::string_view suffix = "/reference";
  std::vector<VerificationCase> cases;
  for (const EmbeddedText& entry : folders)
    if (entry.name.ends_with(suffix))
      cases.push_back(
          read_verification(std::string(entry.name.substr(0, entry.name.size() - suffix.size())),
                            {folders, templates}));
  return cases;
}

}  // namespace kerf
