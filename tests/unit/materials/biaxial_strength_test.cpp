// SPDX-License-Identifier: Apache-2.0
// Rock that is pressed to collapse in plane strain has the strength of Mohr & Coulomb, whatever its
// dilation.
#include "support/plastic_paths.hpp"

namespace kerf::test::biaxial_strength_test {
namespace {

constexpr double cohesion = 10e6, no_cut_off = 1e12;
const ElasticModuli<double> rock = [] {
  ElasticModuli<double> solid;
  solid.bulk_modulus = 20e9;
  solid.shear_modulus = 15e9;
  return solid;
}();

// The lateral strain at which the lateral stress, which grows with it, is minus `pressure`.
double lateral_strain(const PlasticParameters<double>& law, double axial, double pressure,
                      const PlasticState<2, double>& state, double guess) {
  double low = guess - 0.01, high = guess + 0.01;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (low + high);
    const Matrix3 f = Eigen::Vector3d(std::exp(middle), std::exp(axial), 1.0).asDiagonal();
    const double stress = kirchhoff(f, advance(rock, law, gradient_of<2>(f), 0.0, state))(0, 0);
    (stress < -pressure ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The axial stress of a point in plane strain that is compressed to collapse between two sides that
// bear `pressure`.
double biaxial_strength(const PlasticParameters<double>& law, double pressure) {
  auto state = PlasticState<2, double>::virgin();
  double side = 0.0, axial_stress = 0.0;
  for (int n = 1; n <= 400; ++n) {
    const double axial = -1e-3 * n;
    side = lateral_strain(law, axial, pressure, state, side);
    const Matrix3 f = Eigen::Vector3d(std::exp(side), std::exp(axial), 1.0).asDiagonal();
    const auto result = advance(rock, law, gradient_of<2>(f), 0.0, state);
    state = result.state;
    axial_stress = kirchhoff(f, result)(1, 1);
  }
  return -axial_stress;
}

// Mohr & Coulomb's strength of a biaxial test, p N + 2 c sqrt(N), does not depend on the dilation.
// The stress out of the plane reaches its value at collapse as exp(-strain / elastic strain).
TEST(DruckerPragerPlane, BiaxialStrengthIsMohrCoulombsAtAnyDilation) {
  for (double phi : {0.1, 0.5236, 0.7854})
    for (double part : {0.0, 0.5, 1.0})
      for (double pressure : {0.0, 5e6, 40e6}) {
        PlasticParameters<double> law;
        law.law = PlasticLaw::drucker_prager;
        law.drucker_prager = DruckerPrager<double>::of(cohesion, phi, part * phi, no_cut_off,
                                                       ConeMatch::plane_strain);
        const double n = (1.0 + std::sin(phi)) / (1.0 - std::sin(phi));
        const double expected = pressure * n + 2.0 * cohesion * std::sqrt(n);
        EXPECT_NEAR(biaxial_strength(law, pressure), expected, 1e-6 * expected)
            << "friction " << phi << ", dilation " << part * phi << ", pressure " << pressure;
      }
}

}  // namespace
}  // namespace kerf::test::biaxial_strength_test
