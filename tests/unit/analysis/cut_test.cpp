// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut.hpp"

#include <gtest/gtest.h>

#include "layout.hpp"

namespace kerf {
namespace {

using namespace layout;

TEST(KerfWidth, OfASlotIsItsWidth) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  for (const double breadth : {8.0 * mm, 12.0 * mm, 20.0 * mm}) {
    const CutState state = monitor.observe(make_cut(description, 30.0 * mm, breadth, 0.0));
    EXPECT_NEAR(state.fractured_width, breadth, 1e-5 * breadth);
    EXPECT_NEAR(state.kerf_width, breadth, 1e-5 * breadth);
  }
}

// In a strip half a jet width thick through the axis of a round hole 16 mm wide the mean chord is 2
// * integral of sqrt(R^2 - z^2) over the strip; a lattice of 2 mm resolves it in steps of 2 mm.
TEST(KerfWidth, OfARoundHoleIsItsMeanChordNearTheAxis) {
  Case description = make_case(3);
  description.machine.emplace();  // whose feed is along x
  description.machine->traverse_speed = 1.0;
  CutMonitor monitor(description, make_block(3));
  const CutState state = monitor.observe(make_cut(description, 30.0 * mm, 16.0 * mm, 0.0));
  const double radius = 8.0 * mm, half = 2.5 * mm;
  const double chord = (half * std::sqrt(radius * radius - half * half) +
                        radius * radius * std::asin(half / radius)) /
                       half;
  EXPECT_NEAR(state.fractured_width, chord, 0.05 * chord);
  EXPECT_NEAR(state.kerf_width, 16.0 * mm, 1e-5);
}

TEST(Cut, IsTouchedOnceWaterHasComeToTheWorkpiece) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  const auto touched_by = [&](double depth) {
    Frame frame = make_block(2);
    add_water(frame, description, depth, jet_width);
    return monitor.observe(frame).is_touched;
  };
  EXPECT_FALSE(touched_by(-6.0 * mm));
  EXPECT_TRUE(touched_by(0.0));
  EXPECT_TRUE(touched_by(-6.0 * mm));
}

TEST(KerfWidth, CountsAnIsolatedFractureWithItsOwnWidth) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  Frame frame = make_cut(description, 30.0 * mm, 12.0 * mm, 0.0);
  const double expected = monitor.observe(frame).fractured_width;
  change(frame, Category::fractured,
         [](const Position& x) { return x[0] > 48.0 * mm && std::abs(x[1] + 15.0 * mm) < mm; });
  // 4 mm2 in a layer of 5 mm.
  EXPECT_NEAR(monitor.observe(frame).fractured_width, expected + 0.8 * mm, 1e-8);
}

TEST(KerfWidth, IsNotReducedBySmallIntactFragments) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  Frame frame = make_cut(description, 30.0 * mm, 12.0 * mm, 0.0);
  for (std::size_t row = 0; row < frame.position.size(); ++row)
    if (std::hypot(frame.position[row][0] - 1.0 * mm, frame.position[row][1] + 15.0 * mm) < mm)
      frame.category[row] = Category::solid;
  EXPECT_NEAR(monitor.observe(frame).kerf_width, 12.0 * mm, 1e-6);
}

TEST(KerfWidth, IncludesTheGapBetweenSeparatedHalves) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  Frame frame = make_cut(description, thickness, 12.0 * mm, 0.0);
  for (std::size_t row = 0; row < frame.position.size(); ++row)
    if (frame.category[row] == Category::solid)
      frame.position[row][0] += frame.position[row][0] > 0.0 ? 3.0 * mm : -1.0 * mm;
  const CutState state = monitor.observe(frame);
  EXPECT_NEAR(state.kerf_width, 16.0 * mm, 1e-6);
  EXPECT_NEAR(state.fractured_width, 12.0 * mm, 1e-6);
}

// Water that is far below the block has an opening within it.
TEST(KerfWidth, IsThatWithinTheWorkpieceWhereTheFrontIsBelowIt) {
  const Case description = make_case(2);
  CutMonitor monitor(description, make_block(2));
  const CutState state = monitor.observe(make_cut(description, 2.5 * thickness, 12.0 * mm, 0.0));
  EXPECT_NEAR(state.front_depth, 2.5 * thickness, 2.0 * mm);
  EXPECT_NEAR(state.kerf_width, 12.0 * mm, 1e-6);
  EXPECT_NEAR(state.fractured_width, 12.0 * mm, 1e-6);
}

TEST(KerfWidth, OfATiltedCutIsMeasuredAcrossTheJet) {
  const double angle = 0.5;
  const Case description = make_case(2, angle);
  Frame initial = make_block(2);
  tilt(initial, angle);
  CutMonitor monitor(description, initial);
  Frame frame = make_cut(description, 30.0 * mm, 12.0 * mm, 0.0);
  tilt(frame, angle);
  const CutState state = monitor.observe(frame);
  EXPECT_NEAR(state.fractured_width, 12.0 * mm, 1e-5);
  EXPECT_NEAR(state.kerf_width, 12.0 * mm, 1e-5);
}

TEST(KerfWidth, ChangesLessThanFivePercentWhenTheLayoutIsJittered) {
  const Case description = make_case(2);
  const Frame regular = make_cut(description, 30.0 * mm, 20.0 * mm, 0.0);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Frame initial = make_block(2), frame = regular;
    jitter(initial, 0.1, seed);
    jitter(frame, 0.1, seed);
    CutMonitor monitor(description, initial);
    EXPECT_NEAR(monitor.observe(frame).fractured_width, 20.0 * mm, 1.0 * mm) << "seed " << seed;
  }
}

