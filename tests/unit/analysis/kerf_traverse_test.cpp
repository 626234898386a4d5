// SPDX-License-Identifier: Apache-2.0
// Kerfs of a moving nozzle.
#include <ostream>

#include "kerf_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

constexpr double speed = 1.0;  // m/s

double lag_of(const Kerf& kerf) {
  return kerf.shape.lag;
}

// A slab along the path of the nozzle, which has moved from the origin to 40 mm. The angles are
// those of the jet, which is inclined against or along the traverse, and of the traverse about the
// vertical.
struct Way {
  double angle = 0.0;  // rad
  bool is_turned = false;

  friend std::ostream& operator<<(std::ostream& out, const Way& of) {
    return out << of.angle << " rad" << (of.is_turned ? ", turned" : "");
  }
};

class TraversedKerf : public testing::TestWithParam<Way> {
 protected:
  static constexpr double now = 40.0 * mm;
  Carving carving_ = [] {
    Carving carving;
    carving.dimension = 3;
    carving.angle = GetParam().angle;
    carving.low = {-16.0 * mm, -thickness, -16.0 * mm};
    carving.high = carving.low;
    for (double& x : carving.high) x = -x;
    carving.high[1] = 0.0;
    carving.low[way()] = -30.0 * mm;
    carving.high[way()] = 60.0 * mm;
    carving.conditions.contact_time = 0.0;
    carving.conditions.traverse = {std::cos(carving.angle), std::sin(carving.angle), 0.0};
    if (way() == 2) carving.conditions.traverse = {0.0, 0.0, 1.0};
    carving.time = now / speed;
    return carving;
  }();

  static std::size_t way() { return GetParam().is_turned ? 2 : 0; }
  static double along(const Position& x) { return x[way()]; }
  static double across(const Position& x) { return x[2 - way()]; }
};

// The front trails by 0.4 of the depth; its levels are 46 mm apart.
TEST_P(TraversedKerf, ASlantedFrontLagsByItsSlant) {
  const double slope = 0.4, between = thickness - 2.0 * 2.0 * solid_spacing;
  carving_.is_gone = [=](const Position& x) {
    return std::abs(across(x)) < 8.0 * mm && along(x) < now + 5.0 * mm + slope * x[1];
  };
  const Kerf kerf = carving_.measure(0);
  EXPECT_TRUE(kerf.shape.through);
  EXPECT_NEAR(kerf.shape.top.width, 16.0 * mm, 1e-2 * solid_spacing);
  EXPECT_NEAR(kerf.shape.taper, 0.0, 1e-3);
  expect_steady(carving_, {{"lag", lag_of, slope * between}, {"depth", depth_of, thickness}});
}

TEST_P(TraversedKerf, AnUprightFrontDoesNotLagAndOneThatLeadsAtItsFootLagsLess) {
  const double between = thickness - 2.0 * 2.0 * solid_spacing;
  for (const double slope : {0.0, -0.2}) {
    carving_.is_gone = [=](const Position& x) {
      return std::abs(across(x)) < 8.0 * mm && along(x) < now + 4.0 * mm + slope * x[1];
    };
    for (int seed = 0; seed <= 3; ++seed)
      EXPECT_NEAR(carving_.measure(seed).shape.lag, slope * between, 0.5 * solid_spacing);
  }
}

TEST_P(TraversedKerf, ABlindGrooveHasItsDepths) {
  const auto depth = [](double along) {
    return 24.0 * mm + 8.0 * mm * std::sin(along / (8.0 * mm));
  };
  const double end = now + 6.0 * mm;
  carving_.is_gone = [=](const Position& x) {
    return std::abs(across(x)) < 8.0 * mm && along(x) < end && -x[1] < depth(along(x));
  };
  expect_steady(carving_, {{"depth", depth_of, 24.0 * mm, 2.0 * solid_spacing}});
  const auto regular = carving_.measure(0).shape.profile;
  double most = 0.0, error = 0.0;
  for (int seed = 0; seed <= carving_.seeds(); ++seed) {
    const auto jittered = carving_.measure(seed).shape.profile;
    std::size_t compared = 0;
    for (const ProfilePoint& point : jittered) {
      if (point.position < -26.0 * mm || point.position > end - 4.0 * mm) continue;
      const auto same = std::find_if(regular.begin(), regular.end(), [&](const ProfilePoint& p) {
        return std::abs(p.position - point.position) < 0.1 * solid_spacing;
      });
      ASSERT_NE(same, regular.end());
      ++compared;
      most = std::max(most, std::abs(point.depth / same->depth - 1.0));
      error = std::max(error, std::abs(point.depth - depth(point.position)));
    }
    EXPECT_GT(compared, 10u);
  }
  EXPECT_LE(error, solid_spacing);
  EXPECT_LE(most, steady);
  testing::Test::RecordProperty("profile", std::to_string(100.0 * most).substr(0, 4) + "%, " +
                                               std::to_string(error / solid_spacing));
}

