// SPDX-License-Identifier: Apache-2.0
// A body whose drawing is divided along the jet into two that are joined is one body to the jet.
#include <gtest/gtest.h>

#include "analysis/kerf.hpp"
#include "bonded_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

Case divided_case(bool is_divided) {
  Case description = make_case(2);
  if (!is_divided) return description;
  Body right = description.bodies.front();
  right.name = "right";
  right.joined_to = "block";
  description.bodies.push_back(right);
  return description;
}

// A block, divided at a place across the jet if the case has two bodies.
Frame divided_block(const Case& description, double place) {
  Frame frame = make_block(2);
  for (std::size_t row = 0; description.bodies.size() > 1 && row < frame.id.size(); ++row)
    frame.source[row] = frame.position[row][0] > place ? 1 : 0;
  bond(frame, frame);
  return frame;
}

struct DividedOutcome {
  CutSummary cut;
  CutMargin margin;
};

// The outcome of cracks and of a notch, in which solid is fractured, of a depth, m.
DividedOutcome judge_divided(bool is_divided, double place, const Breaks& breaks, double notch) {
  const Case description = divided_case(is_divided);
  const Frame initial = divided_block(description, place);
  Frame frame = initial;
  change(frame, Category::fractured,
         [&](const Position& x) { return std::abs(x[0]) < 4.0 * mm && x[1] > -notch; });
  bond(initial, frame, breaks);
  add_water_beside_bonds(frame, description, 12.0 * mm);
  CutMonitor monitor(description, initial);
  monitor.observe(frame);
  const CutSummary cut = monitor.summary();
  const Kerf kerf = measure_kerf(monitor.workpiece(), frame, kerf_conditions(description, cut));
  EXPECT_TRUE(kerf.layers.empty());
  return {cut, kerf.of<CutMargin>()};
}

TEST(UnitedBodies, ADividedBodyIsCutAsAWholeOne) {
  const Breaks parted = crack([](double) { return 1.0 * mm; });
  const Breaks part = [&](const Position& x, const Position& y) {
    return parted(x, y) && x[1] > -30.0 * mm && y[1] > -30.0 * mm;
  };
  for (const double place : {-2.0 * mm, 0.0, 20.0 * mm})
    for (const double notch : {0.0, 10.0 * mm, thickness})
      for (const Breaks& breaks : {Breaks(breaks_nothing), part, parted}) {
        const DividedOutcome whole = judge_divided(false, place, breaks, notch);
        const DividedOutcome divided = judge_divided(true, place, breaks, notch);
        ASSERT_EQ(divided.cut.bodies.size(), 1u);
        EXPECT_EQ(divided.cut.cut_through, whole.cut.cut_through);
        EXPECT_EQ(divided.cut.severed, whole.cut.severed);
        EXPECT_EQ(divided.cut.last.cut_depth, whole.cut.last.cut_depth);
        EXPECT_EQ(divided.margin.value, whole.margin.value);
        EXPECT_EQ(divided.margin.unbroken, whole.margin.unbroken);
      }
}

// The bond of two layers, and bodies of two materials side by side, leave each its verdict.
TEST(UnitedBodies, LayersAndOtherMaterialsAreBodiesOfTheirOwn) {
  Case description = divided_case(true);
  Frame layers = make_block(2);
  for (std::size_t row = 0; row < layers.id.size(); ++row)
    layers.source[row] = layers.position[row][1] > -20.0 * mm ? 0 : 1;
  bond(layers, layers);
  EXPECT_EQ(CutMonitor(description, layers).workpiece().bodies.size(), 2u);
  description.materials.push_back(description.materials[1]);
  description.bodies[1].material = 2;
  EXPECT_EQ(CutMonitor(description, divided_block(description, 0.0)).workpiece().bodies.size(), 2u);
}

// Two bodies side by side are as thick as a line through one of them.
TEST(UnitedBodies, TheUnbrokenThicknessIsThatOnALine) {
  Case description = divided_case(true);
  description.bodies[1].joined_to.clear();
  const Frame initial = divided_block(description, 0.0);
  CutMonitor monitor(description, initial);
  monitor.observe(initial);
  const Kerf kerf =
      measure_kerf(monitor.workpiece(), initial, kerf_conditions(description, monitor.summary()));
  EXPECT_NEAR(kerf.of<CutMargin>().unbroken, thickness, 1e-6 * thickness);
  EXPECT_NEAR(kerf.of<CutMargin>().value, -1.0, 1e-6);
}

// A block over a notch on the axis that leaves 12 mm of it: that is the least thickness.
TEST(UnitedBodies, TheUnbrokenThicknessIsTheLeast) {
  for (const int dimension : {2, 3}) {
    const Case description = make_case(dimension);
    const Frame initial = without(make_block(dimension), [](const Position& x) {
      return std::abs(x[0]) < 3.0 * mm && x[1] < -12.0 * mm;
    });
    CutMonitor monitor(description, initial);
    monitor.observe(initial);
    const Kerf kerf =
        measure_kerf(monitor.workpiece(), initial, kerf_conditions(description, monitor.summary()));
    EXPECT_NEAR(kerf.of<CutMargin>().unbroken, 12.0 * mm, 1e-6 * mm);
    EXPECT_NEAR(kerf.of<CutMargin>().value, -1.0, 1e-6);
  }
}

// The lower of two layers is broken through while the upper one is whole; side by side no body
// covers another.
TEST(UnitedBodies, ABodyUnderOneThatIsNotCutIsCovered) {
  Case description = divided_case(true);
  description.bodies[1].joined_to.clear();
  for (const bool is_stack : {true, false}) {
    Frame initial = make_block(2);
    for (std::size_t row = 0; row < initial.id.size(); ++row) {
      const Position& x = initial.position[row];
      initial.source[row] = (is_stack ? x[1] < -20.0 * mm : x[0] > 0.0) ? 1 : 0;
    }
    bond(initial, initial);
    Frame frame = initial;
    for (std::size_t row = 0; row < frame.id.size(); ++row)
      if (frame.source[row] == 1 && std::abs(frame.position[row][0]) < 8.0 * mm)
        frame.category[row] = Category::fractured;
    bond(initial, frame);
    add_water_beside_bonds(frame, description, 2.0 * mm);
    CutMonitor monitor(description, initial);
    monitor.observe(frame);
    const Kerf kerf =
        measure_kerf(monitor.workpiece(), frame, kerf_conditions(description, monitor.summary()));
    ASSERT_EQ(kerf.layers.size(), 2u);
    EXPECT_FALSE(kerf.layers[0].is_covered);
    EXPECT_EQ(kerf.layers[1].is_covered, is_stack);
    EXPECT_TRUE(kerf.layers[1].verdict.cut.through || !is_stack);
  }
}

}  // namespace
}  // namespace kerf
