// SPDX-License-Identifier: Apache-2.0
// The cut of a moving nozzle from a run with the nozzle at rest, on made-up fronts of known laws.
#include "analysis/exposure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "feeding.hpp"

namespace kerf {
namespace {

using namespace feeding;

// Where the front has passed a workpiece that is not cut, and where the jet pauses, no feed is
// told.
TEST(Exposure, NothingIsCarriedBeyondTheFarFaceNorOverPauses) {
  const auto depth = [](double t) { return 1.2 * slab_thickness * std::pow(t / 1e-4, 1e-3); };
  const auto history = front_of(depth, 1e-4);
  const auto beyond = exposure_of(feeding_case(0.5), history, summary_from()).value();
  EXPECT_TRUE(std::isnan(beyond.depth));
  EXPECT_TRUE(std::isnan(beyond.greatest_feed));
  EXPECT_FALSE(beyond.cuts());
  EXPECT_TRUE(beyond.may_cut()) << "it is not known";
  Case pulsed = feeding_case(0.5);
  pulsed.machine->pulse_frequency = 100.0;
  EXPECT_TRUE(exposure_of(pulsed, history, summary_from()).has_value());  // it never pauses
  pulsed.machine->duty = 0.1;
  EXPECT_FALSE(exposure_of(pulsed, history, summary_from()).has_value());
}

TEST(Exposure, PowerLawIsCarriedExactly) {
  for (const double n : {0.18, 0.5, 1.0}) {
    const auto depth = [n](double t) { return 1e-3 * std::pow(t / 1e-4, n); };
    const auto exposure =
        exposure_of(feeding_case(0.5), front_of(depth, 1e-4), summary_from()).value();
    EXPECT_NEAR(exposure.shortest, 2e-3, 1e-15);  // 1 mm at 0.5 m/s
    EXPECT_NEAR(exposure.longest, 6e-3, 1e-15);   // 3 mm
    EXPECT_NEAR(exposure.decades(), std::log10(60.0), 1e-6);
    EXPECT_NEAR(exposure.exponent, n, 1e-6);
    const double low = std::min(slab_thickness, depth(2e-3));
    const double high = std::min(slab_thickness, depth(6e-3));
    EXPECT_NEAR(exposure.depth_low, low, 1e-6 * low) << n;
    EXPECT_NEAR(exposure.depth_high, high, 1e-6 * high) << n;
    // The depth is the thickness after the time t with depth(t) = thickness.
    const double passage = 1e-4 * std::pow(10.0, 1.0 / n);
    EXPECT_NEAR(exposure.greatest_feed, 1e-3 / passage, 1e-5 * 1e-3 / passage);
    EXPECT_NEAR(exposure.possible_feed, 3e-3 / passage, 1e-5 * 3e-3 / passage);
    EXPECT_EQ(exposure.cuts(), n == 1.0);
  }
}

// The opening is measured at right angles to the jet; along a traverse in whose plane the jet leans
// it is longer by 1 / cos, as the extent of the jet is.
TEST(Exposure, BothAreAlongTheTraverseUnderALeaningJet) {
  const auto history = front_of([](double t) { return 10.0 * t; }, 1e-4);
  for (const double azimuth : {0.0, M_PI / 2.0}) {
    Case description = feeding_case(0.5);
    description.jets[0].angle = M_PI / 4.0;
    description.jets[0].azimuth = azimuth;
    for (const bool is_in_plane : {true, false}) {
      const double turn = is_in_plane ? azimuth : azimuth + M_PI / 2.0;
      description.machine->traverse_direction = {std::cos(turn), 0.0, std::sin(turn)};
      const auto exposure = exposure_of(description, history, summary_from()).value();
      const double stretch = is_in_plane ? std::sqrt(2.0) : 1.0;
      EXPECT_NEAR(exposure.shortest, stretch * 2e-3, 1e-9) << azimuth << is_in_plane;
      EXPECT_NEAR(exposure.longest, stretch * 6e-3, 1e-9) << azimuth << is_in_plane;
    }
  }
}

// A front of 20 m/s through a hole of 60 mm: the hole would be left at 120 m/s, and the jet is at
// 50 m/s.
TEST(Exposure, NoFeedExceedsTheSpeedOfTheJet) {
  auto history = front_of([](double t) { return 20.0 * t; }, 1e-4);
  for (CutState& state : history) state.kerf_width = 60e-3;
  Case description = feeding_case(1.0);
  description.jets[0].speed = 50.0;
  const auto carried = exposure_of(description, history, summary_from()).value();
  EXPECT_EQ(carried.possible_feed, 50.0);
  EXPECT_LT(carried.greatest_feed, 5.0);
  const double cut_time = first_contact + 90e-6;
  const auto cut = exposure_of(description, history, summary_from(cut_time)).value();
  EXPECT_EQ(cut.possible_feed, 50.0);
}

// The front jumps at first and then creeps: fits of the later parts have other exponents, and the
// front may as well have come to rest. What is not certain at a feed is not certain up to it.
TEST(Exposure, FeedsAgreeWithTheDepthsAtEachFeed) {
  const auto jump = [](double t) {
    return t < 4e-5 ? 50.0 * t : t < 7e-5 ? 2e-3 + 10.0 * (t - 4e-5) : 2.3e-3 + 60.0 * (t - 7e-5);
  };
  const auto slow = [](double t) { return 4e-3 * std::pow(t / 1e-4, 0.3); };
  for (const std::function<double(double)>& depth : {std::function<double(double)>(jump), {slow}}) {
    const auto history = front_of(depth, 1e-4);
    const auto found = exposure_of(feeding_case(0.5), history, summary_from()).value();
    EXPECT_LE(found.greatest_feed, found.possible_feed);
    for (double feed = 0.01; feed < 9.0; feed *= 1.1) {
      const auto at = exposure_of(feeding_case(feed), history, summary_from()).value();
      EXPECT_EQ(at.cuts(), feed <= found.greatest_feed) << feed;
      EXPECT_EQ(at.may_cut(), feed <= found.possible_feed) << feed;
    }
  }
  EXPECT_EQ(exposure_of(feeding_case(0.5), front_of(jump, 1e-4), summary_from())->greatest_feed,
            0.0);
}

// A front that comes to rest follows no power law: the interval says so, and holds the truth.
TEST(Exposure, IntervalHoldsAFrontThatSlowsDown) {
  const auto depth = [](double t) { return 2e-3 * (1.0 - std::exp(-t / 5e-5)); };
  const auto exposure =
      exposure_of(feeding_case(2.0), front_of(depth, 1e-4), summary_from()).value();
  EXPECT_LE(exposure.depth_low, depth(5e-4));
  EXPECT_GE(exposure.depth_high, depth(1.5e-3));
  EXPECT_GE(exposure.depth_low, depth(1e-4));
  EXPECT_FALSE(exposure.may_cut());
}

// The jet of 1 mm leaves its hole, 3 mm wide, after 75 us at 40 m/s.
TEST(Exposure, RunThatCoversTheExposureCarriesNothing) {
  const auto depth = [](double t) { return 20.0 * t; };
  const auto exposure =
      exposure_of(feeding_case(40.0), front_of(depth, 1e-4), summary_from()).value();
  EXPECT_EQ(exposure.decades(), 0.0);
  EXPECT_NEAR(exposure.depth_low, 20.0 * 25e-6, 20.0 * 0.21e-6);  // rows are 0.2 us apart
  EXPECT_NEAR(exposure.depth_high, 20.0 * 75e-6, 20.0 * 0.43e-6);
  EXPECT_TRUE(std::isnan(exposure.exponent));
}

// A slug of length L that passes through a solid without strength cuts L sqrt(rho_w / rho_s) deep:
// the jet of 200 m/s makes a front of 100 m/s, and its water of 25 us is 5 mm long.
TEST(Exposure, WaterOnItsWayGoesOnCutting) {
  std::vector<CutState> history;
  for (int k = 0; k <= 500; ++k) {
    CutState state;
    state.time = first_contact + k * 0.2e-6;
    state.front_depth = state.cut_depth = 100.0 * (state.time - first_contact);
    state.kerf_width = 1e-3;
    history.push_back(state);
  }
  const auto exposure = exposure_of(feeding_case(40.0), history, summary_from()).value();
  EXPECT_NEAR(exposure.depth_low, 5e-3, 0.01 * 5e-3);
  EXPECT_NEAR(exposure.simulated, 50e-6, 0.01 * 50e-6);
}

// Of a front that presses a dent below a cut only the cut counts, and a dent alone has no law.
TEST(Exposure, ADentIsNoDepthOfACut) {
  const auto depth = [](double t) { return 20.0 * t; };
  auto history = front_of(depth, 1e-4);
  const auto of_cut = exposure_of(feeding_case(40.0), history, summary_from()).value();
  for (CutState& state : history) state.front_depth = 3.0 * state.cut_depth;
  const auto of_dent = exposure_of(feeding_case(40.0), history, summary_from()).value();
  EXPECT_EQ(of_dent.depth_low, of_cut.depth_low);
  EXPECT_EQ(of_dent.depth_high, of_cut.depth_high);
  for (CutState& state : history) state.cut_depth = 0.0;
  EXPECT_FALSE(exposure_of(feeding_case(40.0), history, summary_from()));
}

TEST(Exposure, OthersHaveNone) {
  const auto history = front_of([](double t) { return t; }, 1e-4);
  EXPECT_FALSE(exposure_of(feeding_case(0.0), history, summary_from()));
  Case moving = feeding_case(1.0);
  moving.machine->motion = NozzleMotion::travelling;
  EXPECT_FALSE(exposure_of(moving, history, summary_from()));
  CutSummary no_contact = summary_from();
  no_contact.contact_time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(exposure_of(feeding_case(1.0), history, no_contact));
}

}  // namespace
}  // namespace kerf
