// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/result.hpp"

namespace kerf {
namespace {

constexpr double enough_resolution = 10.0;  // particles across the jet
constexpr double weak_compression = 0.1;    // Mach number; the density then varies by about 1%
constexpr double small_drift = 0.02;        // of all energy that ever came in

double thickest_standoff(const Case& description) {
  double standoff = 0.0;
  for (const Jet& jet : description.jets) standoff = std::max(standoff, jet.standoff);
  return standoff;
}

bool breaks_at_a_strain(const Case& description) {
  const auto breaks = [](const Material& material) {
    return material.failure_strain > 0.0 && !(material.fracture_energy > 0.0);
  };
  return std::any_of(description.materials.begin(), description.materials.end(), breaks);
}

std::string resolution_sentence(double resolution) {
  if (resolution >= enough_resolution)
    return fmt::format("The jet is {:.3g} particles wide.", resolution);
  return fmt::format(
      "The jet is only {:.3g} particles wide: fewer than {:g} blur it. Halve the jet's spacing.",
      resolution, enough_resolution);
}

std::string mach_sentence(const DerivedNumbers& derived) {
  const double mach = derived.mach;
  if (!derived.water_is_weakly_compressible)
    return fmt::format(
        "The jet's Mach number is {:.2g} in water that is as stiff as its equation of state says: "
        "the first impact peak is that of a shock.",
        mach);
  if (mach <= weak_compression * 1.001)
    return fmt::format(
        "The jet's Mach number is {:.2g} in water made softer than real water: the steady "
        "pressures hold, the first impact peak is lower than the real one.",
        mach);
  return fmt::format(
      "The jet's Mach number is {:.2g}, over {:g}: the water is compressed too much. Raise its "
      "sound speed.",
      mach, weak_compression);
}

std::string drift_sentence(double drift) {
  const double percent = 100.0 * std::abs(drift);
  if (std::abs(drift) <= small_drift)
    return fmt::format("The energy ledger closes to {:.2g}%.", percent);
  return fmt::format("The energy ledger is off by {:.2g}%, more than {:g}%: trust trends only.",
                     percent, 100.0 * small_drift);
}

}  // namespace

bool still_cutting(const std::vector<CutState>& history) {
  if (history.empty() || history.back().cut_through) return false;
  const double late = history.front().time + 0.9 * (history.back().time - history.front().time);
  const auto before = std::find_if(history.begin(), history.end(),
                                   [late](const CutState& state) { return state.time >= late; });
  return history.back().front_depth > before->front_depth;
}

std::vector<std::string> validity_of(const RunOutcome& outcome) {
  const Case& description = outcome.description;
  const DerivedNumbers& derived = outcome.derived;
  std::vector<std::string> sentences;
  if (outcome.still_cutting)
    sentences.push_back("The run ended while the jet was still cutting: let it run longer.");
  if (!description.jets.empty()) {
    sentences.push_back(resolution_sentence(derived.jet_resolution));
    sentences.push_back(mach_sentence(derived));
  }
  if (derived.solid_to_water_spacing > 1.0)
    sentences.push_back(
        fmt::format("The solid's spacing is {:.3g} times the water's: water can slip between the "
                    "solid's particles.",
                    derived.solid_to_water_spacing));
  sentences.push_back(drift_sentence(outcome.ledger.energy_drift()));
  if (breaks_at_a_strain(description))
    sentences.push_back(
        "Fracture is decided by a strain that has no length scale: the energy that cracks take "
        "depends on the spacing.");
  if (description.dimension == 2)
    sentences.push_back(
        "Two dimensions: everything is a slot of endless depth, and water cannot escape sideways.");
  if (thickest_standoff(description) > 0.0)
    sentences.push_back("Standoff is modelled; air drag and break-up of the jet are not.");
  if (!description.jets.empty()) sentences.push_back("Abrasive is not modelled.");
  return sentences;
}

std::string verdict_of(const RunOutcome& outcome) {
  if (outcome.description.jets.empty())
    return fmt::format("The run reached {:.4g} ms; it has no jet, so there is nothing to cut.",
                       1e3 * outcome.time);
  const double depth = 1e3 * outcome.cut.last.front_depth;
  if (!outcome.cut.cut_through)
    return fmt::format(
        "The jet does not cut through within {:.4g} ms; its front is {:.3g} mm deep.",
        1e3 * outcome.time, depth);
  const int pieces = outcome.cut.last.pieces;
  const double time = 1e3 * outcome.cut.cut_through_time;
  if (pieces == 0)
    return fmt::format(
        "The jet cuts through after {:.4g} ms; at the end no piece of the workpiece is left that "
        "is "
        "larger than 5% of it.",
        time);
  return fmt::format("The jet cuts through after {:.4g} ms; at the end the workpiece is in {} {}.",
                     time, pieces, pieces == 1 ? "piece" : "pieces");
}

}  // namespace kerf
