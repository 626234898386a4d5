// SPDX-License-Identifier: Apache-2.0
#include "study/design.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "synthetic.hpp"

namespace kerf {
namespace {

TEST(Design, AGridHasEachCombinationOnceWithTheLastKeyFastest) {
  const StudyPlan plan = test::plan_of(R"(
[vary]
"jet.jet.speed" = ["1 m/s", "2 m/s"]
"jet.jet.width" = { from = "4 mm", to = "8 mm", count = 3 }
"materials.curd.criterion" = ["crack_band", "principal_strain"]
)");
  const auto settings = settings_of(*plan.design, plan.axes);
  ASSERT_EQ(settings.size(), 12u);
  EXPECT_EQ(settings[0].words.at("materials.curd.criterion"), "crack_band");
  EXPECT_EQ(settings[1].words.at("materials.curd.criterion"), "principal_strain");
  EXPECT_EQ(settings[1].numbers, settings[0].numbers);
  EXPECT_DOUBLE_EQ(settings[2].numbers.at("jet.jet.width"), 0.006);
  EXPECT_EQ(settings[5].numbers.at("jet.jet.speed"), 1.0);
  EXPECT_EQ(settings[6].numbers.at("jet.jet.speed"), 2.0);
  std::set<std::string> seen;
  for (const Setting& setting : settings) seen.insert(show(setting, plan.axes));
  EXPECT_EQ(seen.size(), settings.size());
}

// A Latin hypercube (McKay, Beckman & Conover 1979) has one point in each of the equal parts of
// every axis.
TEST(Design, ALatinHypercubeHasOnePointInEachPart) {
  constexpr std::size_t dimensions = 4, count = 17;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = latin_hypercube(dimensions, count, seed);
    for (std::size_t d = 0; d < dimensions; ++d) {
      std::set<int> parts;
      for (const auto& point : points) parts.insert(static_cast<int>(point[d] * count));
      EXPECT_EQ(parts.size(), count);
      EXPECT_EQ(*parts.begin(), 0);
      EXPECT_EQ(*parts.rbegin(), static_cast<int>(count) - 1);
    }
  }
}

TEST(Design, LatinHypercubesOfTwoSeedsOrAxesDiffer) {
  const auto one = latin_hypercube(2, 12, 1), two = latin_hypercube(2, 12, 2);
  EXPECT_NE(one, two);
  double same = 0.0;
  for (const auto& point : one) same += std::floor(12 * point[0]) == std::floor(12 * point[1]);
  EXPECT_LT(same, 12.0);
}

// The sequence in base 2 (van der Corput's) along the first axis, and of the second direction
// number 3 along the second.
TEST(Design, SobolPointsAreThoseOfTheSequence) {
  const auto points = sobol(2, 3);
  EXPECT_EQ(points[0], (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(points[1], (std::vector<double>{0.75, 0.25}));
  EXPECT_EQ(points[2], (std::vector<double>{0.25, 0.75}));
}

TEST(Design, MoreSobolPointsKeepTheFirst) {
  const auto few = sobol(3, 8), more = sobol(3, 20);
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i], more[i]);
}

TEST(Design, RangesAreEvenInDifferencesOrInRatios) {
  const StudyPlan plan = test::plan_of(R"(
[vary]
"jet.jet.speed" = { from = "1 m/s", to = "16 m/s", count = 5, scale = "log" }
"jet.jet.width" = { from = "4 mm", to = "8 mm", count = 3 }
)");
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(plan.axes[0].values[i], std::pow(2.0, static_cast<double>(i)), 1e-12);
  Setting setting;
  plan.axes[0].put_share(0.25, setting);
  plan.axes[1].put_share(0.25, setting);
  EXPECT_NEAR(setting.numbers.at("jet.jet.speed"), 2.0, 1e-12);
  EXPECT_NEAR(setting.numbers.at("jet.jet.width"), 0.005, 1e-15);
}

}  // namespace
}  // namespace kerf
