// SPDX-License-Identifier: Apache-2.0
// The times at which a run observes its cut.
#include <gtest/gtest.h>

#include "analysis/observation_times.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

Case with_jet(double spacing, double metres_per_second) {
  Case description;
  Jet jet;
  jet.spacing = spacing;
  jet.speed = metres_per_second;
  description.jets = {jet};
  return description;
}

TEST(ObservationTimes, AreAsFarApartAsTheJetPassesAQuarterOfASpacing) {
  const ObservationTimes times(with_jet(1e-3, 2.5));  // 0.1 ms
  EXPECT_TRUE(times.has_own());
  EXPECT_FALSE(times.is_due(0.099e-3, 0.0));
  EXPECT_TRUE(times.is_due(0.101e-3, 0.0));
  EXPECT_FALSE(times.is_due(1.0 + 0.9e-3, 1.0));  // a thousandth of 1 s
  EXPECT_TRUE(times.is_due(1.0 + 1.1e-3, 1.0));
}

TEST(ObservationTimes, AreCountedAsTheyCome) {
  const ObservationTimes times(with_jet(1e-3, 2.5));
  for (const double end : {0.03, 0.1, 2.0, 50.0}) {
    int count = 0;
    double last = 0.0;
    for (double now = 0.0; now < end; now += 1e-6)
      if (times.is_due(now, last)) ++count, last = now;
    EXPECT_NEAR(times.count(end), count, 0.02 * count) << end;
  }
}

TEST(ObservationTimes, OfACaseWithoutAJetAreThoseOfTheRows) {
  const ObservationTimes times{Case()};
  EXPECT_FALSE(times.has_own());
  EXPECT_FALSE(times.is_due(1.0, 0.0));
  EXPECT_EQ(times.count(1.0), 0.0);
}

}  // namespace
}  // namespace kerf
