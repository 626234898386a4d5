// SPDX-License-Identifier: Apache-2.0
// Pulsed jets carry the mass and momentum of the stated flow at any frequency.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "geometry/nozzle.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

Jet pulsed_jet(double frequency, double duty) {
  Jet jet;
  jet.speed = 10.0;
  jet.width = 4e-3;
  jet.spacing = 1e-3;
  jet.standoff = 20e-3;
  jet.stop = std::numeric_limits<double>::infinity();
  jet.pulse_frequency = frequency;
  jet.duty = duty;
  return jet;
}

// From pulses of many spacings to those of a millionth of one.
std::vector<Jet> jets() {
  std::vector<Jet> all;
  for (const double frequency : {130.0, 1e3, 7.3e3, 2e4, 5e4, 2.1e5, 1e6, 1e9})
    for (const double duty : {0.1, 0.37, 0.5, 0.9, 0.98})
      all.push_back(pulsed_jet(frequency, duty));
  return all;
}

// Layer n leaves the nozzle when the water has come (n + 1/2) spacings. Its particles have the mean
// speed of the step in which they leave, which is the full one if the nozzle is open throughout.
TEST(ShortPulses, EveryLayerLeavesAtFullSpeed) {
  for (const Jet& jet : jets()) {
    const Nozzle nozzle(jet, 1000.0, 2);
    const double step = 0.1234 * jet.spacing / jet.speed;
    int layers = 0;
    for (double time = 0.0; layers < 40 && time < 1.0; time += step) {
      const double from = nozzle.travelled(0, time), to = nozzle.travelled(0, time + step);
      const double next = (layers + 0.5) * jet.spacing;
      if (!(from < next && next <= to)) continue;
      ++layers;
      EXPECT_NEAR((to - from) / step, jet.speed, 1e-6 * jet.speed)
          << jet.pulse_frequency << " Hz, duty " << jet.duty << ", layer " << layers;
    }
    EXPECT_EQ(layers, 40);
  }
}

// The water that has flowed is that of the duty to a layer and a pulse: of the slug that the
// particles hold, not more than the pulses in it.
TEST(ShortPulses, TheMeanFlowIsThatOfTheDuty) {
  for (const Jet& jet : jets()) {
    const Nozzle nozzle(jet, 1000.0, 2);
    const double period = slugs_of(jet).period;
    for (const double periods : {3.0, 50.0, 1234.0}) {
      const double time = periods * period;
      EXPECT_NEAR(nozzle.travelled(0, time), jet.duty * jet.speed * time,
                  1.01 * jet.spacing + 1e-9 * jet.speed * time)
          << jet.pulse_frequency << " Hz, duty " << jet.duty;
    }
  }
}

// Water that enters while its nozzle is shut would have no energy yet.
TEST(ShortPulses, WaterEntersWhileItFlows) {
  for (const Jet& jet : jets()) {
    Nozzle nozzle(jet, 1000.0, 2);
    const double step = 0.37 * jet.spacing / jet.speed;
    std::size_t entered = 0;
    for (int n = 0; n < 20000; ++n) {
      const std::size_t now = nozzle.emit(n * step).size();
      entered += now;
      if (now > 0) {
        EXPECT_TRUE(nozzle.is_open(n * step)) << jet.pulse_frequency << " Hz, duty " << jet.duty;
      }
    }
    EXPECT_GT(entered, 0u);
    EXPECT_NEAR(nozzle.mass_emitted(), nozzle.mass_due(19999 * step), 2.0 * 1000.0 * 4e-6);
  }
}

// The pulses of a frequency are 10 m/s x duty / frequency long: 5 mm at 1 kHz, 0.1 mm at 50 kHz,
// of which 20 make two layers of 1 mm. A duty of 0.98 leaves gaps of 0.2 mm at 1 kHz.
TEST(ShortPulses, AsManyAreMergedAsTheSpacingNeeds) {
  for (const auto& [frequency, duty, merged] : {std::tuple{1e3, 0.5, 1.0},
                                                {2e3, 0.4, 1.0},
                                                {2e3, 0.39, 2.0},
                                                {5e4, 0.5, 20.0},
                                                {1e3, 0.98, 5.0}}) {
    const Jet jet = pulsed_jet(frequency, duty);
    const Slugs slugs = slugs_of(jet);
    EXPECT_EQ(slugs.merged, merged) << frequency << " Hz, duty " << duty;
    EXPECT_NEAR(slugs.period, merged / frequency, 1e-12 / frequency);
    EXPECT_NEAR(slugs.layers, duty * 10.0 * slugs.period / 1e-3, 1e-9);
    Jet resolved = jet;
    resolved.spacing = pulse_spacing(jet);
    EXPECT_EQ(slugs_of(resolved).merged, 1.0);
    resolved.spacing *= 1.01;
    EXPECT_GT(slugs_of(resolved).merged, 1.0);
  }
  EXPECT_EQ(slugs_of(pulsed_jet(0.0, 0.5)).period, 0.0);
  EXPECT_EQ(slugs_of(pulsed_jet(1e3, 1.0)).period, 0.0);
}

}  // namespace
}  // namespace kerf
