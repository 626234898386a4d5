// SPDX-License-Identifier: Apache-2.0
#include "output/balance_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace kerf {
namespace {

constexpr double small_drift = 0.02;        // of all energy that ever came in
constexpr double small_density_loss = 0.1;  // likewise

ValidityFlag::State good_where(bool good) {
  return good ? ValidityFlag::State::good : ValidityFlag::State::warning;
}

ValidityFlag drift_flag(const Balance& balance) {
  if (!(balance.energy_supplied() > 0.0)) {
    const bool good = balance.energy_is_sound();
    return {"energy_drift",
            good_where(good),
            {},
            small_drift,
            good ? "No energy was supplied with which the energy balance could be compared."
                 : fmt::format("There is an energy of {:.2g} J although none was supplied: trust "
                               "trends only.",
                               balance.energy_total())};
  }
  const double drift = balance.energy_drift(), percent = 100.0 * std::abs(drift);
  const bool good = std::abs(drift) <= small_drift;
  return {"energy_drift", good_where(good), drift, small_drift,
          good ? fmt::format("The energy balance closes to {:.2g}%.", percent)
               : fmt::format("The energy balance is off by {:.2g}%, more than {:g}%: trust trends "
                             "only.",
                             percent, 100.0 * small_drift)};
}

// For solids with bonds, whose breaks may only take energy (solid/limit_break_energy.hpp).
ValidityFlag break_flag(double gain) {
  const bool good = gain <= small_drift;
  return {
      "energy_from_breaks", good_where(good), gain, small_drift,
      good ? fmt::format("Breaks add {:.2g}% of all energy.", 100.0 * gain)
           : fmt::format("Breaks add {:.2g}% of all energy, more than {:g}%, where they "
                         "should dissipate some: fragments and debris may be too fast, and the cut "
                         "too easy.",
                         100.0 * gain, 100.0 * small_drift)};
}

// Whether an energy is small beside that of a motion at the speed for which the sound speed of the
// water was made: a tenth of it. Water that settles gets little energy, of which any share is
// small.
bool is_little(double energy, const Balance& balance, const Case& description) {
  constexpr double speed_over_sound = 0.1, small_speed = 0.05;
  double slowest = std::numeric_limits<double>::infinity();  // m/s, sound speed
  for (const Material& material : description.materials)
    if (material.kind == MaterialKind::water) slowest = std::min(slowest, material.sound_speed);
  const double speed = small_speed * speed_over_sound * slowest;
  return std::isfinite(slowest) && std::abs(energy) < 0.5 * balance.mass_now * speed * speed;
}

// What has a density that is smoothed: water, debris, and solids that are nearly incompressible.
struct SmoothedMatter {
  const char* named;   // as the subject of a sentence
  const char* remedy;  // a sentence
};
SmoothedMatter smoothed_matter(const Case& description) {
  const auto has = [&](MaterialKind kind) {
    return std::any_of(description.materials.begin(), description.materials.end(),
                       [&](const Material& material) { return material.kind == kind; });
  };
  if (!has(MaterialKind::elastic)) return {"the water", "Use a finer spacing."};
  if (!has(MaterialKind::water))
    return {"debris and nearly incompressible solids",
            "Give the solids more artificial_linear, or use a finer spacing."};
  return {"the water or the debris",
          "Use a finer spacing; where debris is jammed, give its solid more artificial_linear."};
}

// For the standard formulation. Smoothing of the density may take energy, and add none.
ValidityFlag density_flag(const Balance& balance, const Case& description) {
  const double loss = balance.density_loss();
  if (is_little(loss * balance.energy_supplied(), balance, description))
    return {"density_loss", ValidityFlag::State::good, loss, small_density_loss,
            fmt::format("Smoothing of the density {} {:.2g}% of the little energy that came in.",
                        loss < 0.0 ? "adds" : "takes", 100.0 * std::abs(loss))};
  const bool adds = loss < -small_drift, good = !adds && loss <= small_density_loss;
  const double limit = adds ? -small_drift : small_density_loss;
  const std::string takes = fmt::format("Smoothing of the density {} {:.2g}% of all energy",
                                        loss < 0.0 ? "adds" : "takes", 100.0 * std::abs(loss));
  const SmoothedMatter matter = smoothed_matter(description);
  return {"density_loss", good_where(good), loss, limit,
          good ? takes + "."
               : fmt::format("{}, more than {:g}%: {} may be too {}. {}", takes,
                             100.0 * std::abs(limit), matter.named, adds ? "fast" : "slow",
                             matter.remedy)};
}

}  // namespace

void add_balance_flags(const Balance& balance, const Case& description,
                       std::vector<ValidityFlag>& flags) {
  flags.push_back(drift_flag(balance));
  if (balance.density_loss() != 0.0) flags.push_back(density_flag(balance, description));
  if (balance.dissipated_fracture != 0.0) flags.push_back(break_flag(balance.energy_from_breaks()));
}

}  // namespace kerf
