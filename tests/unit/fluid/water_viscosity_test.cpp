// SPDX-License-Identifier: Apache-2.0
// The viscosity of water on a lattice against mu times the Laplacian, and beside a wall.
#include <gtest/gtest.h>

#include <numbers>

#include "support/standard_mixture.hpp"
#include "support/water_at_wall.hpp"

namespace kerf::test::water_viscosity_test {
namespace {

// A shear wave of 50 spacings in water without pressure: the sum is below the Laplacian by less
// than 0.5%, because the wave has a finite length compared with the kernel. If the viscosity
// suffices, there is no other dissipation at any speed of the wave.
void expect_viscosity_alone(double speed) {
  constexpr int cells = 61;
  constexpr double length = 50.0 * mixture_spacing, k = 2.0 * std::numbers::pi / length;
  auto state = standard_mixture(2, 1);
  state.media = {state.media[0]};
  const double mu = state.media[0].viscosity, density = state.media[0].density;
  state.particles.clear();
  for (int n = 0; n < cells * cells; ++n) {
    ReferenceParticle particle;
    particle.position = {mixture_spacing * (n % cells + 0.5), mixture_spacing * (n / cells + 0.5),
                         0.0};
    particle.velocity = {speed * std::sin(k * particle.position.y()), 0.0, 0.0};
    state.particles.push_back(particle);
  }
  LoadedStandard<2, Double> loaded(state, {0.0, cells * mixture_spacing});
  const StandardRates<2, Double> rates(Vector<2, double>::zero(), state.media,
                                       lattice_sums<2, WendlandC2<2>>(1.3));
  rates.accelerate(loaded.particles.view(), loaded.particles.size(), loaded.list.view(),
                   MixtureBonds<2, Double>{});
  const auto place = loaded.places();
  double product = 0.0, square = 0.0;
  for (std::size_t n = 0; n < state.particles.size(); ++n) {
    const auto& x = state.particles[n].position;
    if (std::abs(x.x() - 30.5e-3) > 20e-3 || std::abs(x.y() - 30.5e-3) > 25e-3) continue;
    const double due = -speed * mu / density * k * k * std::sin(k * x.y());
    const Vector<2, double> a = loaded.particles.damping_acceleration[place[n]];
    product += a[0] * due;
    square += due * due;
  }
  EXPECT_NEAR(product / square, 1.0, 0.005);
}

TEST(WaterViscosity, OfAWaveOfShear) {
  expect_viscosity_alone(1e-3);
  expect_viscosity_alone(1.0);
}

// Returns the acceleration of water, in nu S / d, whose velocity grows by S from the surface of a
// wall on (no slip): none in the continuum.
template <int D>
double in_shear(const at_wall::LinearField& given) {
  constexpr double rate = 1.0, viscosity = 0.9;
  at_wall::LinearField field = given;
  field.compression = 0.0;
  field.viscosity = viscosity;
  field.motion = rate * field.frame.col(0) * field.frame.col(1).transpose();
  const at_wall::AtWall<D, Double> water(field);
  return water.acceleration().dot(field.frame.col(0)) /
         (viscosity / at_wall::density * rate / at_wall::spacing);
}

TEST(WaterViscosity, HoldsWaterAtTheSurfaceOfAWallOfAnyAngle) {
  for (const double angle : {0.0, 0.4, 1.1})
    for (const Phase wall : {Phase::rigid, Phase::solid}) {
      at_wall::LinearField field;
      field.wall = wall;
      field.frame = at_wall::turned<2>(angle);
      EXPECT_NEAR(in_shear<2>(field), 0.0, 0.01) << angle;
      field.frame = at_wall::turned<3>(angle);
      EXPECT_NEAR(in_shear<3>(field), 0.0, 0.01) << angle;
    }
  // Walls at rest everywhere, whose faces are not known, let the water slip.
  at_wall::LinearField field;
  field.has_faces = false;
  EXPECT_GT(in_shear<2>(field), 0.1);
}

}  // namespace
}  // namespace kerf::test::water_viscosity_test
