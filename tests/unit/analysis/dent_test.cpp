// SPDX-License-Identifier: Apache-2.0
// The dent is the loss of thickness under the jet, whatever the motion of the workpiece.
#include <ostream>

#include "geometry/jet_direction.hpp"
#include "kerf_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

struct DentLayout {
  int dimension;
  double angle;          // rad, of the jet
  bool is_block_tilted;  // with the jet

  friend std::ostream& operator<<(std::ostream& out, const DentLayout& of) {
    return out << of.dimension << "D at " << of.angle << " rad"
               << (of.is_block_tilted ? ", tilted" : "");
  }
};

class DentOfABlock : public testing::TestWithParam<DentLayout> {
 protected:
  using Motion = std::function<Position(const Position&)>;

  Carving carving_ = [] {
    Carving carving;
    carving.dimension = GetParam().dimension;
    carving.angle = GetParam().angle;
    carving.is_block_tilted = GetParam().is_block_tilted;
    return carving;
  }();

  Dent after(const Motion& motion, int seed = 0) const {
    const Frame initial = carving_.lay_out(seed);
    Frame frame = initial;
    move(frame, motion);
    return carving_.measure_pair(initial, frame).of<Dent>();
  }
  // The length of a line along the jet, less a particle.
  double line() const {
    const double angle = carving_.is_block_tilted ? 0.0 : carving_.angle;
    return (thickness - solid_spacing) / std::cos(angle);
  }
};

TEST_P(DentOfABlock, IsNoneWithoutAnyMotion) {
  const Dent dent = after([](const Position& x) { return x; });
  EXPECT_EQ(dent.depth, 0.0);
  EXPECT_EQ(dent.motion, 0.0);
}

TEST_P(DentOfABlock, IsNoneWhereTheBlockMovesOrTurnsAsAWhole) {
  const Dent shifted = after([](const Position& x) -> Position {
    return {x[0] + 3.0 * mm, x[1] - 40.0 * mm, x[2]};
  });
  EXPECT_NEAR(shifted.depth, 0.0, 1e-9);
  EXPECT_NEAR(shifted.motion, std::hypot(3.0 * mm, 40.0 * mm), 1e-9);
  // A tilted block is moved before the tilt, in which the jet points straight down.
  const Position along = carving_.is_block_tilted ? Position{0.0, -1.0, 0.0}
                                                  : jet_direction(carving_.description().jets[0]);
  EXPECT_NEAR(shifted.sag, 3.0 * mm * along[0] - 40.0 * mm * along[1], 1e-9);
  EXPECT_NEAR(shifted.aside, std::abs(3.0 * mm * along[1] + 40.0 * mm * along[0]), 1e-9);
  const double turn = 0.35;  // rad, about the aimed point
  const Dent turned = after([turn](const Position& x) -> Position {
    return {std::cos(turn) * x[0] - std::sin(turn) * x[1],
            std::sin(turn) * x[0] + std::cos(turn) * x[1], x[2]};
  });
  EXPECT_NEAR(turned.depth, 0.0, 1e-9);
  EXPECT_NEAR(turned.motion, 2.0 * std::sin(turn / 2.0) * line(), 3.0 * mm);
}

// Two halves of a cut slide apart along a table: they have moved, but have not given way.
TEST_P(DentOfABlock, SidesThatSlideApartDoNotSag) {
  if (!carving_.is_block_tilted) GTEST_SKIP() << "the face is not across the jet";
  const Dent dent = after([](const Position& x) -> Position {
    return {x[0] + (x[0] > 0.0 ? 3.0 * mm : -3.0 * mm), x[1], x[2]};
  });
  EXPECT_NEAR(dent.motion, 3.0 * mm, 1e-9);
  EXPECT_NEAR(dent.aside, 3.0 * mm, 1e-9);
  EXPECT_NEAR(dent.sag, 0.0, 1e-9);
}

// The whole block is thinner by a part that is far below a spacing, and moves down.
TEST_P(DentOfABlock, IsTheLossOfThickness) {
  for (const double part : {1e-4, 0.02}) {
    for (int seed = 0; seed <= 3; ++seed) {
      const Dent dent = after(
          [part](const Position& x) -> Position {
            return {x[0], -thickness + (1.0 - part) * (x[1] + thickness) - 7.0 * mm, x[2]};
          },
          seed);
      const double angle = carving_.is_block_tilted ? 0.0 : carving_.angle;
      const double now = std::hypot(std::sin(angle), (1.0 - part) * std::cos(angle));
      EXPECT_NEAR(dent.depth, (1.0 - now) * line(), 0.06 * (1.0 - now) * line());
      EXPECT_NEAR(dent.motion, 7.0 * mm, part * 3.0 * solid_spacing);
    }
  }
}

