// SPDX-License-Identifier: Apache-2.0
// Nozzles that move, pulse, or are slots in 3D, against their definitions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/nozzle.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

Jet plain_jet() {
  Jet jet;
  jet.speed = 10.0;
  jet.width = 4e-3;
  jet.spacing = 1e-3;
  jet.standoff = 20e-3;
  jet.stop = std::numeric_limits<double>::infinity();
  return jet;
}

double mean_x(const std::vector<InletParticle>& water) {
  double sum = 0.0;
  for (const InletParticle& particle : water) sum += particle.position[0];
  return sum / static_cast<double>(water.size());
}

TEST(MovingNozzle, TraversesAfterItsDwell) {
  Jet jet = plain_jet();
  jet.traverse = {2.0, 0.0, 0.0};
  jet.start = 1e-3;
  jet.dwell = 3e-3;
  Nozzle nozzle(jet, 1000.0, 2);
  EXPECT_EQ(nozzle.exit(3.9e-3)[0], nozzle.exit()[0]);
  EXPECT_EQ(nozzle.velocity(3.9e-3)[0], 0.0);
  EXPECT_NEAR(nozzle.exit(9e-3)[0] - nozzle.exit()[0], 2.0 * 5e-3, 1e-15);
  EXPECT_EQ(nozzle.velocity(9e-3)[0], 2.0);
  nozzle.emit(8.9e-3);
  EXPECT_NEAR(mean_x(nozzle.emit(9e-3)), 2.0 * 5e-3,
              1e-12);  // enters at the position of the nozzle
}

TEST(MovingNozzle, PulsesEmitTheirDutyCycle) {
  for (const double duty : {0.1, 0.25, 0.5, 0.9}) {
    Jet jet = plain_jet();
    jet.pulse_frequency = 400.0;
    jet.duty = duty;
    Nozzle nozzle(jet, 1000.0, 2);
    // 20 periods hold a whole number of layers at each duty.
    EXPECT_NEAR(nozzle.open_time(20.0 / 400.0), duty * 20.0 / 400.0, 1e-15);
    EXPECT_NEAR(nozzle.open_time(0.05 / 400.0), 0.05 / 400.0,
                1e-15);  // each period begins with flow
    EXPECT_TRUE(nozzle.is_open(0.05 / 400.0));
    EXPECT_FALSE(nozzle.is_open((3.0 + duty + 0.01) / 400.0));
    // open_time is the integral of is_open.
    const int samples = 100'000;
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) sum += nozzle.is_open(0.02 * (i + 0.5) / samples) ? 1.0 : 0.0;
    EXPECT_NEAR(nozzle.open_time(0.02), 0.02 * sum / samples, 1e-6);
    nozzle.emit(0.02);
    EXPECT_NEAR(nozzle.mass_emitted(), nozzle.mass_due(0.02), 1000.0 * jet.width * jet.spacing);
  }
}

TEST(MovingNozzle, ASlotInSpaceHasItsArea) {
  Jet jet = plain_jet();
  jet.length = 9e-3;
  EXPECT_DOUBLE_EQ(nozzle_area(jet, 3), 36e-6);
  const Nozzle nozzle(jet, 1000.0, 3);
  EXPECT_EQ(nozzle.columns(), 36u);
  EXPECT_NEAR(nozzle.particle_mass() * 36.0, 1000.0 * 36e-6 * jet.spacing, 1e-15);
  double widest = 0.0, longest = 0.0;
  for (const InletParticle& particle : nozzle.standing_water()) {
    widest = std::max(widest, std::abs(particle.position[0]));
    longest = std::max(longest, std::abs(particle.position[2]));
  }
  EXPECT_NEAR(widest, 1.5e-3, 1e-15);
  EXPECT_NEAR(longest, 4e-3, 1e-15);
  jet.length = 0.0;
  EXPECT_NEAR(nozzle_area(jet, 3), 4e-6 * std::acos(-1.0), 1e-18);
}

TEST(MovingNozzle, EstimatesTheEnteringParticles) {
  Jet jet = plain_jet();
  jet.duty = 0.5;
  jet.pulse_frequency = 100.0;
  EXPECT_NEAR(entering_particles(jet, 2, 0.1), 10.0 * 4e-3 * 0.05 / 1e-6, 1e-9);
}

}  // namespace
}  // namespace kerf
