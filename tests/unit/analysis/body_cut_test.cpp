// SPDX-License-Identifier: Apache-2.0
// Whether bodies are cut through follows from their unbroken bonds, not from how far they stretch.
#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "analysis/kerf.hpp"
#include "bonded_layout.hpp"
#include "model/material_laws.hpp"

namespace kerf {
namespace {

using namespace layout;

// A block under a jet, 100 mm wide and 50 mm thick, turned by the angle of the jet. Water fills a
// dent 20 mm deep.
struct Trial {
  double angle = 0.0;
  double jitter_share = 0.0;
  unsigned seed = 1;
  double stretch = 1.0;  // of the frame, along x and down
  bool can_break = true;
  double border = -1.0;  // m, the y of the border of an upper and a lower body; none if above 0

  Case description() const {
    Case made = make_case(2, angle);
    made.materials[1].failure_strain = can_break ? 0.1 : 0.0;
    if (border < 0.0 && border > -thickness) {
      made.bodies.push_back(made.bodies[0]);
      made.bodies[0].name = "lower";
      made.bodies[1].name = "upper";
    }
    return made;
  }
  Frame initial() const {
    Frame frame = make_block(2);
    for (std::size_t k = 0; k < frame.id.size(); ++k)
      frame.source[k] = border > -thickness && frame.position[k][1] > border ? 1 : 0;
    if (jitter_share > 0.0) jitter(frame, jitter_share, seed);
    return frame;
  }
  // The verdict on a frame in which `breaks` are broken and `fractured` are fractured.
  CutSummary judge(const Breaks& breaks,
                   const std::function<bool(const Position&)>& fractured = {}) const {
    Frame before = initial(), after = before;
    if (fractured) change(after, Category::fractured, fractured);
    bond(before, after, breaks);
    bond(before, before);
    move(after, [&](const Position& x) -> Position {
      return {stretch * x[0], stretch * x[1], 0.0};
    });
    const Case made = description();
    add_water_beside_bonds(after, made, 20.0 * mm * stretch);
    tilt(before, angle);
    tilt(after, angle);
    CutMonitor monitor(made, before);
    monitor.observe(after);
    return monitor.summary();
  }
};

// The set-ups in which every answer must be the same.
std::vector<Trial> trials() {
  std::vector<Trial> all;
  unsigned seed = 1;
  for (const double angle : {0.0, 0.7, -0.3})
    for (const double jitter_share : {0.0, 0.3})
      for (const double stretch : {1.0, 2.5, 10.0})
        all.push_back({angle, jitter_share, seed++, stretch});
  return all;
}

bool in_pocket(const Position& x) {
  return std::abs(x[0]) < 7.0 * mm && x[1] > -38.0 * mm;
}

TEST(BodyCut, ALayerThatIsOnlyStretchedIsWhole) {
  for (const Trial& trial : trials()) {
    const CutSummary summary = trial.judge(breaks_nothing, in_pocket);
    EXPECT_EQ(summary.last.pieces, 1);
    EXPECT_FALSE(summary.cut_through) << trial.angle << " " << trial.stretch;
  }
}

// A curved crack parts the block, whether it has opened or not, and whatever else is damaged; a
// single bond across it that is left holds it together.
TEST(BodyCut, ACrackThroughAllBondsParts) {
  const auto line = [](double y) { return 1.3 * mm + 6.0 * mm * std::sin(y / (12.0 * mm)); };
  for (const Trial& trial : trials()) {
    const Breaks all = and_at_random(crack(line), 0.2, trial.seed);
    const CutSummary parted = trial.judge(all);
    EXPECT_EQ(parted.last.pieces, 2);
    EXPECT_TRUE(parted.cut_through && parted.severed) << trial.angle << " " << trial.stretch;
    // The bonds of one particle beside the crack are left.
    const Frame block = trial.initial();
    std::size_t nearest = 0;
    const auto gap = [&](std::size_t k) {
      return std::hypot(block.position[k][0] - line(block.position[k][1]),
                        block.position[k][1] + 30.0 * mm);
    };
    for (std::size_t k = 0; k < block.id.size(); ++k)
      if (gap(k) < gap(nearest)) nearest = k;
    const Position keeper = block.position[nearest];
    const CutSummary held = trial.judge([&](const Position& x, const Position& y) {
      return x != keeper && y != keeper && all(x, y);
    });
    EXPECT_EQ(held.last.pieces, 1);
    EXPECT_FALSE(held.cut_through) << trial.angle << " " << trial.stretch;
  }
}

// Parts that break off elsewhere, or along the jet's face, do not open the block.
TEST(BodyCut, ACrackBesideOrAcrossTheJetIsNoCut) {
  const Breaks across = [](const Position& x, const Position& y) {
    return (x[1] < -35.0 * mm) != (y[1] < -35.0 * mm);
  };
  const Breaks beside = crack([](double) { return 24.0 * mm; });
  const Breaks far = [](const Position& x, const Position& y) {
    return (x[0] < -48.0 * mm) != (y[0] < -48.0 * mm);
  };
  for (const Trial& trial : trials()) {
    EXPECT_FALSE(trial.judge(across).cut_through);
    EXPECT_FALSE(trial.judge(across, in_pocket).cut_through);
    EXPECT_FALSE(trial.judge(beside).cut_through);
    EXPECT_FALSE(trial.judge(far).cut_through);
  }
}

TEST(BodyCut, ACrumbledSideIsNoCut) {
  const auto outside = [](const Position& x) { return std::abs(x[0]) > 20.0 * mm; };
  for (const Trial& trial : trials())
    EXPECT_FALSE(trial.judge(breaks_nothing, outside).cut_through) << trial.angle;
}

// Nothing cuts a material without a limit: not a crack, not crumbling, not water below it.
TEST(BodyCut, AMaterialWithoutALimitIsNeverCut) {
  const std::function<bool(const Position&)> damages[] = {
      {},
      in_pocket,
      [](const Position& x) { return std::abs(x[0]) < 7.0 * mm; },
      [](const Position&) { return true; }};
  for (Trial trial : trials()) {
    trial.can_break = false;
    for (const double share : {0.0, 0.5, 1.0}) {
      const Breaks breaks =
          and_at_random(crack([](double) { return 0.5 * mm; }), share, trial.seed);
      for (const auto& fractured : damages) {
        const CutSummary summary = trial.judge(breaks, fractured);
        EXPECT_FALSE(summary.cut_through);
        EXPECT_FALSE(summary.bodies.at(0).cut.through);
      }
    }
  }
}

TEST(BodyCut, EachBodyHasItsVerdict) {
  for (Trial trial : trials()) {
    trial.border = -24.0 * mm;
    const Breaks upper = [](const Position& x, const Position& y) {
      return x[1] > -24.0 * mm && y[1] > -24.0 * mm && (x[0] < 1.0 * mm) != (y[0] < 1.0 * mm);
    };
    const CutSummary summary = trial.judge(upper);
    EXPECT_FALSE(summary.cut_through);
    ASSERT_EQ(summary.bodies.size(), 2u);
    EXPECT_FALSE(summary.bodies[0].cut.through);
    EXPECT_TRUE(summary.bodies[1].cut.through && summary.bodies[1].cut.severed);
    EXPECT_TRUE(summary.bodies[0].is_in_way && summary.bodies[1].is_in_way);
    EXPECT_TRUE(std::isnan(summary.bodies[0].time));
    EXPECT_EQ(summary.bodies[1].time, 0.0);
    EXPECT_TRUE(trial.judge(crack([](double) { return 1.0 * mm; })).cut_through);
  }
}

// A bonded inclusion across the axis is whole while the body around it is parted.
TEST(BodyCut, AnInclusionThatIsPushedAheadIsWhole) {
  Case description = make_case(2);
  description.materials[1].failure_strain = 0.1;
  description.bodies.push_back(description.bodies[0]);
  description.bodies[1].joined_to = "block";
  const auto is_vessel = [](const Position& x) {
    return std::hypot(x[0], x[1] + 25.0 * mm) < 9.0 * mm;
  };
  Frame initial = make_block(2);
  for (std::size_t k = 0; k < initial.id.size(); ++k)
    initial.source[k] = is_vessel(initial.position[k]) ? 1 : 0;
  Frame frame = initial;
  change(frame, Category::fractured,
         [&](const Position& x) { return std::abs(x[0]) < 7.0 * mm && !is_vessel(x); });
  bond(initial, frame,
       [&](const Position& x, const Position& y) { return is_vessel(x) != is_vessel(y); });
  bond(initial, initial);
  for (std::size_t k = 0; k < frame.id.size(); ++k)
    if (frame.source[k] == 1) frame.position[k][1] -= 60.0 * mm;
  const std::size_t solids = frame.id.size();
  add_water(frame, description, 70.0 * mm, jet_width);
  for (std::size_t k = 0; k < frame.id.size(); ++k)
    if (k >= solids) frame.source[k] = 2;
  frame.piece.resize(frame.id.size(), 0);
  frame.body_piece.resize(frame.id.size(), 0);
  CutMonitor monitor(description, initial);
  monitor.observe(frame);
  const CutSummary summary = monitor.summary();
  EXPECT_FALSE(summary.cut_through);
  ASSERT_EQ(summary.bodies.size(), 2u);
  EXPECT_TRUE(summary.bodies[0].cut.through);
  EXPECT_FALSE(summary.bodies[1].cut.through);
  const Kerf kerf = measure_kerf(monitor.workpiece(), frame, kerf_conditions(description, summary));
  EXPECT_FALSE(kerf.shape.through);
  EXPECT_FALSE(kerf.opening.through);
  ASSERT_EQ(kerf.layers.size(), 2u);
  for (const KerfLayer& layer : kerf.layers) EXPECT_EQ(layer.verdict.cut.through, layer.body == 0);
  EXPECT_LT(kerf.of<CutMargin>().value, 0.0);
  EXPECT_GT(kerf.of<CutMargin>().unbroken, 10.0 * mm);

  // It is still whole when it has left the domain.
  Frame later = select(frame, rows_of(frame), [&](std::size_t k) { return frame.source[k] != 1; });
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    if (frame.source[k] == 1) continue;
    later.piece.push_back(frame.piece[k]);
    later.body_piece.push_back(frame.body_piece[k]);
  }
  monitor.observe(later);
  EXPECT_FALSE(monitor.summary().cut_through);
  EXPECT_FALSE(monitor.summary().bodies[1].cut.through);
}

// In space: a round hole opens the block where it goes all the way down, and where the last rows
// are torn and the water is below them; a layer that is pushed ahead keeps it closed.
TEST(BodyCut, AHoleMustGoThroughTheBonds) {
  for (const double jitter_share : {0.0, 0.2}) {
    Case description = make_case(3);
    description.materials[1].failure_strain = 0.1;
    Frame initial = make_block(3);
    if (jitter_share > 0.0) jitter(initial, jitter_share, 5);
    const auto verdict = [&](double depth, bool is_torn, double water_depth) {
      Frame before = initial, frame = initial;
      const auto in_hole = [](const Position& x) { return std::hypot(x[0], x[2]) < 8.0 * mm; };
      change(frame, Category::fractured,
             [&](const Position& x) { return in_hole(x) && x[1] > -depth; });
      Column damage{"damage", "1", 1, std::vector<float>(frame.id.size(), 0.0f), {}};
      for (std::size_t k = 0; k < frame.id.size(); ++k)
        if (in_hole(frame.position[k])) damage.values[k] = is_torn ? 0.4f : 0.2f;
      bond(before, frame);
      bond(before, before);
      // The rest of the way the solid is pushed ahead of the water.
      for (std::size_t k = 0; k < frame.id.size(); ++k)
        if (in_hole(frame.position[k]) && frame.category[k] == Category::solid)
          frame.position[k][1] -= 30.0 * mm;
      const std::size_t solids = frame.id.size();
      add_water(frame, description, water_depth, 8.0 * mm);
      for (std::size_t k = solids; k < frame.id.size(); ++k) damage.values.push_back(0.0f);
      frame.piece.resize(frame.id.size(), 0);
      frame.body_piece.resize(frame.id.size(), 0);
      frame.columns.push_back(damage);
      CutMonitor monitor(description, before);
      monitor.observe(frame);
      return monitor.summary();
    };
    EXPECT_TRUE(verdict(thickness + solid_spacing, false, 20.0 * mm).cut_through);
    EXPECT_FALSE(verdict(thickness + solid_spacing, false, 20.0 * mm).severed);
    EXPECT_FALSE(verdict(40.0 * mm, false, 70.0 * mm).cut_through);
    EXPECT_FALSE(verdict(40.0 * mm, true, 30.0 * mm).cut_through);
    EXPECT_TRUE(verdict(40.0 * mm, true, 90.0 * mm).cut_through);
  }
}

// The margin is minus the share of the thickness that has kept its bonds, at every stretch.
TEST(BodyCut, TheMarginIsTheUnbrokenShare) {
  for (const double stretch : {1.0, 3.0, 10.0}) {
    const Case description = Trial{}.description();
    Frame initial = make_block(2), frame = initial;
    change(frame, Category::fractured, in_pocket);
    bond(initial, frame);
    bond(initial, initial);
    move(frame, [&](const Position& x) -> Position { return {x[0], stretch * x[1], 0.0}; });
    CutMonitor monitor(description, initial);
    monitor.observe(frame);
    const Kerf kerf =
        measure_kerf(monitor.workpiece(), frame, kerf_conditions(description, monitor.summary()));
    EXPECT_NEAR(kerf.of<CutMargin>().unbroken, 12.0 * mm, 1e-6 * mm);
    EXPECT_NEAR(kerf.of<CutMargin>().value, -12.0 / 50.0, 1e-6);
  }
}

}  // namespace
}  // namespace kerf