// The kerf is through on the first 30 mm of the 40 mm of the path, then a groove.
TEST_P(TraversedKerf, ThroughShareIsTheCutPartOfThePath) {
  carving_.is_gone = [=](const Position& x) {
    return std::abs(across(x)) < 8.0 * mm && along(x) < now + 6.0 * mm &&
           (along(x) < 30.0 * mm || x[1] > -20.0 * mm);
  };
  expect_steady(carving_,
                {{"through_share", [](const Kerf& kerf) { return kerf.shape.through_share; }, 0.75,
                  2.0 * solid_spacing / now}});
}

INSTANTIATE_TEST_SUITE_P(Ways, TraversedKerf,
                         testing::Values(Way{}, Way{0.4, false}, Way{-0.3, true}));

class FlatTraverse : public testing::TestWithParam<double> {};

// In two dimensions the nozzle moves in the plane of the block.
TEST_P(FlatTraverse, LagIsEqualInBothDirections) {
  const double way = GetParam(), slope = 0.5;
  Carving carving;
  carving.conditions.contact_time = 0.0;
  carving.conditions.traverse = {way * speed, 0.0, 0.0};
  carving.time = 20.0 * mm / speed;
  carving.is_gone = [=](const Position& x) {
    const double along = way * x[0];
    return along > -10.0 * mm && along < 26.0 * mm + slope * x[1] && x[1] > -40.0 * mm;
  };
  const double between = 40.0 * mm - 6.0 * solid_spacing;
  expect_steady(carving, {{"lag", lag_of, slope * between}, {"depth", depth_of, 40.0 * mm}});
}

TEST_P(FlatTraverse, ThroughShareIsTheCutPartOfThePath) {
  const double way = GetParam(), now = 30.0 * mm;
  Carving carving;
  carving.conditions.contact_time = 0.0;
  carving.conditions.traverse = {way * speed, 0.0, 0.0};
  carving.time = now / speed;
  carving.is_gone = [=](const Position& x) {
    const double along = way * x[0];
    return along > -10.0 * mm && along < 36.0 * mm && (along < 18.0 * mm || x[1] > -20.0 * mm);
  };
  expect_steady(carving,
                {{"through_share", [](const Kerf& kerf) { return kerf.shape.through_share; }, 0.6,
                  solid_spacing / now}});
}

// The kerf is through up to the place that the nozzle has left by the way on which its water goes
// down to the far face at half of its speed, and half of the jet: whenever the run ends, all of the
// way is cut on which cutting has ended.
TEST_P(FlatTraverse, ThroughShareDoesNotHangOnTheEndOfTheRun) {
  const double way = GetParam(), jet_speed = 8.0 * speed;
  for (const double now : {24.0 * mm, 28.0 * mm, 32.0 * mm}) {
    Carving carving;
    carving.conditions.contact_time = 0.0;
    carving.conditions.traverse = {way * speed, 0.0, 0.0};
    carving.time = now / speed;
    const double width = carving.description().jets.front().width;
    const double behind = 0.5 * width + 2.0 * thickness * speed / jet_speed;
    carving.is_gone = [=](const Position& x) {
      const double along = way * x[0];
      return along > -10.0 * mm && along < now - behind + 2.0 * solid_spacing;
    };
    EXPECT_LT(carving.measure(0).shape.through_share, 0.9) << "of the whole way";
    carving.conditions.jet_speed = jet_speed;
    EXPECT_EQ(carving.measure(0).shape.through_share, 1.0) << now;
  }
}

TEST(KerfAtRest, ReportsCutThrough) {
  Carving carving;
  carving.conditions.contact_time = 0.0;
  for (const double depth : {30.0 * mm, thickness}) {
    carving.is_gone = [=](const Position& x) { return std::abs(x[0]) < 8.0 * mm && x[1] > -depth; };
    EXPECT_EQ(carving.measure(0).shape.through_share, depth == thickness ? 1.0 : 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, FlatTraverse, testing::Values(1.0, -1.0));

TEST(KerfWithoutAFront, HasNoLag) {
  Carving carving;
  carving.conditions.contact_time = 0.0;
  carving.conditions.traverse = {speed, 0.0, 0.0};
  carving.time = 20.0 * mm / speed;
  carving.is_gone = [](const Position&) { return false; };
  EXPECT_TRUE(std::isnan(carving.measure(0).shape.lag));
  carving.is_gone = [](const Position& x) { return x[1] > -20.0 * mm; };
  EXPECT_TRUE(std::isnan(carving.measure(0).shape.lag));
  carving.conditions.traverse = {};
  EXPECT_EQ(carving.measure(0).shape.lag, 0.0);
}

}  // namespace
}  // namespace kerf
