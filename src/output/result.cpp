// SPDX-License-Identifier: Apache-2.0
#include "output/result.hpp"

#include "core/version.hpp"
#include "output/kerf_result.hpp"
#include "output/ledger_table.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

void add_run(Json& result, const RunOutcome& outcome) {
  const Case& description = outcome.description;
  result["title"] = description.title;
  result["case"] = outcome.case_name;
  result["dimension"] = description.dimension;
  result["formulation"] = formulation_name(description.formulation);
  result["precision"] = description.precision == PrecisionKind::mixed ? "mixed" : "double";
  result["version"] = program_version;
  result["compiler"] = compiler_name();
  result["device"] = outcome.device;
  result["threads"] = outcome.threads;
}

// Not-a-number leaves as null: "there is none".
void add_cut(Json& result, const CutSummary& cut) {
  result["cut_through"] = cut.cut_through;
  result["cut_through_time"] = cut.cut_through ? Json(cut.cut_through_time) : Json(nullptr);
  result["cut_through_by"] =
      !cut.cut_through ? Json(nullptr) : Json(cut.severed ? "severed" : "holed");
  result["cut_through_place"] = cut.cut_through ? Json(cut.cut_through_place) : Json(nullptr);
  result["front_speed"] = cut.front_speed;
  result["front_depth"] = cut.last.front_depth;
  result["pieces"] = cut.last.pieces;
  result["fractured_fraction"] = cut.last.fractured_fraction;
  result["fractured_mass"] = cut.last.fractured_mass;
  result["fractured_width"] = cut.last.fractured_width;
  result["kerf_width"] = cut.last.kerf_width;
}

// All of them in number and mass; each by itself down to the hundredth.
void add_fragments(Json& result, const std::vector<Fragment>& fragments) {
  constexpr std::size_t most = 100;
  Json& list = result["fragments"];
  list = Json::array();
  for (const Fragment& fragment : fragments) {
    if (list.size() == most) break;
    list.push_back({{"mass", fragment.mass},
                    {"particles", fragment.particles},
                    {"centre", fragment.centre},
                    {"velocity", fragment.velocity}});
  }
  result["fragment_count"] = fragments.size();
}

void add_derived(Json& result, const DerivedNumbers& derived) {
  result["V_over_cR"] = derived.speed_over_rayleigh;
  result["V_over_cp"] = derived.speed_over_longitudinal;
  result["cauchy_number"] = derived.cauchy_number;
  result["regime"] = derived.regime;
  result["jet_speed"] = derived.jet_speed;
  result["jet_resolution"] = derived.jet_resolution;
  result["mach"] = derived.mach;
  result["solid_to_water_spacing"] = derived.solid_to_water_spacing;
  result["rayleigh_speed"] = derived.rayleigh_speed;
  result["shear_speed"] = derived.shear_speed;
  result["longitudinal_speed"] = derived.longitudinal_speed;
  result["stagnation_pressure"] = derived.stagnation_pressure;
  result["hydrodynamic_front_speed"] = derived.hydrodynamic_front_speed;
}

Json validity_json(const RunOutcome& outcome) {
  const auto number = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  Json list = Json::array();
  for (const ValidityFlag& flag : validity_of(outcome))
    list.push_back({{"name", flag.name},
                    {"state", word_of(flag.state)},
                    {"value", number(flag.value)},
                    {"limit", number(flag.limit)},
                    {"sentence", flag.sentence}});
  return list;
}

Json ledger_json(const Ledger& ledger) {
  Json json;
  for (const LedgerTerm& term : ledger_terms()) {
    if (term.scalar != nullptr)
      json[term.name] = ledger.*term.scalar;
    else
      json[term.name] = ledger.*term.vector;
  }
  return json;
}

}  // namespace

Json result_of(const RunOutcome& outcome) {
  Json result;
  result["verdict"] = verdict_of(outcome);
  add_cut(result, outcome.cut);
  add_fragments(result, outcome.cut.fragments);
  if (outcome.kerf) {
    result["kerf"] = kerf_json(*outcome.kerf, outcome.description);
    result["opening"] = shape_json(outcome.kerf->opening);
  }
  if (outcome.description.machine)
    result["machine"] = machine_json(*outcome.description.machine, outcome.description);
  add_derived(result, outcome.derived);
  result["mass_error"] = outcome.ledger.mass_error();
  result["momentum_error"] = outcome.ledger.momentum_error();
  result["energy_drift"] = outcome.ledger.energy_drift();
  result["pressure_energy_gap"] = outcome.ledger.pressure_energy_gap();
  result["end_time"] = outcome.time;
  result["steps"] = outcome.steps;
  result["particles"] = outcome.particles;
  result["pair_interactions"] = outcome.pair_interactions;
  result["wall_time"] = outcome.wall_time;
  add_run(result, outcome);
  result["validity"] = validity_json(outcome);
  result["time_step_limits"] = outcome.time_step_limits;
  result["ledger"] = ledger_json(outcome.ledger);
  result["stage_times"] = Json::object();
  for (const StageTime& stage : outcome.stage_times)
    result["stage_times"][stage.name] = stage.seconds;
  return result;
}

}  // namespace kerf
