// SPDX-License-Identifier: Apache-2.0
// Disturbances that must not change a kerf, and cases without one.
#include "kerf_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

class KerfOfAMovedBlock : public testing::TestWithParam<int> {
 protected:
  static constexpr double width = 16.0 * mm, depth = 30.0 * mm;
  Carving carving_ = [] {
    Carving carving;
    carving.dimension = GetParam();
    carving.high = {30.0 * mm, 0.0, 16.0 * mm};
    carving.low = {-30.0 * mm, -thickness, -16.0 * mm};
    return carving;
  }();
  Frame initial_ = carving_.lay_out(0);
  Frame frame_ = [this] {
    Frame frame = initial_;
    change(frame, Category::fractured,
           [](const Position& x) { return std::abs(x[0]) < width / 2.0 && x[1] > -depth; });
    return frame;
  }();

  static bool is_near(const Position& x, const Position& place, double distance) {
    return std::hypot(x[0] - place[0], x[1] - place[1], x[2] - place[2]) < distance;
  }
  void expect_kerf(const Frame& frame, double breadth = width) const {
    const KerfShape shape = carving_.measure_pair(initial_, frame).shape;
    EXPECT_NEAR(shape.depth, depth, 0.25 * solid_spacing);
    for (const KerfLevel& level : {shape.top, shape.middle, shape.bottom})
      EXPECT_NEAR(level.width, breadth, 0.25 * solid_spacing);
    EXPECT_FALSE(shape.through);
  }
};

TEST_P(KerfOfAMovedBlock, IsNotNarrowedBySmallFragments) {
  for (const Position& place :
       {Position{0.0, -15.0 * mm, 0.0}, Position{2.0 * mm, -24.0 * mm, 0.0}})
    for (std::size_t row = 0; row < frame_.position.size(); ++row)
      if (is_near(frame_.position[row], place, 3.0 * mm)) frame_.category[row] = Category::solid;
  expect_kerf(frame_);
}

TEST_P(KerfOfAMovedBlock, IsNotChangedBySingleFractures) {
  for (const Position& place :
       {Position{13.0 * mm, -15.0 * mm, 0.0}, Position{0.0, -35.0 * mm, 0.0},
        Position{-19.0 * mm, -5.0 * mm, 0.0}})
    change(frame_, Category::fractured,
           [&](const Position& x) { return is_near(x, place, 1.2 * mm * std::sqrt(GetParam())); });
  expect_kerf(frame_);
}

TEST_P(KerfOfAMovedBlock, BeginsAtTheInitialFaceOfAMovedBlock) {
  expect_kerf(frame_);
  move(frame_, [](const Position& x) -> Position {
    return {x[0] + 9.0 * mm, x[1] - 40.0 * mm, x[2]};
  });
  expect_kerf(frame_);
}

// The halves of a plate that was cut through have moved apart by 6 mm.
TEST_P(KerfOfAMovedBlock, CurrentWidthIncludesTheSeparationOfTheHalves) {
  change(frame_, Category::fractured,
         [](const Position& x) { return std::abs(x[0]) < width / 2.0; });
  for (std::size_t row = 0; row < frame_.position.size(); ++row)
    if (frame_.category[row] == Category::solid)
      frame_.position[row][0] += frame_.position[row][0] > 0.0 ? 4.0 * mm : -2.0 * mm;
  EXPECT_NEAR(carving_.measure_pair(initial_, frame_).shape.middle.width, width, 1e-3 * mm);
  EXPECT_NEAR(carving_.measure_pair(initial_, frame_).opening.middle.width, width + 6.0 * mm,
              0.5 * mm);
}

// No particle is fractured: the solid under the jet is displaced downwards and sideways.
TEST_P(KerfOfAMovedBlock, ADentHasACurrentWidthOnly) {
  Frame dented = initial_;
  move(dented, [](const Position& x) -> Position {
    const double share = std::abs(x[0]) < width / 2.0 ? 1.0 + x[1] / thickness : 0.0;
    return {x[0], x[1] - 10.0 * mm * share, x[2]};
  });
  EXPECT_NEAR(carving_.measure_pair(initial_, dented).shape.depth, 0.0, 1e-3 * mm);
  EXPECT_NEAR(carving_.measure_pair(initial_, dented).opening.depth, 10.0 * mm,
              0.5 * solid_spacing);
}

