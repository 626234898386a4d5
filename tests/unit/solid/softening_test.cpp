// SPDX-License-Identifier: Apache-2.0
// Softening over a crack band: the law, its dissipated energy, and the energy Gc of a crack.
#include "fracture/softening.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "fracture/crack_band.hpp"
#include "support/notched_strip.hpp"

namespace kerf::test {
namespace {

Medium<double> softening_solid(double spacing, int dimension, double end,
                               double poisson_ratio = 0.3) {
  auto medium = soft_solid(spacing, dimension);
  medium.bulk_modulus = 1e5 / (3.0 * (1.0 - 2.0 * poisson_ratio));
  medium.shear_modulus = 1e5 / (2.0 * (1.0 + poisson_ratio));
  medium.criterion = BondCriterion::crack_band;
  medium.softening_strain = 0.1;
  medium.failure_strain = end;
  return medium;
}

// In a tensile test of a linear solid the stress E k (1 - D) decreases along a straight line from E
// e_0 to 0 at e_f.
TEST(Softening, StressFallsAlongALine) {
  const auto solid = softening_solid(1e-3, 2, 0.4);
  EXPECT_EQ(undamaged_share(solid, 0.05), 1.0);
  EXPECT_EQ(undamaged_share(solid, 0.1), 1.0);
  EXPECT_EQ(undamaged_share(solid, 0.41), 0.0);
  for (double k : {0.12, 0.2, 0.3, 0.39})
    EXPECT_NEAR(k * undamaged_share(solid, k), 0.1 * (0.4 - k) / 0.3, 1e-15);
}

// The dissipated energy is int psi_t dD, integrated here by the trapezoidal rule.
TEST(Softening, DissipatesTheEnergyThatItRemoves) {
  const auto solid = softening_solid(1e-3, 2, 0.4);
  const auto energy = [&](double k) { return 0.5 * solid.young_modulus() * k * k; };
  double sum = 0.0, before = 0.1;
  for (int n = 1; n <= 3000; ++n) {
    const double k = 0.1 + 0.3 * n / 3000.0;
    sum += 0.5 * (energy(k) + energy(before)) *
           (undamaged_share(solid, before) - undamaged_share(solid, k));
    if (n % 1000 == 0) {
      EXPECT_NEAR(softening_loss(solid, k), sum, 1e-6 * sum) << k;
    }
    before = k;
  }
  EXPECT_NEAR(softening_loss(solid, 1.0), 0.5 * solid.young_modulus() * 0.1 * 0.4, 1e-9);
}

template <class Chosen>
struct Softened : testing::Test {};
TYPED_TEST_SUITE(Softened, DoubleOnly);

// A tensile test of small strain: k is the strain itself. The sides contract freely.
TYPED_TEST(Softened, StrainIsThatOfATensileTest) {
  constexpr int D = TypeParam::D;
  auto solid = softening_solid(1e-3, D, 0.4, D == 2 ? 0.0 : 0.3);  // 2D: plane strain
  for (auto law : {ElasticLaw::neo_hookean, ElasticLaw::st_venant_kirchhoff}) {
    solid.elasticity = law;
    auto h = Matrix<D, double>::zero();
    h(0, 0) = 1e-4;
    for (int a = 1; a < D; ++a) h(a, a) = D == 2 ? 0.0 : -0.3e-4;
    EXPECT_NEAR(tensile_strain(solid, h), 1e-4, 1e-4 * 1e-3);
    h(0, 0) = -1e-4;  // in compression the shear counts, the volume does not
    EXPECT_LT(tensile_strain(solid, h), 1e-4);
  }
}

// The remaining stress is the derivative of the remaining energy, by central differences.
template <int D>
void expect_slope(const Medium<double>& solid, const Matrix<D, double>& h) {
  const auto energy = [&](const Matrix<D, double>& at) {
    const auto green = green_strain(at);
    return energy_density(softened(solid, green, 0.3), green);
  };
  const auto green = green_strain(h);
  const auto stress = first_piola(second_piola(softened(solid, green, 0.3), green), h);
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) {
      auto up = h, down = h;
      up(a, b) += 1e-6;
      down(a, b) -= 1e-6;
      EXPECT_NEAR(stress(a, b), (energy(up) - energy(down)) / 2e-6, 1e-6 * 1e5);
    }
}
TYPED_TEST(Softened, StressIsTheSlopeOfTheEnergy) {
  constexpr int D = TypeParam::D;
  auto solid = softening_solid(1e-3, D, 0.4);
  auto h = Matrix<D, double>::zero();
  h(0, 1) = 0.05;
  h(1, 0) = -0.02;
  for (auto law : {ElasticLaw::neo_hookean, ElasticLaw::st_venant_kirchhoff})
    for (double stretch : {0.1, -0.1}) {
      solid.elasticity = law;
      h(0, 0) = stretch;
      expect_slope(solid, h);
    }
}

// Softened material carries compression undiminished; in shear and tension it carries the
// remainder.
TEST(Softening, CarriesCompressionUnreduced) {
  const auto solid = softening_solid(1e-3, 3, 0.4);
  for (double stretch : {-1e-3, 1e-3}) {
    auto h = Matrix<3, double>::zero();
    for (int a = 0; a < 3; ++a) h(a, a) = stretch;
    const auto green = green_strain(h);
    const double left = second_piola(softened(solid, green, 0.25), green)(0, 0);
    const double undamaged = second_piola(solid, green)(0, 0);
    EXPECT_NEAR(left / undamaged, stretch < 0.0 ? 1.0 : 0.25, 1e-3);
  }
}

// Notches at half height from both sides of a strip 20 mm wide and 20 mm high, with 10 mm between
// them.
struct TwoNotches {
  KERF_FUNCTION bool operator()(const Vector<2, double>& a, const Vector<2, double>& b) const {
    if ((a[1] < 10e-3) == (b[1] < 10e-3)) return false;
    return (a[0] < 5e-3 && b[0] < 5e-3) || (a[0] > 15e-3 && b[0] > 15e-3);
  }
};

// Returns the energy per area of crack of a strip that is slowly pulled in two, J/m^2. The energy
// stored in the strip is less than that of the crack, so that the crack opens no faster than the
// ends move. 10 spacings across are too few: at 2 mm the energy is 1.3 Gc.
double takes(const Medium<double>& medium, double jitter) {
  const int cells = static_cast<int>(std::lround(20e-3 / medium.spacing));
  auto damped = medium;
  damped.artificial_linear = 0.5;
  SolidOnTrial<2, Mixed> trial(
      block<2>({.cells = {cells, cells, 1}, .spacing = medium.spacing, .jitter = jitter}, damped));
  trial.solid.cut(TwoNotches{});
  const double dt = 1.5 * pulling_step(trial);
  double released = 0.0;
  trial.evaluate();
  for (double t = 0.0; t < 0.1; t += dt)
    released += pull_once(trial, 0.03, dt).released + trial.solid.keep_softening();
  return (trial.solid.softening_work() + released) / 10e-3;
}

TEST(Softening, CrackDissipatesTheFractureEnergy) {
  struct Strip {
    double spacing, jitter, poisson_ratio, energy;
  };
  for (const Strip& strip :
       {Strip{1e-3, 0.0, 0.3, 10.0}, Strip{1e-3, 0.15, 0.3, 10.0}, Strip{1e-3, 0.0, 0.0, 10.0},
        Strip{0.5e-3, 0.0, 0.3, 5.0}, Strip{1e-3, 0.0, 0.3, 5.0}, Strip{1e-3, 0.0, 0.3, 2.0},
        Strip{1e-3, 0.0, 0.3, 1.4}}) {
    const auto band = softening_law_of(strip.energy, 1e5, 0.1, strip.spacing);
    const auto medium = softening_solid(strip.spacing, 2, band.end, strip.poisson_ratio);
    const double energy = takes(medium, strip.jitter);
    std::printf("strip, spacing %g mm, jitter %g, nu %g, Gc %g, ends at %.3f: takes %.3f of Gc\n",
                1e3 * strip.spacing, strip.jitter, strip.poisson_ratio, strip.energy, band.end,
                energy / strip.energy);
    EXPECT_NEAR(energy, strip.energy, 0.1 * strip.energy);
  }
}

}  // namespace
}  // namespace kerf::test
