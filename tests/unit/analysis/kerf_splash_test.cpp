// SPDX-License-Identifier: Apache-2.0
// Splash, fragments, margin, and the conditions of a case and its run.
#include <numbers>

#include "analysis/fragment_sizes.hpp"
#include "kerf_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

class SplashOf : public testing::TestWithParam<std::pair<int, double>> {
 protected:
  Case description_ = make_case(GetParam().first, GetParam().second);

  // Water beside the jet and above the block that moves away at `angle` from the face.
  void add_splash(Frame& frame, double angle, double low, double high) const {
    Frame lattice;
    lattice.dimension = frame.dimension;
    add_box(lattice, water(description_), {-30.0 * mm, low, -16.0 * mm},
            {30.0 * mm, high, 16.0 * mm});
    for (const Position& x : lattice.position) {
      const double distance = std::hypot(x[0], x[2]);
      if (distance < 10.0 * mm) continue;
      add(frame, water(description_), x);
      const double out = 3.0 * std::cos(angle) / distance;
      frame.velocity.back() = {out * x[0], 3.0 * std::sin(angle), out * x[2]};
    }
  }
  // `faces` are those of a block that is tilted about the point aimed at.
  Splash measure(Frame frame, double lean = 0.0) const {
    const double angle = GetParam().second;
    Frame initial = make_block(GetParam().first);
    for (Frame* each : {&initial, &frame}) {
      tilt(*each, angle + lean);
      for (auto& v : each->velocity) {
        const double c = std::cos(angle + lean), s = std::sin(angle + lean);
        v = {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
      }
    }
    KerfConditions conditions;
    conditions.jet_speed = 5.0;
    const CutMonitor monitor(description_, initial);
    return measure_kerf(monitor.workpiece(), frame, conditions).of<Splash>();
  }
};

TEST_P(SplashOf, AngleIsMeasuredFromTheFace) {
  for (const double lean : {0.0, 0.2}) {
    Frame frame = make_block(GetParam().first);
    add_splash(frame, 0.6, 2.0 * mm, 8.0 * mm);
    const Splash one = measure(frame, lean);
    EXPECT_NEAR(one.angle, 0.6, 1e-2);
    EXPECT_NEAR(one.spread, 0.0, 1e-3);
    add_splash(frame, 1.2, 8.0 * mm, 14.0 * mm);
    const Splash two = measure(frame, lean);
    EXPECT_NEAR(two.angle, 0.9, 1e-2);
    EXPECT_NEAR(two.spread, 0.3, 1e-2);
    EXPECT_NEAR(two.mass, 2.0 * one.mass, 1e-3 * one.mass);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      Frame jittered = frame;
      jitter(jittered, most_jitter, seed);
      const Splash same = measure(jittered, lean);
      EXPECT_NEAR(same.angle, two.angle, 0.01 * two.angle);
      EXPECT_NEAR(same.spread, two.spread, steady * two.spread);
      EXPECT_NEAR(same.mass, two.mass, steady * two.mass);
    }
  }
}

TEST_P(SplashOf, OtherWaterIsNotSplash) {
  Frame frame = make_block(GetParam().first);
  const std::size_t solids = frame.id.size();
  add_water(frame, description_, 20.0 * mm, jet_width);
  for (std::size_t row = solids; row < frame.id.size(); ++row)
    frame.velocity[row] = {0.0, 5.0, 0.0};
  add_splash(frame, -0.5, 2.0 * mm, 8.0 * mm);  // moves downwards
  add_splash(frame, 0.5, -12.0 * mm, 0.0);      // in the kerf
  const std::size_t slow = frame.id.size();
  add_splash(frame, 0.5, 8.0 * mm, 10.0 * mm);
  for (std::size_t row = slow; row < frame.id.size(); ++row)
    for (double& v : frame.velocity[row]) v *= 0.001;
  const std::size_t pool = frame.id.size();
  add_splash(frame, 0.5, 10.0 * mm, 12.0 * mm);
  for (std::size_t row = pool; row < frame.id.size(); ++row) frame.source[row] = 7;
  const Splash splash = measure(frame);
  EXPECT_EQ(splash.mass, 0.0);
  EXPECT_TRUE(std::isnan(splash.angle));
  EXPECT_TRUE(std::isnan(splash.spread));
}

INSTANTIATE_TEST_SUITE_P(Jets, SplashOf,
                         testing::Values(std::pair{2, 0.0}, std::pair{2, 0.5}, std::pair{3, 0.0},
                                         std::pair{3, -0.4}));

Fragment make_fragment(double mass, double speed) {
  Fragment fragment;
  fragment.mass = mass;
  fragment.volume = mass / 1000.0;
  fragment.particles = 1;
  fragment.velocity = {0.6 * speed, -0.8 * speed, 0.0};
  return fragment;
}

