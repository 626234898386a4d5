// SPDX-License-Identifier: Apache-2.0
// Water inside intact solid, in artificial frames.
#include "kerf_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

class LeakOf : public testing::TestWithParam<std::pair<int, double>> {
 protected:
  Leak measure(const std::function<void(Frame&, const Case&)>& add_water_to,
               const std::function<bool(const Position&)>& is_gone, unsigned seed = 0) const {
    const auto [dimension, angle] = GetParam();
    const Case description = make_case(dimension, angle);
    Frame initial = make_block(dimension);
    if (seed > 0) jitter(initial, most_jitter, seed);
    Frame frame = initial;
    change(frame, Category::fractured, is_gone);
    add_water_to(frame, description);
    tilt(initial, angle);
    tilt(frame, angle);
    const CutMonitor monitor(description, initial);
    return measure_kerf(monitor.workpiece(), frame, KerfConditions{}).of<Leak>();
  }
  static bool nothing(const Position&) { return false; }
};

TEST_P(LeakOf, WaterOnTheFaceAndInAKerfIsNotLeaked) {
  const auto on_face = [](Frame& frame, const Case& description) {
    add_box(frame, water(description), {-20.0 * mm, 0.0, -8.0 * mm},
            {20.0 * mm, 4.0 * mm, 8.0 * mm});
  };
  for (unsigned seed = 0; seed <= 5; ++seed) {
    const Leak leak = measure(on_face, nothing, seed);
    EXPECT_GT(leak.water, 0.0);
    EXPECT_EQ(leak.mass, 0.0);
    EXPECT_EQ(leak.share(), 0.0);
  }
  const double half = 2.0 * solid_spacing;
  const auto in_kerf = [half](Frame& frame, const Case& description) {
    add_box(frame, water(description), {-half, -10.0 * mm, -8.0 * mm}, {half, 0.0, 8.0 * mm});
  };
  const Leak leak = measure(in_kerf, [half](const Position& x) { return std::abs(x[0]) < half; });
  EXPECT_GT(leak.water, 0.0);
  EXPECT_EQ(leak.mass, 0.0);
}

TEST_P(LeakOf, WaterInsideTheSolidIsLeaked) {
  const auto split = [](Frame& frame, const Case& description) {
    add_box(frame, water(description), {-8.0 * mm, -12.0 * mm, -8.0 * mm},
            {8.0 * mm, -8.0 * mm, 8.0 * mm});
    add_box(frame, water(description), {-8.0 * mm, 2.0 * mm, -8.0 * mm},
            {8.0 * mm, 14.0 * mm, 8.0 * mm});
  };
  for (unsigned seed = 0; seed <= 5; ++seed)
    EXPECT_NEAR(measure(split, nothing, seed).share(), 0.25, 0.05 * 0.25);
}

INSTANTIATE_TEST_SUITE_P(Cases, LeakOf,
                         testing::Values(std::pair{2, 0.0}, std::pair{2, 0.4}, std::pair{3, 0.0},
                                         std::pair{3, 0.4}));

}  // namespace
}  // namespace kerf
