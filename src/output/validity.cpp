// SPDX-License-Identifier: Apache-2.0
#include "output/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/calibration_need.hpp"
#include "model/case.hpp"
#include "output/balance_flags.hpp"
#include "output/falling_jet_flag.hpp"
#include "output/fast_nozzle_flag.hpp"
#include "output/moving_workpiece_flag.hpp"
#include "output/parting_flags.hpp"
#include "output/pulse_flag.hpp"
#include "output/result.hpp"
#include "output/solid_flags.hpp"
#include "output/tension_flag.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {
namespace {

constexpr double enough_resolution = 10.0;  // particles across the jet
constexpr double weak_compression = 0.1;    // Mach number; the density then varies by about 1%
constexpr double small_leak = 0.01;         // of the jet's water that is there
constexpr double small_hourglass = 0.1;     // of the most that solids store, in that control
constexpr double notable_storage = 1e-4;    // of all energy supplied
constexpr double settled = 1e-3;            // last kinetic peak over what solids store
constexpr double rounding = 1.0 + 1e-3;

using State = ValidityFlag::State;

State good_if(bool good) {
  return good ? State::good : State::warning;
}

// With a machine a model describes the jet in air; only the last part of the standoff is simulated.
ValidityFlag standoff_flag(const Machine& machine) {
  const bool whole = machine.standoff <= machine.coherent_length;
  return {"standoff", State::note, machine.standoff, machine.coherent_length,
          whole
              ? fmt::format("The standoff of {:.3g} mm is within the {:.3g} mm over which the jet "
                            "is intact. Air is not simulated.",
                            1e3 * machine.standoff, 1e3 * machine.coherent_length)
              : fmt::format(
                    "The standoff of {:.3g} mm is beyond the {:.3g} mm over which the jet "
                    "stays intact: its width, speed and breakup at the workpiece follow a model "
                    "with a wide margin. Air is not simulated.",
                    1e3 * machine.standoff, 1e3 * machine.coherent_length)};
}

double longest_standoff(const Case& description) {
  double standoff = 0.0;
  for (const Jet& jet : description.jets) standoff = std::max(standoff, jet.standoff);
  return standoff;
}

const Material* unbreakable_material(const Case& description) {
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic || body.fixed) continue;
    const Material& material = description.materials.at(static_cast<std::size_t>(body.material));
    if (!material.can_break()) return &material;
  }
  return nullptr;
}

bool breaks_at_a_strain(const Case& description) {
  const auto breaks = [](const Material& material) {
    return material.failure_strain > 0.0 && !(material.fracture_energy > 0.0);
  };
  return std::any_of(description.materials.begin(), description.materials.end(), breaks);
}

ValidityFlag resolution_flag(double resolution) {
  const bool good = resolution * rounding >= enough_resolution;
  return {"resolution", good_if(good), resolution, enough_resolution,
          good ? fmt::format("The jet is {:.3g} particles wide.", resolution)
               : fmt::format(
                     "The jet is only {:.3g} particles wide: fewer than {:g} do not resolve it. "
                     "Halve the jet's spacing.",
                     resolution, enough_resolution)};
}

ValidityFlag mach_flag(const DerivedNumbers& derived) {
  const double mach = derived.mach;
  if (!derived.water_is_weakly_compressible)
    return {
        "mach",
        State::good,
        mach,
        {},
        fmt::format("The jet's Mach number is {:.2g} in water as stiff as its equation of state "
                    "says: the first impact peak is that of a shock.",
                    mach)};
  const bool good = mach <= weak_compression * rounding;
  return {"mach", good_if(good), mach, weak_compression,
          good ? fmt::format("The jet's Mach number is {:.2g} in water made softer than real "
                             "water: the steady pressures hold, the first impact peak is lower "
                             "than the real one.",
                             mach)
               : fmt::format("The jet's Mach number is {:.2g}, over {:g}: the water is compressed "
                             "too much. Raise its sound speed.",
                             mach, weak_compression)};
}

