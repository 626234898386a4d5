// SPDX-License-Identifier: Apache-2.0
// What is torn near the jet grows with a crack from either side, and with nothing else.
#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "bonded_layout.hpp"

namespace kerf::test::torn_mass_test {
namespace {

using namespace layout;

constexpr double half_breadth = 100.0 * mm, thick = 20.0 * mm;

// A plate under a jet 10 mm wide. A crack there may part it up to 45 mm from the axis: half the
// width of the jet and four widths.
Frame plate() {
  Frame frame;
  frame.dimension = 2;
  add_box(frame, solid(), {-half_breadth, -thick, 0.0}, {half_breadth, 0.0, 0.0});
  return frame;
}

// Gives each solid particle the share of its bonds that `breaks` breaks; those of fractured ones
// are all broken.
void tell_damage(const Frame& initial, const Breaks& breaks, Frame& frame) {
  Column damage{"damage", "1", 1, {}, "damage"};
  for (std::size_t a = 0; a < initial.id.size(); ++a) {
    double bonds = 0.0, broken = 0.0;
    for (std::size_t b = 0; b < initial.id.size(); ++b) {
      const Position &x = initial.position[a], &y = initial.position[b];
      if (a == b || std::hypot(x[0] - y[0], x[1] - y[1]) >= bond_length * solid_spacing) continue;
      bonds += 1.0;
      broken += frame.category[a] != Category::solid || frame.category[b] != Category::solid ||
                breaks(x, y);
    }
    damage.values.push_back(static_cast<float>(broken / bonds));
  }
  frame.columns.push_back(damage);
}

// A crack at x = place from the far face up to a height, m.
Breaks crack_from_below(double place, double height) {
  return [=](const Position& x, const Position& y) {
    return (x[0] < place) != (y[0] < place) && std::max(x[1], y[1]) < -thick + height;
  };
}

const auto none = [](const Position&) { return false; };

class Observed {
 public:
  // Returns what is torn, kg/m, in a frame with these broken bonds and fractured particles.
  double torn(const Breaks& breaks, const std::function<bool(const Position&)>& fractured = none) {
    Frame frame = initial_;
    change(frame, Category::fractured, fractured);
    tell_damage(initial_, breaks, frame);
    frame.piece.clear();
    bond(initial_, frame, breaks);
    add_water_beside_bonds(frame, description_, 0.0);
    for (Column& column : frame.columns) column.values.resize(frame.id.size(), 0.0f);
    frame.time = time_ += 1e-3;
    const CutState state = monitor_.observe(frame);
    EXPECT_FALSE(state.cut_through);
    EXPECT_EQ(state.cut_depth > 0.0, fractured(Position{0.0, -1.0 * mm, 0.0}));
    return state.bodies.at(0).torn;
  }

 private:
  static Frame bonded() {
    Frame frame = plate();
    bond(frame, frame);
    return frame;
  }
  Case description_ = make_case(2);
  Frame initial_ = bonded();
  CutMonitor monitor_{description_, initial_};
  double time_ = 0.0;
};

TEST(TornMass, GrowsWithACrackFromTheFarSide) {
  Observed observed;
  EXPECT_EQ(observed.torn(breaks_nothing), 0.0);
  double last = 0.0;
  for (const double height : {6.0 * mm, 10.0 * mm, 14.0 * mm}) {
    const double torn = observed.torn(crack_from_below(3.0 * mm, height));
    EXPECT_GT(torn, last);
    EXPECT_EQ(observed.torn(crack_from_below(3.0 * mm, height)), torn);  // at rest
    last = torn;
  }
}

TEST(TornMass, DoesNotCountWhatBreaksFarFromTheJet) {
  Observed observed;
  EXPECT_GT(observed.torn(crack_from_below(40.0 * mm, 10.0 * mm)), 0.0);
  EXPECT_EQ(observed.torn(crack_from_below(60.0 * mm, 10.0 * mm)), 0.0);
  EXPECT_EQ(observed.torn(breaks_nothing, [](const Position& x) { return x[0] > 60.0 * mm; }), 0.0);
}

// Rows below the face come off: first as a flake, which is less than 5% of the plate, then it
// crumbles. The flake counts with its whole mass, whatever becomes of it.
TEST(TornMass, DebrisThatCrumblesAddsNothing) {
  const auto is_flake = [](const Position& x) {
    return std::abs(x[0]) < 6.0 * mm && x[1] > -6.0 * mm;
  };
  const Breaks comes_off = [&](const Position& x, const Position& y) {
    return is_flake(x) != is_flake(y);
  };
  const Breaks crumbles = [&](const Position& x, const Position& y) {
    return comes_off(x, y) || (is_flake(x) && (x[0] < 0.0) != (y[0] < 0.0));
  };
  Case description = make_case(2);
  Frame initial = plate();
  bond(initial, initial);
  CutMonitor monitor(description, initial);
  double torn = 0.0;
  for (const Breaks& breaks : {comes_off, crumbles}) {
    Frame frame = initial;
    tell_damage(initial, breaks, frame);
    bond(initial, frame, breaks);
    add_water_beside_bonds(frame, description, 0.0);
    frame.columns.front().values.resize(frame.id.size(), 0.0f);
    const double now = monitor.observe(frame).bodies.at(0).torn;
    EXPECT_GT(now, 12.0 * mm * 6.0 * mm * 940.0);  // and the broken bonds around it
    EXPECT_NEAR(now, torn > 0.0 ? torn : now, 1e-12);
    torn = now;
  }
}

}  // namespace
}  // namespace kerf::test::torn_mass_test
