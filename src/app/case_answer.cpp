// SPDX-License-Identifier: Apache-2.0
#include "app/case_answer.hpp"

#include <fmt/format.h>

#include "app/case_drawing.hpp"
#include "app/case_form.hpp"
#include "app/check_json.hpp"
#include "app/command_line.hpp"
#include "input/problems.hpp"
#include "output/readable.hpp"
#include "report/html.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

Json problem_json(const FoundProblem& problem) {
  return {{"path", problem.key},  {"line", problem.line},       {"value", problem.value},
          {"what", problem.what}, {"allowed", problem.allowed}, {"remedy", problem.remedy}};
}

// Returns the numbers that decide whether to start the run, in words.
Json facts_of(const CheckedCase& checked) {
  const DerivedNumbers& numbers = checked.costed.numbers;
  const RunCost cost = run_cost(numbers, checked.costed.pace);
  Json facts = Json::array();
  const auto add = [&](const char* name, const std::string& value) {
    facts.push_back({{"name", name}, {"value", value}});
  };
  add("Run time", run_time_text(cost, checked.costed.pace));
  add("Particles at the start", html::count(static_cast<double>(numbers.particles_initial)));
  add("Particles including jet water",
      html::count(static_cast<double>(numbers.particles_expected)));
  add("Simulated time", readable(numbers.likely_end, "s"));
  add("Steps", html::count(cost.steps));
  add("Memory", fmt::format("{} of {} that are free", readable(cost.memory, "B"),
                            readable(checked.memory, "B")));
  if (numbers.jet_speed > 0.0)
    add("Fastest jet or body", fmt::format("{:.4g} m/s", numbers.jet_speed));
  if (numbers.stagnation_pressure > 0.0)
    add("Stagnation pressure", readable(numbers.stagnation_pressure, "Pa"));
  add("Regime", numbers.regime);
  return facts;
}

void add_check(Json& answer, const std::string& text, const std::string& file) {
  CheckedCase checked = checked_case(text, file);
  checked.costed.pace = typical_pace(checked.costed.description, threads_of({}));
  answer["check"] = check_object(checked);
  answer["facts"] = facts_of(checked);
  answer["drawings"] = Json::array();
  for (const CaseDrawing& drawing : draw_case(checked.costed.description))
    answer["drawings"].push_back({{"title", drawing.title}, {"svg", drawing.svg}});
}

}  // namespace

Json case_answer(const std::string& text, const std::string& file) {
  Json answer = {{"tables", nullptr}, {"problems", Json::array()}, {"check", nullptr}};
  try {
    answer["tables"] = form_tables(text);
    add_check(answer, text, file);
  } catch (const CaseError& error) {
    for (const FoundProblem& problem : error.problems())
      answer["problems"].push_back(problem_json(problem));
  } catch (const UserError& error) {
    answer["problems"].push_back(problem_json({{"", error.what(), "", ""}, 0}));
  }
  return answer;
}

}  // namespace kerf
