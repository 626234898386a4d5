// SPDX-License-Identifier: Apache-2.0
#include "app/check_json.hpp"

#include "output/metric_json.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

Json cost_json(const RunCost& cost) {
  return {{"particles", cost.particles},
          {"steps", cost.steps},
          {"memory", cost.memory},
          {"particle_memory", cost.particle_memory},
          {"run_time", cost.seconds}};
}

Json advice_json(const CheckedCase& checked) {
  Json list = Json::array();
  if (is_cheap(run_cost(checked.costed.numbers, checked.costed.pace), checked.memory)) return list;
  for (const Advice& advice : cost_advice(checked.costed))
    list.push_back({{"keys", advice.lines}, {"cost", cost_json(advice.after)}});
  return list;
}

}  // namespace

Json cost_object(const DerivedNumbers& numbers, const Pace& pace) {
  Json json = {{"initial_particles", numbers.particles_initial},
               {"final_particles", numbers.particles_expected},
               {"simulated_time", numbers.likely_end},
               {"time_step", numbers.time_step / pace.step_factor}};
  json.update(cost_json(run_cost(numbers, pace)));
  json["run_time_threads"] = pace.threads;
  json["run_time_source"] = pace.source;
  return json;
}

Json check_object(const CheckedCase& checked) {
  const CostedCase& costed = checked.costed;
  Json json = {{"case", costed.file},
               {"title", costed.description.title},
               {"dimension", costed.description.dimension},
               {"simulated", checked.piece},
               {"numbers", object_of(DerivedNumbers::metrics(), costed.numbers)},
               {"cost", cost_object(costed.numbers, costed.pace)},
               {"advice", advice_json(checked)},
               {"warnings", checked.warnings}};
  if (checked.ranks) json["ranks"] = checked.ranks->json();
  return json;
}

std::string check_json(const CheckedCase& checked) {
  return check_object(checked).dump(2) + "\n";
}

}  // namespace kerf