TEST_P(DentOfABlock, HasTheDepthOfItsMiddle) {
  if (!carving_.is_block_tilted) GTEST_SKIP() << "the lines cross the dent at a slant";
  const double depth = 4.0 * mm, radius = 25.0 * mm;
  const Dent dent = after([&](const Position& x) -> Position {
    const double share = std::exp(-std::pow(std::hypot(x[0], x[2]) / radius, 2.0));
    return {x[0], x[1] - depth * share * (1.0 + x[1] / thickness), x[2]};
  });
  EXPECT_NEAR(dent.depth, depth, 0.06 * depth);
  EXPECT_LT(dent.motion, 0.05 * depth);
}

INSTANTIATE_TEST_SUITE_P(Jets, DentOfABlock,
                         testing::Values(DentLayout{2, 0.0, true}, DentLayout{2, 0.6, true},
                                         DentLayout{2, -0.6, true}, DentLayout{2, 0.6, false},
                                         DentLayout{2, -0.6, false}, DentLayout{3, 0.0, true},
                                         DentLayout{3, 0.6, true}));

// A plate that is bent to an arc is as thick as before.
TEST(Dent, IsNoneWhereAPlateBends) {
  Carving plate;
  plate.low = {-50.0 * mm, -6.0 * mm, 0.0};
  const Frame initial = plate.lay_out(0);
  Frame bent = initial;
  const double radius = 80.0 * mm;
  const auto bend = [radius](const Position& x) -> Position {
    const double arc = (x[0] + 50.0 * mm) / radius, from_centre = radius + x[1] + 3.0 * mm;
    return {from_centre * std::sin(arc) - 50.0 * mm, from_centre * std::cos(arc) - radius, 0.0};
  };
  move(bent, bend);
  const Dent dent = plate.measure_pair(initial, bent).of<Dent>();
  EXPECT_NEAR(dent.depth, 0.0, 1e-9);
  // That of the far face at the outermost window, whose middle is 4 mm beside the axis.
  const Position far{4.0 * mm, -5.0 * mm, 0.0}, now = bend(far);
  EXPECT_NEAR(dent.motion, std::hypot(now[0] - far[0], now[1] - far[1]), 0.2 * mm);
}

// The upper body is 20 mm thick and loses 1 mm; the lower one is finer, and moves only.
TEST(Dent, IsThatOfAllBodiesInTheWay) {
  Case description = make_case(2);
  description.bodies.push_back(description.bodies.front());
  Frame initial;
  add_box(initial, solid(0), {-50.0 * mm, -20.0 * mm, 0.0}, {50.0 * mm, 0.0, 0.0});
  Kind fine = solid(1);
  fine.spacing = 1.0 * mm;
  add_box(initial, fine, {-50.0 * mm, -30.0 * mm, 0.0}, {50.0 * mm, -20.0 * mm, 0.0});
  Frame frame = initial;
  for (std::size_t row = 0; row < frame.position.size(); ++row) {
    double& y = frame.position[row][1];
    y -= frame.source[row] == 1 ? 5.0 * mm : (y + 19.0 * mm) / (18.0 * mm) * 1.0 * mm;
  }
  const CutMonitor monitor(description, initial);
  const Dent dent = measure_kerf(monitor.workpiece(), frame, {}).of<Dent>();
  EXPECT_NEAR(dent.depth, 1.0 * mm, 1e-9);
  EXPECT_NEAR(dent.motion, 5.0 * mm, 1e-9);
}

// A particle whose distance from the axis is exactly half the width of the jet is in its way at
// every angle.
TEST(Dent, ABodyAtTheEdgeOfTheJetIsInItsWayAtEveryAngle) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = degrees * 3.14159265358979 / 180.0;
    Case description = make_case(2, angle);
    Frame initial;
    add_box(initial, solid(), {4.0 * mm, -20.0 * mm, 0.0}, {50.0 * mm, 0.0, 0.0});
    tilt(initial, angle);
    const CutMonitor monitor(description, initial);
    ASSERT_FALSE(monitor.workpiece().empty()) << degrees;
    EXPECT_TRUE(monitor.workpiece().bodies.front().is_in_way) << degrees;
  }
}

}  // namespace
}  // namespace kerf
