// SPDX-License-Identifier: Apache-2.0
// The widths of an opening during the run do not hang on which axis of the case is x.
#include "analysis/opening_width.hpp"

#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "layout.hpp"

namespace kerf {
namespace {

using namespace layout;

constexpr double slot_width = 12.0 * mm, block_width = 40.0 * mm, slot_depth = 30.0 * mm;

// A block with a slot along x and water in it, or the same turned by 90 degrees about the jet.
struct Slotted {
  bool is_turned = false;
  Position traverse{};    // m/s, of the nozzle in the run
  Position feed{};        // unit, of a machine whose nozzle stands
  Position start{};       // m, where the nozzle aims at first
  bool has_bore = false;  // as laid out in place of the slot, 10 mm wide, 15 mm below the face
  double gap = 0.0;       // m, by which the halves have moved apart

  Position turned(const Position& x) const { return is_turned ? Position{x[2], x[1], -x[0]} : x; }
  Case description() const {
    Case made = make_case(3);
    made.jets[0].position = turned(start);
    made.jets[0].traverse = turned(traverse);
    if (feed == Position{}) return made;
    made.machine.emplace();
    made.machine->traverse_speed = 1.0;
    made.machine->traverse_direction = turned(feed);
    return made;
  }
  Frame block() const {
    const auto is_bore = [](const Position& x) {
      return std::hypot(x[1] + 15.0 * mm, x[2]) < 5.0 * mm;
    };
    Frame frame = make_block(3);
    if (has_bore) frame = without(frame, is_bore);
    move(frame, [&](const Position& x) { return turned(x); });
    return frame;
  }
  Frame cut(double time) const {
    Frame frame = make_block(3);
    if (has_bore) return with_water(block(), time);
    change(frame, Category::fractured, [](const Position& x) {
      return std::abs(x[2]) < slot_width / 2.0 && x[1] > -slot_depth;
    });
    for (std::size_t row = 0; row < frame.id.size(); ++row)
      frame.position[row][2] += std::copysign(gap / 2.0, frame.position[row][2]);
    move(frame, [&](const Position& x) { return turned(x); });
    return with_water(std::move(frame), time);
  }
  Frame with_water(Frame frame, double time) const {
    const Case made = description();
    Frame water;
    water.dimension = 3;
    add_water(water, made, slot_depth, jet_width);
    frame.time = time;
    const Jet& jet = made.jets[0];
    for (const Position& x : water.position)
      add(frame, layout::water(made),
          {x[0] + jet.position[0] + time * jet.traverse[0], x[1],
           x[2] + jet.position[2] + time * jet.traverse[2]});
    return frame;
  }
  CutState measure() const {
    CutMonitor monitor(description(), block());
    monitor.observe(cut(1e-3));
    return monitor.observe(cut(9e-3));
  }
};

TEST(OpeningWidth, UnderANozzleThatTravelsIsAcrossItsPath) {
  for (const bool is_turned : {false, true}) {
    const CutState state =
        Slotted{.is_turned = is_turned, .traverse = {2.0, 0.0, 0.0}, .start = {-9.0 * mm, 0.0, 0.0}}
            .measure();
    EXPECT_NEAR(state.kerf_width, slot_width, 1e-6) << is_turned;
    EXPECT_NEAR(state.fractured_width, slot_width, 1e-6) << is_turned;
  }
}

// The nozzle stands in place of one that moves along the slot, or across it.
TEST(OpeningWidth, UnderANozzleThatStandsForAFeedIsAlongIt) {
  for (const bool is_turned : {false, true}) {
    const CutState along = Slotted{.is_turned = is_turned, .feed = {1.0, 0.0, 0.0}}.measure();
    EXPECT_NEAR(along.kerf_width, block_width, 1e-6) << is_turned;
    EXPECT_NEAR(along.fractured_width, block_width, 1e-6) << is_turned;
    const CutState across =
        Slotted{.is_turned = is_turned, .feed = {0.0, 0.0, 1.0}, .gap = 12.0 * mm}.measure();
    EXPECT_NEAR(across.kerf_width, 24.0 * mm, 1e-6) << is_turned;
    EXPECT_NEAR(across.fractured_width, slot_width, 1e-6) << is_turned;
    EXPECT_NEAR(across.removed_share(), 0.5, 1e-3) << is_turned;
  }
}

// The mean over directions: a slot is 12 mm wide across and 40 mm along. A section has particles up
// to a spacing beside it, which at an angle to the walls are nearer than these by that over tan.
TEST(OpeningWidth, OfAJetAtRestIsTheMeanOverTheDirections) {
  const CutState state = Slotted{}.measure();
  const CutState turned = Slotted{.is_turned = true}.measure();
  EXPECT_NEAR(state.kerf_width, turned.kerf_width, 1e-9);
  EXPECT_NEAR(state.fractured_width, turned.fractured_width, 1e-9);
  double mean = 0.0;
  for (int n = 0; n < 8; ++n) {
    const double c = std::abs(std::cos(n * M_PI / 8.0)), s = std::sin(n * M_PI / 8.0);
    const double centre = (slot_width + solid_spacing) / 2.0 - solid_spacing * c;
    mean += n == 0 ? block_width / 8.0 : (2.0 * centre / s - solid_spacing) / 8.0;
  }
  EXPECT_NEAR(state.kerf_width, mean, solid_spacing);
}

TEST(OpeningWidth, OfARoundHoleIsItsDiameterAtRestToo) {
  const Case description = make_case(3);
  CutMonitor monitor(description, make_block(3));
  const CutState state = monitor.observe(make_cut(description, slot_depth, 16.0 * mm, 0.0));
  EXPECT_NEAR(state.kerf_width, 16.0 * mm, 0.5 * solid_spacing);
}

// Half the depth lies in a bore, along which no solid is near: the opening reaches to the edges of
// the workpiece, and nothing of it is pushed aside.
TEST(OpeningWidth, InAVoidReachesToTheEdgesOfTheWorkpiece) {
  for (const bool is_turned : {false, true}) {
    const CutState along =
        Slotted{.is_turned = is_turned, .feed = {1.0, 0.0, 0.0}, .has_bore = true}.measure();
    EXPECT_NEAR(along.kerf_width, block_width, 1e-6) << is_turned;
    EXPECT_EQ(along.removed_share(), 1.0) << is_turned;
    const CutState across =
        Slotted{.is_turned = is_turned, .feed = {0.0, 0.0, 1.0}, .has_bore = true}.measure();
    EXPECT_NEAR(across.kerf_width, 8.0 * mm, 1e-6) << is_turned;
    EXPECT_EQ(across.removed_share(), 1.0) << is_turned;
  }
}

// The void of the layout is no part of what the jet has opened.
TEST(OpeningWidth, TheRemovedShareIsThatOfTheOpeningInSolid) {
  CutState state;
  state.cut_through = true;
  state.kerf_width = 20e-3;
  state.void_width = 12e-3;
  state.fractured_width = 6e-3;
  EXPECT_NEAR(state.removed_share(), 0.75, 1e-12);
  state.void_width = 20e-3;
  EXPECT_EQ(state.removed_share(), 1.0);
}

}  // namespace
}  // namespace kerf