TEST(FracturedFraction, CountsFracturedAndRemovedParticles) {
  const Case description = make_case(2);
  const Frame block = make_block(2);
  CutMonitor monitor(description, block);
  const double mass = 940.0 * 0.1 * 0.05;
  Frame frame = block;
  change(frame, Category::fractured, [](const Position& x) { return x[0] > 40.0 * mm; });
  CutState state = monitor.observe(frame);
  EXPECT_NEAR(state.fractured_fraction, 0.1, 1e-6);
  EXPECT_NEAR(state.fractured_mass, 0.1 * mass, 1e-6 * mass);
  state = monitor.observe(without(frame, [](const Position& x) { return x[0] > 45.0 * mm; }));
  EXPECT_NEAR(state.fractured_fraction, 0.1, 1e-6);
}

TEST(CutMonitor, ResumedMonitorGivesTheSameMeasurements) {
  const Case description = make_case(2);
  const Frame block = make_block(2);
  CutMonitor whole(description, block), before(description, block), after(description, block);
  for (int n = 0; n < 30; ++n) {
    const Frame frame = make_cut(description, 2.0 * n * mm, 12.0 * mm, n * 1e-3);
    whole.observe(frame);
    if (n == 15) after.restore(before.history(), before.traces(), frame);
    (n < 15 ? before : after).observe(frame);
  }
  const CutSummary a = whole.summary(), b = after.summary();
  EXPECT_TRUE(a.cut_through);
  EXPECT_EQ(a.cut_through_time, b.cut_through_time);
  EXPECT_EQ(a.front_speed, b.front_speed);
  EXPECT_EQ(a.last.kerf_width, b.last.kerf_width);
  EXPECT_EQ(whole.history().size(), after.history().size());
}

TEST(CutMonitor, IsIndependentOfTheParticleOrder) {
  const Case description = make_case(2);
  const Frame frame = make_cut(description, 30.0 * mm, 12.0 * mm, 1e-3);
  const CutState a = CutMonitor(description, make_block(2)).observe(frame);
  const CutState b = CutMonitor(description, make_block(2)).observe(shuffled(frame, 5));
  EXPECT_NEAR(a.front_depth, b.front_depth, 1e-12);
  EXPECT_NEAR(a.fractured_width, b.fractured_width, 1e-9);
  EXPECT_EQ(a.kerf_width, b.kerf_width);
}

// Ids are unique, but need not be small or consecutive.
TEST(CutMonitor, AcceptsNonconsecutiveIds) {
  const Case description = make_case(2);
  Frame block = make_block(2), frame = make_cut(description, 30.0 * mm, 12.0 * mm, 1e-3);
  const CutState a = CutMonitor(description, block).observe(frame);
  for (Frame* each : {&block, &frame})
    for (std::uint32_t& id : each->id) id = std::numeric_limits<std::uint32_t>::max() - 1000u * id;
  const CutState b = CutMonitor(description, block).observe(frame);
  EXPECT_EQ(a.fractured_fraction, b.fractured_fraction);
  EXPECT_EQ(a.kerf_width, b.kerf_width);
}

void expect_no_cut(CutMonitor& monitor, const Frame& frame) {
  const CutState state = monitor.observe(frame);
  EXPECT_EQ(state.front_depth, 0.0);
  EXPECT_EQ(state.kerf_width, 0.0);
  EXPECT_EQ(state.fractured_width, 0.0);
  EXPECT_FALSE(state.cut_through);
  EXPECT_EQ(monitor.summary().front_speed, 0.0);
}

TEST(CutMonitor, WithoutAJetCountsPiecesAndFractureOnly) {
  Case description = make_case(2);
  description.jets.clear();
  Frame frame = make_block(2);
  CutMonitor monitor(description, frame);
  change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 2.0 * mm; });
  expect_no_cut(monitor, frame);
  EXPECT_EQ(monitor.summary().last.pieces, 2);
  EXPECT_NEAR(monitor.summary().last.fractured_fraction, 0.04, 1e-6);
}

TEST(CutMonitor, WithoutAWorkpieceIsZero) {
  Case description = make_case(2);
  Frame frame;
  add_water(frame, description, 30.0 * mm, jet_width);
  CutMonitor monitor(description, frame);
  expect_no_cut(monitor, frame);
  EXPECT_EQ(monitor.summary().last.pieces, 0);
  EXPECT_EQ(monitor.summary().last.fractured_fraction, 0.0);
}

TEST(CutMonitor, ABodyBesideTheJetOrBehindTheNozzleIsNoWorkpiece) {
  for (const Position shift : {Position{70.0 * mm, 0.0, 0.0}, Position{0.0, 100.0 * mm, 0.0}}) {
    const Case description = make_case(2);
    Frame frame = make_block(2);
    move(frame, [&](const Position& x) -> Position { return {x[0] + shift[0], x[1] + shift[1]}; });
    CutMonitor monitor(description, frame);
    add_water(frame, description, 30.0 * mm, jet_width);
    expect_no_cut(monitor, frame);
    EXPECT_EQ(monitor.summary().last.pieces, 0);
  }
}

TEST(CutMonitor, IsZeroBeforeTheFirstFrameAndWithoutParticles) {
  CutMonitor monitor(Case{}, Frame{});
  EXPECT_FALSE(monitor.summary().cut_through);
  expect_no_cut(monitor, Frame{});
}

}  // namespace
}  // namespace kerf
