// SPDX-License-Identifier: Apache-2.0
// A brittle crack starts at the fracture energy and keeps its plane whatever the angle of the
// lattice, its spacing and its position (fracture/brittle_band.hpp).
#include <gtest/gtest.h>

#include <cstdio>

#include "fracture/brittle_band.hpp"
#include "support/turned_strip.hpp"

namespace kerf::test {
namespace {

constexpr double fracture_energy = 0.35;  // J/m^2; the strip is strained by 2%

Medium<double> brittle_solid(double spacing) {
  auto medium = soft_solid(spacing, 2);
  const auto limits = BrittleBand<double>::limits(
      {{medium.bulk_modulus, medium.shear_modulus}, 0.0, fracture_energy, spacing});
  medium.softening_strain = limits.start;
  medium.failure_strain = limits.end;
  medium.criterion = BondCriterion::brittle_band;
  medium.artificial_linear = 0.5;
  return medium;
}

GrownCrack crack_of(const StripChoice& choice, double share) {
  const auto crack =
      TurnedStrip(choice, brittle_solid(choice.spacing)).load(share * fracture_energy);
  std::printf(
      "notch at %g degrees, spacing %g mm, shift %g, %s, jitter %g: at %g Gc %.1f mm, %.1f deg\n",
      choice.angle, 1e3 * choice.spacing, choice.shift, choice.is_mirrored ? "mirrored" : "as is",
      choice.jitter, share, 1e3 * crack.length, crack.angle);
  return crack;
}

// Lattice rows are at 0 degrees, diagonals at 45; others in between.
TEST(CrackDirection, StartsAtTheFractureEnergyAndKeepsItsPlane) {
  for (const StripChoice& choice :
       {StripChoice{.angle = 0.0}, StripChoice{.angle = 15.0, .shift = 0.5},
        StripChoice{.angle = 30.0, .is_mirrored = true}, StripChoice{.angle = 45.0, .shift = 0.2},
        StripChoice{.angle = 30.0, .spacing = 2e-3 / 3.0}}) {
    EXPECT_LT(crack_of(choice, 0.9).length, 2.0 * choice.spacing);
    const auto crack = crack_of(choice, 1.1);
    EXPECT_GT(crack.length, 0.5 * choice.height);
    EXPECT_LT(std::abs(crack.angle), 5.0);
  }
}

}  // namespace
}  // namespace kerf::test
