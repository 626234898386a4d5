// SPDX-License-Identifier: Apache-2.0
// The depth of a cut that passes voids, gaps and bodies that stand beside it.
#include <gtest/gtest.h>

#include "analysis/cut_depth.hpp"
#include "analysis/kerf.hpp"
#include "bonded_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

// Two bodies, each where `body` says; -1 where nothing is laid out.
struct Stack {
  int dimension = 2;
  double angle = 0.0, jitter_share = 0.0;

  Kerf kerf(const std::function<int(const Position&)>& body,
            const std::function<bool(const Position&)>& gone) const {
    Case made = make_case(dimension, angle);
    made.bodies.push_back(made.bodies[0]);
    made.bodies[1].name = "other";
    const Frame block = make_block(dimension);
    Frame before = without(block, [&](const Position& x) { return body(x) < 0; });
    for (std::size_t k = 0; k < before.id.size(); ++k) {
      before.id[k] = static_cast<std::uint32_t>(k);
      before.source[k] = static_cast<std::uint16_t>(body(before.position[k]));
      before.mass[k] = block.mass[0];
    }
    Frame after = before;
    change(after, Category::fractured, gone);
    if (jitter_share > 0.0) {
      jitter(before, jitter_share, 3);
      jitter(after, jitter_share, 3);
    }
    bond(before, after);
    bond(before, before);
    add_water_beside_bonds(after, made, 20.0 * mm);
    tilt(before, angle);
    tilt(after, angle);
    CutMonitor monitor(made, before);
    monitor.observe(after);
    depth = monitor.summary().last.cut_depth;
    return measure_kerf(monitor.workpiece(), after, kerf_conditions(made, monitor.summary()));
  }
  mutable double depth = -1.0;  // m, of the cut in the last kerf
};

std::vector<Stack> stacks() {
  std::vector<Stack> all;
  for (const int dimension : {2, 3})
    for (const double angle : {0.0, 0.7, -0.3})
      for (const double jitter_share : {0.0, 0.2}) all.push_back({dimension, angle, jitter_share});
  return all;
}

bool in_slot(const Position& x, double depth) {
  return std::hypot(x[0], x[2]) < 7.0 * mm && x[1] > -depth;
}

// The water crosses a void within a body: the depth is that of the kerf.
TEST(CutDepth, GoesOnBelowAVoid) {
  const auto hollow = [](const Position& x) {
    return std::abs(x[0]) < 15.0 * mm && x[1] < -12.0 * mm && x[1] > -26.0 * mm ? -1 : 0;
  };
  for (const Stack& stack : stacks()) {
    for (const double depth : {12.0 * mm, 30.0 * mm, 40.0 * mm}) {
      const Kerf kerf = stack.kerf(hollow, [&](const Position& x) { return in_slot(x, depth); });
      const double expected = std::max(depth, 26.0 * mm);
      EXPECT_NEAR(stack.depth, expected, 1.2 * solid_spacing) << stack.angle;
      EXPECT_NEAR(stack.depth, kerf.shape.depth, 1.2 * solid_spacing) << stack.angle;
    }
    const auto skin = [&](const Position& x) { return in_slot(x, 40.0 * mm) && x[1] < -4.0 * mm; };
    stack.kerf(hollow, skin);
    EXPECT_EQ(stack.depth, 0.0) << stack.angle;
  }
}

// A crater beside a harder body on top is open, and as deep as it is below its own face.
TEST(CutDepth, IsThatBesideABodyOnTop) {
  const auto pebble = [](const Position& x) {
    return x[1] < -12.0 * mm ? 0 : std::hypot(x[0], x[2]) < 4.0 * mm ? 1 : -1;
  };
  for (const Stack& stack : stacks()) {
    const auto crater = [](const Position& x) {
      const double off = std::hypot(x[0], x[2]);
      return off > 4.0 * mm && off < 9.0 * mm && x[1] < -12.0 * mm && x[1] > -20.0 * mm;
    };
    stack.kerf(pebble, crater);
    EXPECT_NEAR(stack.depth, 8.0 * mm, 1.2 * solid_spacing) << stack.angle;
    const auto hidden = [](const Position& x) {
      return std::hypot(x[0], x[2]) < 3.0 * mm && x[1] < -12.0 * mm && x[1] > -20.0 * mm;
    };
    stack.kerf(pebble, hidden);
    EXPECT_EQ(stack.depth, 0.0) << stack.angle;
    const auto under = [&](const Position& x) { return crater(x) || hidden(x); };
    stack.kerf(pebble, under);
    EXPECT_NEAR(stack.depth, 8.0 * mm, 1.2 * solid_spacing) << stack.angle;
  }
}

// The gap between two bodies counts once the upper one is open.
TEST(CutDepth, CrossesTheGapBetweenBodies) {
  const auto two = [](const Position& x) {
    return x[1] > -16.0 * mm ? 1 : x[1] < -26.0 * mm ? 0 : -1;
  };
  for (const Stack& stack : stacks()) {
    stack.kerf(two, [](const Position& x) { return in_slot(x, 34.0 * mm); });
    EXPECT_NEAR(stack.depth, 34.0 * mm, 1.2 * solid_spacing) << stack.angle;
    stack.kerf(two, [](const Position& x) { return in_slot(x, 10.0 * mm); });
    EXPECT_NEAR(stack.depth, 10.0 * mm, 1.2 * solid_spacing) << stack.angle;
    stack.kerf(two, [](const Position& x) { return in_slot(x, 34.0 * mm) && x[1] < -26.0 * mm; });
    EXPECT_EQ(stack.depth, 0.0) << stack.angle;
  }
}

}  // namespace
}  // namespace kerf
