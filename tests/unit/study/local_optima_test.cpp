// SPDX-License-Identifier: Apache-2.0
// Runs whose metrics differ by rounding alone are one optimum.
#include <gtest/gtest.h>

#include <cmath>

#include "study/optimum_runs.hpp"
#include "synthetic.hpp"

namespace kerf::local_optima_test {
namespace {

TEST(LocalOptima, RunsThatAreEqualButForRoundingAreOneOptimum) {
  std::vector<TriedSetting> runs;
  const double values[] = {2.0, 2.0 - 1e-8, 2.0 + 1e-8, 1.0, 2.0, 2.0, 3.0};
  for (const double value : values)
    runs.push_back({{static_cast<double>(runs.size()) / 6.0}, 1.0, value, 0.5});
  // Greatest: the plateau at 2 before the dip, and the last run; the plateau beside it is none.
  const auto greatest = local_optima(runs, false);
  ASSERT_EQ(greatest.size(), 2u);
  EXPECT_EQ(greatest[0].shares, runs[6].shares);
  EXPECT_EQ(greatest[1].shares, runs[2].shares);
  EXPECT_EQ(local_optima(runs, true).size(), 1u);
  runs[1].value = 2.0 - 1e-4;  // more than rounding
  EXPECT_EQ(local_optima(runs, false).size(), 3u);
}

TEST(LocalOptima, AConstantMetricHasNoOtherOptimum) {
  for (const char* find : {"find = \"minimum\"\n", "find = \"maximum\"\n"}) {
    const OptimumGoal goal =
        *test::plan_of(std::string("[vary]\n\"jet.jet.speed\" = { from = "
                                   "\"2 m/s\", to = \"10 m/s\" }\n[search]\n"
                                   "metric = \"kerf.thickness\"\nruns = 16\n") +
                       find)
             .optimum;
    test::SyntheticLaboratory laboratory(
        [](const Trial& trial) {
          const double rounding = 1e-8 * std::sin(1e3 * test::speed_of(trial));
          return std::map<std::string, double>{{"cut_through", 1.0},
                                               {"kerf.margin", 0.5},
                                               {"kerf.thickness", 0.02 * (1.0 + rounding)}};
        },
        2);
    const OptimumAnswer answer = find_optimum(goal, 1.0, laboratory);
    EXPECT_EQ(answer.problem, "");
    EXPECT_TRUE(answer.others.empty()) << find;
  }
}

}  // namespace
}  // namespace kerf::local_optima_test