// The share of the hourglass control in what solids store by their bonds when this is the most:
// what is left after an impact or a slip is ringing of short waves, whatever bends. In pure bending
// with n particles across it is about 5 / n^2.
void add_of_hourglass(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  MostStored most = outcome.most_stored;
  most.observe(outcome.balance);
  if (!(most.energy > notable_storage * outcome.balance.energy_supplied())) return;
  const double share = most.hourglass / most.energy, percent = 100.0 * share;
  const bool good = share <= small_hourglass;
  flags.push_back(
      {"hourglass", good_if(good), share, small_hourglass,
       good ? fmt::format("The hourglass control holds {:.2g}% of what the solids store at most.",
                          percent)
            : fmt::format("The hourglass control holds {:.2g}% of what the solids store at most, "
                          "more than {:g}%: parts that bend have too few particles across them (a "
                          "clamped beam sags by 16 to 18% too far with 4, by 9 to 10% with 6), or "
                          "the motion is noise. With 10 or more across them the error is 5% or "
                          "less.",
                          percent, 100.0 * small_hourglass)});
}

// Whether the solids came to rest by the end of their relaxation.
void add_of_relaxation(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  const Balance& balance = outcome.balance;
  const double stored = balance.solid_energy();
  if (outcome.description.time.relax == 0.0 || !(stored > 0.0)) return;
  const double rest = balance.damping_peak / stored;
  const bool good = rest <= settled && balance.dissipated_damping > 0.0;
  flags.push_back(
      {"relaxation", good_if(good), rest, settled,
       good ? fmt::format("The solids came to rest: at its last peak their kinetic energy was "
                          "{:.2g}% of what they store.",
                          100.0 * rest)
            : fmt::format("The solids did not come to rest: at its last peak their kinetic energy "
                          "was {:.2g}% of what they store, more than {:g}%. Relax for longer.",
                          100.0 * rest, 100.0 * settled)});
}

ValidityFlag leak_flag(const Leak& leak) {
  const bool good = leak.share() <= small_leak;
  return {"leak", good_if(good), leak.share(), small_leak,
          good
              ? fmt::format("{:.2g}% of the jet's water lies inside intact solid.",
                            100.0 * leak.share())
              : fmt::format("{:.2g}% of the jet's water lies inside intact solid, more than {:g}%: "
                            "it leaked in. Give solid and water the same spacing.",
                            100.0 * leak.share(), 100.0 * small_leak)};
}

// Reflections from edges are correct for a workpiece of that size, and wrong for a part of a
// larger one.
ValidityFlag reflection_flag(const RunOutcome& outcome) {
  const double passed = outcome.time - outcome.cut.contact_time;
  const double returns = outcome.derived.reflection_time;
  const bool echoes = returns > 0.0 && passed > returns;
  return {"reflections", echoes ? State::note : State::good, std::isnan(passed) ? 0.0 : passed,
          returns > 0.0 ? std::optional<double>(returns) : std::nullopt,
          echoes
              ? fmt::format("Waves reflected by the workpiece's edges return {:.3g} ms after first "
                            "contact: the result is that of a workpiece of this size. If it is a "
                            "part of a larger one, make the edges absorbing.",
                            1e3 * returns)
              : "No wave came back from an edge of the workpiece."};
}

void add_of_jet(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  if (outcome.description.jets.empty()) return;
  flags.push_back(resolution_flag(outcome.derived.jet_resolution));
  flags.push_back(mach_flag(outcome.derived));
  if (outcome.kerf) flags.push_back(leak_flag(outcome.kerf->of<Leak>()));
  flags.push_back(reflection_flag(outcome));
}

