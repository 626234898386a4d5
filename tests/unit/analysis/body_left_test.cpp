// SPDX-License-Identifier: Apache-2.0
// Bodies that lose bonds or particles without a crack in them are whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/broken_bonds.hpp"
#include "analysis/cut.hpp"
#include "analysis/kerf.hpp"
#include "bonded_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

Case breakable() {
  Case made = make_case(2);
  made.materials[1].failure_strain = 0.1;
  return made;
}

// Returns the bonded particles that stay, with water down to a depth.
template <class Stays>
Frame with_water(const Case& description, const Frame& bonded, const Stays& stays, double depth) {
  Frame frame = select(bonded, rows_of(bonded), stays);
  for (std::size_t k = 0; k < bonded.id.size(); ++k) {
    if (!stays(k)) continue;
    frame.piece.push_back(bonded.piece[k]);
    frame.body_piece.push_back(bonded.body_piece[k]);
  }
  const std::size_t solids = frame.id.size();
  add_water(frame, description, depth, jet_width);
  for (std::size_t k = solids; k < frame.id.size(); ++k)
    frame.id[k] += static_cast<std::uint32_t>(bonded.id.size());
  frame.piece.resize(frame.id.size(), 0);
  frame.body_piece.resize(frame.id.size(), 0);
  return frame;
}

// Most of a block has left the domain with its bonds, layer by layer: it was pushed out, not cut.
TEST(BodyCut, ABlockThatIsPushedOutIsWhole) {
  for (const double share_left : {0.9, 0.6, 0.3, 0.05, 0.0}) {
    const Case description = breakable();
    Frame initial = make_block(2), moved = initial;
    bond(initial, moved);
    bond(initial, initial);
    for (Position& x : moved.position) x[1] -= 60.0 * mm;
    const auto stays = [&](std::size_t k) {
      return initial.position[k][1] > -share_left * thickness;
    };
    const Frame frame = with_water(description, moved, stays, 60.0 * mm);
    CutMonitor monitor(description, initial);
    monitor.observe(frame);
    const CutSummary summary = monitor.summary();
    EXPECT_FALSE(summary.cut_through) << share_left;
    if (share_left > 0.5) continue;
    const Kerf kerf =
        measure_kerf(monitor.workpiece(), frame, kerf_conditions(description, summary));
    EXPECT_EQ(kerf.shape.depth, 0.0) << share_left;
    EXPECT_NEAR(kerf.of<CutMargin>().value, -1.0, 1e-9) << share_left;
  }
}

// A part of a plate has left the domain sideways before the water came: nothing is cut there.
TEST(BodyCut, APlateThatSlidesOutIsNotCut) {
  const Case description = breakable();
  Frame initial = make_block(2);
  bond(initial, initial);
  const auto stays = [&](std::size_t k) { return initial.position[k][0] < 8.0 * mm; };
  const Frame frame = with_water(description, initial, stays, 30.0 * mm);
  CutMonitor monitor(description, initial);
  monitor.observe(frame);
  EXPECT_GT(monitor.summary().last.front_depth, 0.0);
  EXPECT_EQ(monitor.summary().last.cut_depth, 0.0);
  EXPECT_FALSE(monitor.summary().cut_through);
}

// Water beside a body has torn its outermost row of particles, in the way of the jet: that is no
// cut. Torn as far as a window is broad, it is one.
TEST(BodyCut, ATornEdgeIsNoCut) {
  for (const double torn : {3.0 * mm, 5.0 * mm}) {
    const Case description = breakable();
    Frame initial;
    add_box(initial, solid(), {1.0 * mm, -thickness, 0.0}, {51.0 * mm, 0.0, 0.0});
    bond(initial, initial);
    Frame frame = initial;
    add_water_beside_bonds(frame, description, thickness + 5.0 * mm);
    Column damage{"damage", "1", 1, std::vector<float>(frame.id.size(), 0.0f)};
    for (std::size_t row = 0; row < initial.id.size(); ++row)
      if (frame.position[row][0] < torn) damage.values[row] = 0.5f;
    frame.columns.push_back(damage);
    CutMonitor monitor(description, initial);
    monitor.observe(frame);
    EXPECT_EQ(monitor.summary().cut_through, torn > 4.0 * mm) << torn;
  }
}

// A kerf does not hang on where the domain ends: what was pushed out of it whole is not removed.
TEST(BodyCut, WhatLeavesWholeIsNoPartOfTheKerf) {
  const Case description = breakable();
  Frame initial = make_block(2), cut = initial;
  change(cut, Category::fractured,
         [](const Position& x) { return std::abs(x[0]) < 6.0 * mm && x[1] > -20.0 * mm; });
  bond(initial, cut);
  bond(initial, initial);
  const Frame all = with_water(
      description, cut, [](std::size_t) { return true; }, 20.0 * mm);
  const Frame rest = with_water(
      description, cut, [&](std::size_t k) { return cut.position[k][0] < 6.0 * mm; }, 20.0 * mm);
  CutMonitor monitor(description, initial);
  const auto measure = [&](const Frame& frame) {
    monitor.observe(frame);
    return measure_kerf(monitor.workpiece(), frame,
                        kerf_conditions(description, monitor.summary()));
  };
  const Kerf before = measure(all), after = measure(rest);
  EXPECT_GT(monitor.summary().left_fraction(), 0.4);
  EXPECT_FALSE(monitor.summary().cut_through);
  EXPECT_NEAR(before.shape.depth, 20.0 * mm, 0.5 * solid_spacing);
  EXPECT_DOUBLE_EQ(after.shape.depth, before.shape.depth);
  EXPECT_DOUBLE_EQ(after.shape.middle.width, before.shape.middle.width);
  EXPECT_DOUBLE_EQ(after.of<Removal>().volume, before.of<Removal>().volume);
}

