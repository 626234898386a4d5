// SPDX-License-Identifier: Apache-2.0
// A slit parts what it lies between, however narrow: no bond passes it, and no other is missing.
// The oracle is the side of the slit on which a particle lies.
#include "solid/bonds_through_solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/fill.hpp"
#include "model/case.hpp"
#include "support/shapes.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test::bonds_through_solid_test {
namespace {

constexpr double spacing = 1e-3, half = 6.0 * spacing;  // of the block

using Bonds = std::set<std::pair<Index, Index>>;

// The normal of the slit that divides the block through its middle, and its half width.
struct Slit {
  double angle = 0.0, half_width = 0.0;  // rad, m

  double height(const Point& x) const { return x[0] * std::cos(angle) + x[1] * std::sin(angle); }
};

Shape whole_block() {
  return box({-half, -half, -half}, {half, half, half});
}

// The block without the slit.
Shape divided_block(const Slit& slit) {
  Shape gap;
  const double c = std::cos(slit.angle), s = std::sin(slit.angle), w = slit.half_width;
  const double far = 4.0 * half;
  gap.kind = Shape::Kind::polygon;
  for (const auto& [across, along] :
       {std::pair{-w, -far}, std::pair{w, -far}, std::pair{w, far}, std::pair{-w, far}})
    gap.vertices.push_back({across * c - along * s, across * s + along * c});
  gap.depth_minimum = -far;
  gap.depth_maximum = far;
  return of_parts(Shape::Kind::difference, {whole_block(), gap});
}

template <int D>
SolidLayout<D> filled_layout(const Shape& shape) {
  Body body;
  body.role = Role::elastic;
  body.shape = shape;
  body.spacing = spacing;
  SolidLayout<D> layout;
  layout.media = {soft_solid(spacing, D)};
  for (const Point& point : fill(body, D)) {
    layout.reference.push_back(vector_of<D>(point));
    layout.medium_index.push_back(0);
  }
  layout.regions = {{0, regions_of({body}, {0}, D).front()}};
  return layout;
}

Bonds bonds_in(const BondLists& lists) {
  Bonds bonds;
  for (Index i = 0; i + 1 < static_cast<Index>(lists.begin.size()); ++i)
    for (Index k = lists.begin[i]; k < lists.begin[i + 1]; ++k)
      bonds.insert({i, lists.neighbour[k]});
  return bonds;
}

template <class Dimension>
class BondsThroughSolids : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(BondsThroughSolids, Dimensions);

// Returns the bonds whose ends are on the same side of the slit.
template <int D>
Bonds beside(const Slit& slit, const SolidLayout<D>& layout) {
  Bonds bonds;
  for (const auto& bond : bonds_in(BondFinder<D>(layout).find())) {
    const double a = slit.height(point_of(layout.reference[bond.first]));
    const double b = slit.height(point_of(layout.reference[bond.second]));
    if (a * b > 0.0) bonds.insert(bond);
  }
  return bonds;
}

TYPED_TEST(BondsThroughSolids, ASlitPartsItsSides) {
  constexpr int D = TypeParam::value;
  for (const double width : {0.6, 1.0, 2.0})
    for (const double angle : {0.0, 0.3, 1.2}) {
      const Slit slit{angle, 0.5 * width * spacing};
      const SolidLayout<D> layout = filled_layout<D>(divided_block(slit));
      EXPECT_EQ(bonds_in(bonds_of(layout)), beside(slit, layout)) << width << ' ' << angle;
    }
}

// Around a wide hole the bonds that cut its edge hold as before; those across a narrow one do not.
TYPED_TEST(BondsThroughSolids, OfAHoleOnlyTheBondsAcrossItAreLeftOut) {
  constexpr int D = TypeParam::value;
  const auto block_with_hole = [](double radius) {
    Shape hole;
    hole.kind = Shape::Kind::disc;
    hole.radius = radius;
    hole.centre = {0.5 * spacing, 0.5 * spacing, -2.0 * half};  // about a node
    hole.length = 4.0 * half;
    return filled_layout<D>(of_parts(Shape::Kind::difference, {whole_block(), hole}));
  };
  const SolidLayout<D> wide = block_with_hole(5.0 * spacing);
  EXPECT_EQ(bonds_in(bonds_of(wide)), bonds_in(BondFinder<D>(wide).find()));
  const SolidLayout<D> narrow = block_with_hole(0.8 * spacing);
  const Bonds kept = bonds_in(bonds_of(narrow));
  Bonds across;
  for (const auto& bond : bonds_in(BondFinder<D>(narrow).find()))
    if (kept.count(bond) == 0) across.insert(bond);
  EXPECT_FALSE(across.empty());
  for (const auto& [i, j] : across) {
    const auto middle = 0.5 * (narrow.reference[i] + narrow.reference[j]);
    EXPECT_LT(std::hypot(middle[0] - 0.5 * spacing, middle[1] - 0.5 * spacing), 0.65 * spacing);
    EXPECT_EQ(across.count({j, i}), 1u);
  }
}

// A slit in a symmetry plane, of which the part has one half.
TYPED_TEST(BondsThroughSolids, ASlitInASymmetryPlanePartsTheImage) {
  constexpr int D = TypeParam::value;
  const auto part = [](double gap) {
    const SolidLayout<D> whole = filled_layout<D>(
        of_parts(Shape::Kind::join, {box({-half, -half, -half}, {-gap, half, half}),
                                     box({gap, -half, -half}, {half, half, half})}));
    SolidLayout<D> layout = whole;
    layout.reference.clear();
    for (const auto& x : whole.reference)
      if (x[0] > 0.0) layout.reference.push_back(x);
    layout.medium_index.assign(layout.reference.size(), 0);
    layout.mirrors.faces = MirrorPlanes<D>::low_face(0);
    layout.mirrors.low = Vector<D, double>::zero();
    layout.media[0].joined_mirrors = layout.mirrors.faces;
    return layout;
  };
  const auto images = [](const SolidLayout<D>& layout) {
    const BondLists bonds = bonds_of(layout);
    return std::count_if(bonds.neighbour.begin(), bonds.neighbour.end(),
                         [&](Index entry) { return layout.mirrors.code(entry) != 0; });
  };
  EXPECT_EQ(images(part(0.5 * spacing)), 0);
  EXPECT_GT(images(part(0.0)), 0);
}

}  // namespace
}  // namespace kerf::test::bonds_through_solid_test
