// SPDX-License-Identifier: Apache-2.0
// The energy of a crack per area is that of the material (fracture/crack_band.hpp).
#include "fracture/crack_band.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "support/notched_strip.hpp"

namespace kerf::test {
namespace {

// A notch at half height, from the left to the middle of a strip 80 mm wide and 20 mm high.
struct NotchToTheMiddle {
  KERF_FUNCTION bool operator()(const Vector<2, double>& a, const Vector<2, double>& b) const {
    return a[0] < 40e-3 && b[0] < 40e-3 && (a[1] < 10e-3) != (b[1] < 10e-3);
  }
};

// With the failure strain that follows from an energy per area of crack, a strip that is pulled in
// two releases that energy by its bonds at any spacing (more than half of it; the rest goes into
// waves).
TEST(CrackBand, EnergyPerAreaDoesNotDependOnSpacing) {
  const double energy = 2.0;  // J/m^2
  double area_energy[2];
  for (int fine : {0, 1}) {
    const double spacing = fine ? 0.625e-3 : 1.25e-3;
    const auto medium = soft_solid(spacing, 2);
    const double limit =
        failure_strain_of(energy, medium.bulk_modulus, medium.shear_modulus, spacing);
    auto trial = notched_strip<Mixed>(spacing, limit);
    area_energy[fine] = pull(trial, 0.03, 0.03) / 20e-3;
    std::printf("strip in two, spacing %g mm: limit %.3f, %.3f J/m^2 of %.3f\n", 1e3 * spacing,
                limit, area_energy[fine], energy);
    EXPECT_GT(area_energy[fine], 0.5 * energy);
    EXPECT_LT(area_energy[fine], energy);
  }
  EXPECT_NEAR(area_energy[0], area_energy[1], 0.1 * area_energy[1]);
}

// A wide strip is clamped above and below and has a long notch at half height: a running crack
// releases W H per area (Rivlin & Thomas, J. Polym. Sci. 10 (1953) 291), with W the energy stored
// per volume far ahead and H the height. Returns the available energy when the first bond breaks,
// J/m^2.
double tears_at(const Medium<double>& medium, double jitter, double energy) {
  const double spacing = medium.spacing;
  const int wide = static_cast<int>(std::lround(80e-3 / spacing));
  const int high = static_cast<int>(std::lround(20e-3 / spacing));
  auto brittle = medium;
  brittle.artificial_linear = 0.5;
  brittle.failure_strain =
      failure_strain_of(energy, medium.bulk_modulus, medium.shear_modulus, spacing);
  SolidOnTrial<2, Mixed> trial(
      block<2>({.cells = {wide, high, 1}, .spacing = spacing, .jitter = jitter}, brittle));
  trial.solid.cut(NotchToTheMiddle{});
  const double speed = 0.01, dt = pulling_step(trial);
  double has_broken_bonds = 0.0;
  trial.evaluate();
  for (double t = 0.0; t < 1.0 && has_broken_bonds == 0.0; t += dt)
    if (pull_once(trial, speed, dt).bonds > 0) has_broken_bonds = t;
  // The strain is between the clamped rows, without strain along the strip.
  const double height = 16e-3 + spacing, strain = 2.0 * speed * has_broken_bonds / height;
  const double modulus = medium.bulk_modulus + 4.0 / 3.0 * medium.shear_modulus;
  return 0.5 * modulus * strain * strain * height;
}
// The factor of crack_band.hpp is one number for all these cases; coarser strips are not wide
// enough.
TEST(CrackBand, WideStripBreaksAtTheCriticalStrain) {
  struct Strip {
    double spacing, jitter, poisson_ratio, energy;
    BondCriterion criterion = BondCriterion::principal_strain;
  };
  constexpr auto by_energy = BondCriterion::strain_energy;
  for (const Strip& strip :
       {Strip{1e-3, 0.0, 0.3, 1.4}, Strip{1e-3, 0.15, 0.3, 1.4}, Strip{1e-3, 0.0, 0.0, 1.4},
        Strip{1e-3, 0.15, 0.0, 0.35}, Strip{1e-3, 0.0, 0.3, 1.4, by_energy},
        Strip{1e-3, 0.15, 0.3, 1.4, by_energy}, Strip{0.5e-3, 0.0, 0.3, 1.4, by_energy}}) {
    auto medium = soft_solid(strip.spacing, 2);
    medium.bulk_modulus = 1e5 / (3.0 * (1.0 - 2.0 * strip.poisson_ratio));
    medium.shear_modulus = 1e5 / (2.0 * (1.0 + strip.poisson_ratio));
    medium.criterion = strip.criterion;
    const double available = tears_at(medium, strip.jitter, strip.energy);
    std::printf("wide strip, spacing %g mm, jitter %g, nu %g, %s: tears at %.3f of Gc\n",
                1e3 * strip.spacing, strip.jitter, strip.poisson_ratio,
                std::string(word_of(strip.criterion, bond_criterion_words)).c_str(),
                available / strip.energy);
    EXPECT_NEAR(available, strip.energy, 0.12 * strip.energy);
  }
}

}  // namespace
}  // namespace kerf::test