void add_of_models(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  const Case& description = outcome.description;
  if (const auto flag = tension_flag(description)) flags.push_back(*flag);
  const auto tell = [&](const char* name, State state, const std::string& sentence) {
    flags.push_back({name, state, {}, {}, sentence});
  };
  const auto note = [&](const char* name, const std::string& sentence) {
    tell(name, State::note, sentence);
  };
  if (breaks_at_a_strain(description))
    tell("length_scale", State::warning,
         "Fracture is decided by a strain that has no length scale: the energy that cracks take "
         "depends on the spacing.");
  if (description.dimension == 2)
    note(
        "two_dimensions",
        "Two dimensions: the model is a slot of infinite depth, and water cannot escape sideways.");
  if (description.machine)
    flags.push_back(standoff_flag(*description.machine));
  else if (const double standoff = longest_standoff(description); standoff > 0.0)
    flags.push_back({"standoff",
                     State::note,
                     standoff,
                     {},
                     "Air is not simulated: the jet has no drag and no breakup."});
  if (const std::string need = calibration_need(description); !need.empty())
    flags.push_back({"uncalibrated", State::warning, {}, {}, need});
  if (description.jets.empty()) return;
  add_pulse_flag(description, flags);
  if (const auto flag = fast_nozzle_flag(description)) flags.push_back(*flag);
  if (const auto flag = falling_jet_flag(description)) flags.push_back(*flag);
  if (jets_of_whole(description) > 1)
    note("several_jets", fmt::format("The kerf is that of the first jet, {}, and so is the verdict "
                                     "unless the way of another is cut.",
                                     description.jets.front().name));
  if (const auto moves = moving_workpiece_flag(description)) flags.push_back(*moves);
  if (const Material* material = unbreakable_material(description))
    tell("unbreakable", State::warning,
         fmt::format("{} has no strength and never breaks: the jet can only dent it. Give the "
                     "material a failure_strain, fracture_energy or tensile_strength.",
                     material->name));
  note("abrasive", "Abrasive is not modelled.");
}

}  // namespace

std::string_view word_of(ValidityFlag::State state) {
  switch (state) {
    case State::good:
      return "good";
    case State::note:
      return "note";
    case State::warning:
      break;
  }
  return "warning";
}

const MetricList<ValidityFlag>& ValidityFlag::metrics() {
  using F = ValidityFlag;
  static const MetricList<F> list{
      {"name", "1", "flag", "Name of the flag.", &F::name},
      {"state", "1", "state of the flag",
       "`good` within its limit, `warning` beyond it, `note` for a limit of the model.",
       [](const F& flag) { return word_of(flag.state); }},
      {"value", "SI", "value of the flag", "Value that is compared.", &F::value},
      {"limit", "SI", "limit of the flag", "Limit of the value.", &F::limit},
      {"sentence", "1", "meaning of the flag", "What the flag says of the run.", &F::sentence}};
  return list;
}

std::vector<ValidityFlag> validity_of(const RunOutcome& outcome) {
  const DerivedNumbers& derived = outcome.derived;
  std::vector<ValidityFlag> flags;
  if (!outcome.description.jets.empty() && has_workpiece(outcome.description) &&
      !has_touched(outcome))
    flags.push_back({"not_reached", State::warning, {}, {}, untouched_sentence(outcome)});
  if (outcome.still_cutting)
    flags.push_back({"still_cutting", State::warning, {}, {}, still_cutting_sentence(outcome)});
  add_of_jet(outcome, flags);
  if (derived.solid_to_water_spacing > rounding)
    flags.push_back({"solid_spacing", State::warning, derived.solid_to_water_spacing, 1.0,
                     fmt::format("The solid's spacing is {:.3g} times the water's: water can pass "
                                 "between the solid's particles.",
                                 derived.solid_to_water_spacing)});
  add_balance_flags(outcome.balance, outcome.description, flags);
  add_of_hourglass(outcome, flags);
  add_of_relaxation(outcome, flags);
  add_parting_flags(outcome, flags);
  add_solid_flags(outcome, flags);
  add_of_models(outcome, flags);
  return flags;
}

}  // namespace kerf
