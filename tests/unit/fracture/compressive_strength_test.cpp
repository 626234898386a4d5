// SPDX-License-Identifier: Apache-2.0
// The strain that drives softening in uniaxial tests of small strain, by Hooke's law.
#include "fracture/compressive_strength.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fracture/breakable_solid.hpp"

namespace kerf::test::compressive_strength_test {
namespace {

constexpr double youngs_modulus = 1e9, tensile_strain_limit = 1e-4;

// A solid whose compressive strength is `ratio` times the tensile one; 0: none is given.
BreakableSolid<double> solid_of(double poisson_ratio, double ratio) {
  BreakableSolid<double> solid;
  const auto moduli = ElasticModuli<double>::of(youngs_modulus, poisson_ratio);
  static_cast<ElasticModuli<double>&>(solid) = moduli;
  solid.elasticity = ElasticLaw::st_venant_kirchhoff;
  solid.softening_strain = tensile_strain_limit;
  if (ratio > 0.0) solid.confinement = confinement_of(moduli, ratio);
  return solid;
}

// Strains of principal stresses over E, by Hooke's law.
SymmetricTensor<3, double> strain_of(double poisson_ratio, const std::array<double, 3>& stress) {
  auto green = SymmetricTensor<3, double>::zero();
  const double sum = stress[0] + stress[1] + stress[2];
  for (int a = 0; a < 3; ++a)
    green(a, a) = (1.0 + poisson_ratio) * stress[std::size_t(a)] - poisson_ratio * sum;
  return green;
}

TEST(CompressiveStrength, IsThatOfAUniaxialTest) {
  for (const double nu : {0.0, 0.2, 0.374})
    for (const double ratio : {1.5, 8.0, 13.0}) {
      const auto solid = solid_of(nu, ratio);
      const double limit = tensile_strain_limit;
      const auto in_compression = [&](double share) {
        return tensile_strain(solid, strain_of(nu, {-share * ratio * limit, 0.0, 0.0}));
      };
      EXPECT_NEAR(in_compression(1.0), limit, 1e-3 * limit) << nu << " " << ratio;
      EXPECT_NEAR(in_compression(0.9), 0.9 * limit, 1e-3 * limit) << nu << " " << ratio;
      // In tension it changes nothing, and pressure from all sides bears on.
      EXPECT_NEAR(tensile_strain(solid, strain_of(nu, {limit, 0.0, 0.0})), limit, 1e-3 * limit);
      const double pressure = -100.0 * limit;
      EXPECT_LT(tensile_strain(solid, strain_of(nu, {pressure, pressure, pressure})), 1e-12);
    }
}

TEST(CompressiveStrength, IsThatOfShearWhereNoneIsGiven) {
  for (const double nu : {0.0, 0.2, 0.374}) {
    const double least = least_compressive_ratio(ElasticModuli<double>::of(youngs_modulus, nu));
    EXPECT_NEAR(least, std::sqrt(1.5 / (1.0 + nu)), 1e-12);
    const auto strain = strain_of(nu, {-least * tensile_strain_limit, 0.0, 0.0});
    EXPECT_NEAR(tensile_strain(solid_of(nu, 0.0), strain), tensile_strain_limit,
                1e-3 * tensile_strain_limit);
    EXPECT_NEAR(confinement_of(ElasticModuli<double>::of(youngs_modulus, nu), least), 0.0, 1e-12);
    EXPECT_EQ(confinement_of(ElasticModuli<double>::of(youngs_modulus, nu), 0.5), 0.0);
  }
}

// Tension with m times as much compression across, in plane stress, as in a disc that is split
// between two plates (m = 3): never more than the tensile strength, and as without a compressive
// strength up to m = 1.
void expect_tension_to_soften(double nu, double ratio) {
  const auto solid = solid_of(nu, ratio), unconfined = solid_of(nu, 0.0);
  double before = 0.0;  // the strain at one tensile stress, over the limit
  for (double m = 0.0; m <= 12.0; m += 0.01) {
    const auto strain = strain_of(nu, {tensile_strain_limit, -m * tensile_strain_limit, 0.0});
    const double is = tensile_strain(solid, strain) / tensile_strain_limit;
    EXPECT_GE(is, 0.999) << m;
    if (m <= 1.0) {
      EXPECT_NEAR(is, tensile_strain(unconfined, strain) / tensile_strain_limit, 1e-3) << m;
    }
    if (m > 0.0) {
      EXPECT_NEAR(is, before, 0.2) << "a jump at " << m;
    }
    // What softening takes is no more than what is stored.
    const double taken = 0.5 * youngs_modulus * std::pow(is * tensile_strain_limit, 2);
    EXPECT_GE(tensile_energy(solid, strain), taken * (1.0 - 1e-9)) << m;
    before = is;
  }
}
TEST(CompressiveStrength, LeavesTensionItsStrength) {
  for (const double nu : {0.0, 0.2, 0.374})
    for (const double ratio : {3.0, 8.0, 13.0}) {
      SCOPED_TRACE(testing::Message() << nu << ' ' << ratio);
      expect_tension_to_soften(nu, ratio);
    }
}

// Concrete that cannot spread along one direction, or along two.
TEST(CompressiveStrength, GrowsWithConfinement) {
  const double nu = 0.2, ratio = 13.0;
  const auto solid = solid_of(nu, ratio);
  const auto strength = [&](double second, double third) {
    double low = 1.0, high = 100.0;  // of f_c
    for (int n = 0; n < 60; ++n) {
      const double middle = 0.5 * (low + high), stress = -middle * ratio * tensile_strain_limit;
      const auto strain = strain_of(nu, {stress, second * stress, third * stress});
      (tensile_strain(solid, strain) < tensile_strain_limit ? low : high) = middle;
    }
    return low;
  };
  EXPECT_NEAR(strength(0.0, 0.0), 1.0, 1e-2);
  EXPECT_NEAR(strength(0.0, nu), 1.40, 0.01);
  const double side = nu / (1.0 - nu);
  EXPECT_NEAR(strength(side, side), 2.54, 0.02);
}

}  // namespace
}  // namespace kerf::test::compressive_strength_test
