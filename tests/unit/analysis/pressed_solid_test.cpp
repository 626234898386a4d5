// SPDX-License-Identifier: Apache-2.0
// Solid inside rigid bodies: a block whose lower layers lie within a table.
#include "analysis/pressed_solid.hpp"

#include <gtest/gtest.h>

#include "analysis/workpiece.hpp"
#include "layout.hpp"

namespace kerf::test::pressed_solid_test {
namespace {

using namespace layout;

Case case_on_table(int dimension, double top) {
  Case description = make_case(dimension);
  Body table;
  table.role = Role::rigid;
  table.spacing = solid_spacing;
  table.shape.kind = Shape::Kind::box;
  table.shape.box = {{-0.1, -0.1, -0.1}, {0.1, top, 0.1}};
  description.bodies.push_back(table);
  return description;
}

double share_of(const Case& description, const Frame& initial, const Frame& frame) {
  const Workpiece workpiece = make_workpiece(description, initial);
  return pressed_share(workpiece, frame, locate(workpiece, frame),
                       resting_rigid_shapes(description));
}

// The block ends at -50 mm. With the table's face at -44.1 mm its lowest two layers, at 4.9 and
// 2.9 mm below that, are a spacing of 2 mm or more inside it, and the third, at 0.9 mm, is not.
TEST(PressedSolid, IsWhatLiesDeepInARigidBody) {
  for (const int dimension : {2, 3}) {
    const Frame block = make_block(dimension);
    EXPECT_EQ(share_of(case_on_table(dimension, -thickness), block, block), 0.0);
    EXPECT_EQ(share_of(case_on_table(dimension, -thickness + 2.9 * mm), block, block), 0.0);
    const Case description = case_on_table(dimension, -thickness + 5.9 * mm);
    EXPECT_NEAR(share_of(description, block, block), 2.0 / 25.0, 1e-6);
    Frame debris = block;
    for (Category& category : debris.category) category = Category::fractured;
    EXPECT_EQ(share_of(description, block, debris), 0.0);
    Case moving = description;
    moving.bodies.back().velocity[1] = "1";
    EXPECT_EQ(share_of(moving, block, block), 0.0);
  }
}

}  // namespace
}  // namespace kerf::test::pressed_solid_test