// The edge of the domain divides a piece: what is left of it, less than a counted piece, stands. As
// little elsewhere is debris.
TEST(BodyCut, ThePartOfAPieceThatIsStillInTheDomainStands) {
  for (const double edge : {45.0 * mm, 500.0 * mm}) {
    Case description = breakable();
    description.domain = {{-0.5, -0.5, -0.5}, {edge, 0.5, 0.5}};
    Frame initial = make_block(2), cut = initial;
    const auto is_between = [](const Position& x) { return x[0] > 34.0 * mm && x[0] < 40.0 * mm; };
    change(cut, Category::fractured, is_between);
    bond(initial, cut);
    bond(initial, initial);
    const Frame all = with_water(
        description, cut, [](std::size_t) { return true; }, 5.0 * mm);
    const Frame rest = with_water(
        description, cut, [&](std::size_t k) { return cut.position[k][0] < 44.0 * mm; }, 5.0 * mm);
    CutMonitor monitor(description, initial);
    monitor.observe(all);
    monitor.observe(rest);
    const Kerf kerf =
        measure_kerf(monitor.workpiece(), rest, kerf_conditions(description, monitor.summary()));
    const double breadth = edge < 0.1 ? 6.0 * mm : 10.0 * mm;
    EXPECT_NEAR(kerf.of<Removal>().volume, breadth * thickness, 1e-3 * breadth * thickness) << edge;
  }
}

// What a resumed run knows of the particles that have left continues.
TEST(BodyCut, AResumedRunKnowsWhatHasLeft) {
  const Case description = breakable();
  Frame initial = make_block(2);
  bond(initial, initial);
  CutMonitor monitor(description, initial), resumed(description, initial);
  Frame rest = select(initial, rows_of(initial),
                      [&](std::size_t k) { return initial.position[k][1] > -20.0 * mm; });
  rest.piece.assign(rest.id.size(), rest.id.front());
  rest.body_piece = rest.piece;
  monitor.observe(initial);
  monitor.observe(rest);
  resumed.restore(monitor.history(), monitor.traces(), rest);
  EXPECT_EQ(resumed.traces(), monitor.traces());
  const auto left =
      std::count(monitor.traces().begin(), monitor.traces().end(), slot_trace::left_whole);
  EXPECT_EQ(static_cast<std::size_t>(left), initial.id.size() - rest.id.size());
}

// Solid that leaves the domain whole takes bonds with it, which nothing has broken.
TEST(BodyCut, WhatLeavesWholeBreaksNoBond) {
  const Case description = breakable();
  Frame initial = make_block(2);
  bond(initial, initial);
  CutMonitor monitor(description, initial);
  Frame rest = select(initial, rows_of(initial),
                      [&](std::size_t k) { return initial.position[k][1] > -20.0 * mm; });
  rest.piece.assign(rest.id.size(), rest.id.front());
  rest.body_piece = rest.piece;
  Column damage{"damage", "1", 1, std::vector<float>(rest.id.size(), 0.0f), {}};
  for (std::size_t row = 0; row < rest.id.size(); ++row)
    if (rest.position[row][1] < -18.0 * mm) damage.values[row] = 0.25f;
  rest.columns.push_back(damage);
  monitor.observe(initial);
  monitor.observe(rest);
  EXPECT_GT(broken_bond_sum(monitor.workpiece(), rest), 0.0);
  EXPECT_EQ(broken_bond_sum(monitor.workpiece(), rest, monitor.traces()), 0.0);
  EXPECT_EQ(monitor.summary().broken_fraction(), 0.0);
  EXPECT_NEAR(monitor.summary().left_fraction(), 0.6, 1e-6);
  rest.columns.back().values.back() = 0.25f;  // in the row at the top
  EXPECT_EQ(broken_bond_sum(monitor.workpiece(), rest, monitor.traces()), 0.25);
}

// A layer that has lost its bonds to its neighbours and none of its own is whole.
TEST(BodyCut, ALayerWhoseGlueBreaksIsWhole) {
  for (const bool tells_of_body : {false, true}) {
    const Case description = breakable();
    Frame initial = make_block(2), frame = initial;
    bond(initial, frame);
    bond(initial, initial);
    const std::vector<float> none(frame.id.size(), 0.0f), torn(frame.id.size(), 0.6f);
    frame.columns.push_back({"damage", "1", 1, torn, {}});
    if (tells_of_body) frame.columns.push_back({"body_damage", "1", 1, none, {}});
    CutMonitor monitor(description, initial);
    monitor.observe(frame);
    const Kerf kerf =
        measure_kerf(monitor.workpiece(), frame, kerf_conditions(description, monitor.summary()));
    EXPECT_NEAR(kerf.of<CutMargin>().value, tells_of_body ? -1.0 : 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace kerf
