// SPDX-License-Identifier: Apache-2.0
// The rule of a stationary cut on made-up histories: stretches of four jet widths, largest change.
#include "analysis/stationary_cut.hpp"

#include "support/travelling.hpp"

namespace kerf::test {
namespace {

// A history of a cut whose depth and force are functions of the path x, m; lag and width are
// constant. Rows are `step` apart on the path.
template <class Depth, class Force>
std::vector<CutState> made_up(const Case& description, double length, double step,
                              const Depth& depth, const Force& force) {
  const double speed = description.jets[0].traverse[0];
  std::vector<CutState> history;
  double impulse = 0.0;
  for (double x = 0.0; x <= length * (1.0 + 1e-9); x += step) {
    CutState state;
    state.time = x / speed;
    state.wake = {depth(x), 3e-3, 5e-3};
    impulse += force(x) * step / speed;
    state.water_impulse = impulse;
    history.push_back(state);
  }
  return history;
}

TEST(StationaryCut, IsReachedWhereNothingChanges) {
  const Case c = TravellingText{}.read();
  const double w = c.jets[0].width;
  const auto steady = [](double) { return 10e-3; };
  const auto force = [](double) { return 200.0; };
  const auto soon = stationary_cut(c, made_up(c, 7.9 * w, w / 8, steady, force));
  EXPECT_FALSE(soon.reached);
  EXPECT_TRUE(std::isnan(soon.change));
  const auto cut = stationary_cut(c, made_up(c, 8.0 * w, w / 8, steady, force));
  EXPECT_TRUE(cut.reached);
  EXPECT_NEAR(cut.change, 0.0, 1e-9);
  EXPECT_NEAR(cut.travelled, 8.0 * w, 1e-9);
  EXPECT_NEAR(cut.depth, 10e-3, 1e-12);
  EXPECT_NEAR(cut.lag, 3e-3, 1e-12);
  EXPECT_NEAR(cut.width, 5e-3, 1e-12);
  EXPECT_NEAR(cut.force, 200.0, 1e-6);
}

// A depth that grows by the share g per stretch changes by g / (1 + g) of the larger mean.
TEST(StationaryCut, ComparesTheMeansOfTwoStretches) {
  Case c = TravellingText{}.read();
  const double w = c.jets[0].width, stretch = 4.0 * w;
  const auto force = [](double) { return 200.0; };
  // Linear: 20 mm in the middle of the last stretch, 19 mm in that before.
  const auto depth = [&](double x) { return 20e-3 + 1e-3 * (x - 10.5 * stretch) / stretch; };
  const auto history = made_up(c, 11.0 * stretch, w / 64, depth, force);
  const auto cut = stationary_cut(c, history);
  EXPECT_FALSE(cut.reached);
  EXPECT_NEAR(cut.change, 0.05, 0.05 * 0.02);  // rows: 1/256 of a stretch
  c.time.stop_tolerance = 0.06;
  EXPECT_TRUE(stationary_cut(c, history).reached);
  // The force: 200 N, then 190 N.
  const auto falling = [&](double x) { return x > 10.0 * stretch ? 190.0 : 200.0; };
  const auto steady = [](double) { return 20e-3; };
  const auto by_force = stationary_cut(c, made_up(c, 11.0 * stretch, w / 64, steady, falling));
  EXPECT_NEAR(by_force.change, 0.05, 1e-3);
  EXPECT_NEAR(by_force.force, 190.0, 0.1);
}

TEST(StationaryCut, IsNotReachedBeforeAnythingIsCut) {
  const Case c = TravellingText{}.read();
  const double w = c.jets[0].width;
  const auto none = [](double) { return 0.0; };
  EXPECT_FALSE(stationary_cut(c, made_up(c, 12.0 * w, w / 8, none, none)).reached);
  EXPECT_FALSE(stationary_cut(c, {}).reached);
}

}  // namespace
}  // namespace kerf::test
