// SPDX-License-Identifier: Apache-2.0
// The thickness at the edge of a workpiece, and the depth of a kerf beside a notch.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/cut.hpp"
#include "analysis/kerf.hpp"
#include "layout.hpp"

namespace kerf {
namespace kerf_edge_test {
namespace {

using namespace layout;

// The corners of a block are sharp where the space of a jet overlaps it by half a spacing.
TEST(KerfEdge, HasTheThicknessOfTheWorkpiece) {
  for (const double side : {1.0, -1.0})
    for (const double edge : {-3.9, -3.4, -2.9, -2.0, 0.0}) {
      Case description = make_case(2);
      description.jets.front().width = 9.8 * mm;
      Frame initial;
      add_box(initial, solid(), {(edge - 56.0) * mm, -thickness, 0.0}, {edge * mm, 0.0, 0.0});
      move(initial, [&](const Position& x) -> Position { return {side * x[0], x[1], 0.0}; });
      const CutMonitor monitor(description, initial);
      const Kerf kerf = measure_kerf(monitor.workpiece(), initial, {});
      EXPECT_NEAR(kerf.shape.thickness, thickness, 0.25 * solid_spacing) << side << " " << edge;
    }
}

// A jet that is broader than a notch cuts its lips too, but no deeper than the solid under it is
// thick.
TEST(KerfEdge, IsNoDeeperThanTheSolidUnderTheJet) {
  const Case description = make_case(2);
  const auto in_notch = [](const Position& x) {
    return std::abs(x[0]) < 4.0 * mm && x[1] > -thickness / 2.0;
  };
  Frame block = make_block(2), initial;
  for (const Position& x : block.position)
    if (!in_notch(x)) add(initial, solid(), x);
  Frame frame = initial;
  change(frame, Category::fractured, [](const Position& x) { return std::abs(x[0]) < 8.0 * mm; });
  const CutMonitor monitor(description, initial);
  const Kerf kerf = measure_kerf(monitor.workpiece(), frame, {});
  EXPECT_NEAR(kerf.shape.thickness, thickness / 2.0, solid_spacing);
  EXPECT_NEAR(kerf.shape.depth, kerf.shape.thickness, 0.25 * solid_spacing);
}

}  // namespace
}  // namespace kerf_edge_test
}  // namespace kerf