TEST_P(KerfOfAMovedBlock, ReachesTheEdgeOfTheBlockWhereAHalfIsDetached) {
  const Frame half = without(frame_, [](const Position& x) { return x[0] > -width / 2.0; });
  const double breadth = 30.0 * mm + width / 2.0;
  EXPECT_NEAR(carving_.measure_pair(initial_, half).shape.middle.width, breadth, solid_spacing);
}

// Two layers with a gap between them, in which half the depth lies.
TEST_P(KerfOfAMovedBlock, HasNoWidthInAGapBetweenLayers) {
  const auto is_in_gap = [](const Position& x) {
    return std::abs(x[1] + thickness / 2.0) < 5.0 * mm;
  };
  const Frame layers = without(initial_, is_in_gap);
  Frame cut = layers;
  change(cut, Category::fractured, [](const Position& x) { return std::abs(x[0]) < width / 2.0; });
  const Kerf kerf = carving_.measure_pair(layers, cut);
  EXPECT_NEAR(kerf.shape.depth, thickness, 0.25 * solid_spacing);
  EXPECT_TRUE(std::isnan(kerf.shape.middle.width));
  EXPECT_TRUE(std::isnan(kerf.of<DamagedZone>().width));
  for (const KerfLevel& level : {kerf.shape.top, kerf.shape.bottom})
    EXPECT_NEAR(level.width, width, 0.25 * solid_spacing);
  EXPECT_NEAR(kerf.shape.taper, 0.0, 1e-3);
}

TEST_P(KerfOfAMovedBlock, IsIndependentOfTheParticleOrder) {
  const Kerf a = carving_.measure_pair(initial_, frame_);
  const Kerf b = carving_.measure_pair(initial_, shuffled(frame_, 5));
  EXPECT_EQ(a.shape.depth, b.shape.depth);
  EXPECT_EQ(a.shape.middle.width, b.shape.middle.width);
  EXPECT_EQ(a.of<Removal>().volume, b.of<Removal>().volume);
  EXPECT_EQ(a.of<DamagedZone>().width, b.of<DamagedZone>().width);
}

TEST_P(KerfOfAMovedBlock, AShallowKerfHasOneWidth) {
  Frame shallow = initial_;
  change(shallow, Category::fractured,
         [](const Position& x) { return std::abs(x[0]) < width / 2.0 && x[1] > -8.0 * mm; });
  const KerfShape shape = carving_.measure_pair(initial_, shallow).shape;
  EXPECT_NEAR(shape.depth, 8.0 * mm, 0.5 * solid_spacing);
  EXPECT_NEAR(shape.middle.width, width, 0.5 * solid_spacing);
  EXPECT_EQ(shape.top.width, shape.bottom.width);
  EXPECT_EQ(shape.taper, 0.0);
}

INSTANTIATE_TEST_SUITE_P(TwoAndThree, KerfOfAMovedBlock, testing::Values(2, 3));

void expect_nothing(const Kerf& kerf) {
  EXPECT_EQ(kerf.shape.depth, 0.0);
  EXPECT_EQ(kerf.shape.middle.width, 0.0);
  EXPECT_EQ(kerf.shape.taper, 0.0);
  EXPECT_EQ(kerf.of<DamagedZone>().width, 0.0);
  EXPECT_EQ(kerf.of<Removal>().rate, 0.0);
  EXPECT_FALSE(kerf.shape.through);
}

TEST(NoKerf, WithoutAWorkpieceAJetOrACut) {
  expect_nothing(measure_kerf(Workpiece{}, Frame{}, {}));
  Carving carving;
  carving.is_gone = [](const Position&) { return false; };
  expect_nothing(carving.measure(0));
  Case description = carving.description();
  description.jets.clear();
  const Frame block = make_block(2);
  const CutMonitor monitor(description, block);
  expect_nothing(measure_kerf(monitor.workpiece(), block, {}));
}

}  // namespace
}  // namespace kerf
