// SPDX-License-Identifier: Apache-2.0
// A jet that leans across a symmetry plane enters the workpiece where it enters the whole one.
#include <ostream>

#include <gtest/gtest.h>

#include "analysis/workpiece.hpp"
#include "layout.hpp"

namespace kerf {
namespace symmetric_face {

using namespace layout;

struct Lean {
  int dimension;
  double angle;   // rad
  double beside;  // m, of the aimed point from the plane
  bool is_right;  // the side of the plane that is simulated

  friend std::ostream& operator<<(std::ostream& out, const Lean& of) {
    return out << of.dimension << "D at " << of.angle << " rad, " << of.beside << " m beside, "
               << (of.is_right ? "right" : "left");
  }
};

// A block of which a half, right or left of x = 0, or all is simulated.
Case case_of(const Lean& lean, bool is_half) {
  Case description = make_case(lean.dimension, lean.angle);
  description.jets[0].position[0] = lean.is_right ? lean.beside : -lean.beside;
  const double half = lean.dimension == 3 ? 20.0 * mm : 50.0 * mm;
  Box& box = description.bodies[0].shape.box;
  box = {{-half, -thickness, -half}, {half, 0.0, half}};
  description.domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  if (!is_half) return description;
  (lean.is_right ? box.minimum : box.maximum)[0] = 0.0;
  (lean.is_right ? description.domain.minimum : description.domain.maximum)[0] = 0.0;
  (lean.is_right ? description.symmetry.minimum : description.symmetry.maximum)[0] = true;
  return description;
}

Workpiece workpiece_of(const Case& description) {
  const Box& box = description.bodies[0].shape.box;
  Frame part;
  part.dimension = description.dimension;
  add_box(part, solid(), box.minimum, box.maximum);
  return make_workpiece(description, WholeFrame(part, symmetry_images(description)).get());
}

class SymmetricFace : public testing::TestWithParam<Lean> {};

TEST_P(SymmetricFace, IsThatOfTheWhole) {
  const Workpiece whole = workpiece_of(case_of(GetParam(), false));
  const Workpiece part = workpiece_of(case_of(GetParam(), true));
  ASSERT_TRUE(whole.jet && part.jet);
  // The axis enters at the top, y = 0, where it aims.
  EXPECT_NEAR(whole.jet->aim[1], 0.0, 1e-9);
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(part.jet->aim[a], whole.jet->aim[a], 1e-9) << a;
  EXPECT_NEAR(part.jet->standoff, whole.jet->standoff, 1e-9);
  EXPECT_NEAR(part.bottom, whole.bottom, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Leans, SymmetricFace,
                         testing::Values(Lean{2, 0.5, 0.0, true}, Lean{2, -0.5, 0.0, true},
                                         Lean{2, 0.5, 0.0, false}, Lean{2, -0.5, 0.0, false},
                                         Lean{2, -0.5, 1e-7, true}, Lean{2, 0.5, 1e-7, true},
                                         Lean{2, 0.5, -1e-7, true}, Lean{2, 0.5, 5.0 * mm, true},
                                         Lean{2, -0.5, 5.0 * mm, false}, Lean{3, 0.5, 0.0, true},
                                         Lean{3, -0.5, 0.0, true}, Lean{3, -0.5, 1e-6, true}));

}  // namespace symmetric_face
}  // namespace kerf