TEST(FragmentSizes, AreSharesOfTheDetachedMass) {
  std::vector<Fragment> fragments{make_fragment(40.0, 0.0), make_fragment(30.0, 1.0)};
  for (int n = 1; n <= 1000; ++n) fragments.push_back(make_fragment(1e-3 * n, 0.01 * n));
  const FragmentSizes sizes = measure_fragments(fragments, 500.0, 3);
  EXPECT_EQ(sizes.count, 1000u);
  EXPECT_DOUBLE_EQ(sizes.largest_mass, 1.0);
  EXPECT_NEAR(sizes.total_mass, 500.5, 1e-6);
  // For masses distributed uniformly from 0 to 1 the share of the mass below m is m^2.
  for (std::size_t n = 0; n < 3; ++n) {
    const double mass = std::sqrt(fragment_shares[n]);
    EXPECT_NEAR(sizes.mass[n], mass, 1e-3);
    EXPECT_NEAR(sizes.speed[n], 10.0 * mass, 1e-2);
    EXPECT_NEAR(sizes.diameter[n], std::cbrt(6e-3 * mass / std::numbers::pi), 1e-4);
  }
  const FragmentSizes flat = measure_fragments(fragments, 500.0, 2);
  EXPECT_NEAR(flat.diameter[1], std::sqrt(4e-3 * flat.mass[1] / std::numbers::pi), 1e-4);
}

TEST(FragmentSizes, OfNoneOrOneFragment) {
  EXPECT_EQ(measure_fragments({}, 1.0, 2).count, 0u);
  EXPECT_EQ(measure_fragments({make_fragment(0.06, 1.0)}, 1.0, 2).count, 0u);
  const FragmentSizes sizes = measure_fragments({make_fragment(0.05, 2.0)}, 1.0, 2);
  EXPECT_EQ(sizes.count, 1u);
  for (const double mass : sizes.mass) EXPECT_DOUBLE_EQ(mass, 0.05);
  for (const double speed : sizes.speed) EXPECT_NEAR(speed, 2.0, 1e-12);
}

TEST(Margin, IsTheRemainingShareOfTheRunOrOfTheUnbrokenThickness) {
  Carving carving;
  carving.time = 20e-3;
  carving.is_gone = [](const Position& x) {
    return std::abs(x[0]) < 6.0 * mm && x[1] > -40.0 * mm;
  };
  EXPECT_NEAR(carving.measure(0).of<CutMargin>().value, -0.2, 1e-6);
  carving.is_gone = [](const Position&) { return false; };
  EXPECT_NEAR(carving.measure(0).of<CutMargin>().value, -1.0, 1e-6);
  carving.conditions.front_depth = 2.0 * thickness;  // of a block that is displaced downwards
  EXPECT_NEAR(carving.measure(0).of<CutMargin>().value, -1.0, 1e-6);
  carving.conditions.cut_through_time = 15e-3;
  EXPECT_NEAR(carving.measure(0).of<CutMargin>().value, 0.25, 1e-12);
}

// A run that stops after its cut has the margin of one that goes on to the stated end.
TEST(Margin, DoesNotHangOnWhenARunStopsAfterItsCut) {
  Case description = make_case(2);
  description.time.end = 60e-3;
  CutSummary summary;
  summary.cut_through_time = 15e-3;
  Carving carving;
  carving.is_gone = [](const Position& x) { return std::abs(x[0]) < 6.0 * mm; };
  carving.conditions = kerf_conditions(description, summary);
  for (const double stop : {16e-3, 20e-3, 60e-3}) {
    carving.time = stop;
    EXPECT_NEAR(carving.measure(0).of<CutMargin>().value, 0.75, 1e-12) << stop;
  }
}

TEST(KerfConditionsOfACase, AreTakenFromTheFirstJetAndTheCut) {
  Case description = make_case(2);
  description.jets[0].traverse = {0.2, 0.0, 0.0};
  description.jets[0].start = 1e-3;
  description.jets[0].dwell = 2e-3;
  description.jets[0].stop = 8e-3;
  CutSummary summary;
  summary.contact_time = 3e-3;
  summary.last.time = 13e-3;
  summary.last.front_depth = 12.0 * mm;
  const KerfConditions conditions = kerf_conditions(description, summary);
  EXPECT_EQ(conditions.traverse[0], 0.2);
  EXPECT_DOUBLE_EQ(conditions.moves_from, 3e-3);
  EXPECT_EQ(conditions.jet_speed, 5.0);
  EXPECT_NEAR(conditions.on_time_factor, 0.5, 1e-12);
  EXPECT_EQ(conditions.front_depth, 12.0 * mm);
}

TEST(CutSummary, AKerfHasItsTimeOfContact) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  for (int n = 0; n < 5; ++n) {
    Frame frame = make_block(2);
    frame.time = n * 1e-3;
    add_water(frame, description, (4.0 * n - 6.0) * mm, jet_width);
    monitor.observe(frame);
    EXPECT_EQ(std::isnan(monitor.summary().contact_time), n < 2);
  }
  EXPECT_DOUBLE_EQ(monitor.summary().contact_time, 2e-3);
}

}  // namespace
}  // namespace kerf
