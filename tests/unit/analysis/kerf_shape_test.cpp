// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include "kerf_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

struct View {
  int dimension;
  double angle;  // rad

  friend std::ostream& operator<<(std::ostream& out, const View& of) {
    return out << of.dimension << "D at " << of.angle << " rad";
  }
};

class KerfOf : public testing::TestWithParam<View> {
 protected:
  Carving carving_ = [] {
    Carving carving;
    carving.dimension = GetParam().dimension;
    carving.angle = GetParam().angle;
    if (carving.dimension == 3) {
      carving.low = {-30.0 * mm, -thickness, -20.0 * mm};
      carving.high = {30.0 * mm, 0.0, 20.0 * mm};
    }
    return carving;
  }();
};

double top_of(const Kerf& kerf) {
  return kerf.shape.top.width;
}
double middle_of(const Kerf& kerf) {
  return kerf.shape.middle.width;
}
double bottom_of(const Kerf& kerf) {
  return kerf.shape.bottom.width;
}

// The faces of the slot are between rows of the lattice.
TEST_P(KerfOf, AStraightBlindSlot) {
  const double width = 24.0 * mm, depth = 30.0 * mm;
  carving_.is_gone = [=](const Position& x) {
    return std::abs(x[0]) < width / 2.0 && x[1] > -depth;
  };
  const Kerf kerf = carving_.measure(0);
  EXPECT_FALSE(kerf.shape.through);
  EXPECT_NEAR(kerf.shape.taper, 0.0, 1e-3);
  EXPECT_EQ(kerf.shape.lag, 0.0);
  const auto thickness_of = [](const Kerf& k) { return k.shape.thickness; };
  expect_steady(carving_, {{"depth", depth_of, depth},
                           {"thickness", thickness_of, thickness},
                           {"top", top_of, width},
                           {"middle", middle_of, width},
                           {"bottom", bottom_of, width}});
}

// The slot is 30 mm wide at the top and 10 mm at the bottom, 50 mm below; the second one is
// reversed.
TEST_P(KerfOf, ATaperedSlot) {
  const double slope = 0.2, middle = 20.0 * mm, edge = 4.0 * mm;
  for (const double sign : {1.0, -1.0}) {
    carving_.is_gone = [=](const Position& x) {
      return std::abs(x[0]) < middle / 2.0 + sign * slope * (x[1] + thickness / 2.0);
    };
    EXPECT_TRUE(carving_.measure(0).shape.through);
    const double height = thickness - 2.0 * edge, end = sign * slope * height;
    const auto taper_of = [](const Kerf& k) { return k.shape.taper; };
    expect_steady(carving_, {{"taper", taper_of, sign * std::atan(slope), solid_spacing / height},
                             {"top", top_of, middle + end},
                             {"middle", middle_of, middle},
                             {"bottom", bottom_of, middle - end}});
  }
}

// Distance of a point from a curve over `position`.
double distance(const ProfilePoint& point, const std::function<double(double)>& curve) {
  double least = 1.0;
  for (double shift = -10.0 * mm; shift <= 10.0 * mm; shift += 0.1 * mm)
    least = std::min(least, std::hypot(shift, point.depth - curve(point.position + shift)));
  return least;
}

// Every point lies within a spacing of the face of the crater.
void expect_crater(const Carving& carving, const std::function<double(double)>& depth) {
  const auto regular = carving.measure(0).shape.profile;
  double most = 0.0, error = 0.0;
  for (int seed = 0; seed <= carving.seeds(); ++seed) {
    const auto jittered = carving.measure(seed).shape.profile;
    const auto recut = carving.measure_recut(seed).shape.profile;
    for (const ProfilePoint& point : recut) error = std::max(error, distance(point, depth));
    for (const ProfilePoint& point : jittered) {
      const auto same = std::find_if(regular.begin(), regular.end(), [&](const ProfilePoint& p) {
        return std::abs(p.position - point.position) < 0.1 * solid_spacing;
      });
      error = std::max(error, distance(point, depth));
      if (same != regular.end()) most = std::max(most, std::abs(point.depth - same->depth));
    }
  }
  EXPECT_LE(error, solid_spacing);
  EXPECT_LE(most, steady * depth(0.0));
  testing::Test::RecordProperty("profile", std::to_string(100.0 * most / depth(0.0)).substr(0, 4) +
                                               "%, " + std::to_string(error / solid_spacing));
}

TEST_P(KerfOf, AConicalCrater) {
  const double height = 30.0 * mm, radius = 20.0 * mm;
  const auto depth = [=](double r) { return height * std::max(0.0, 1.0 - std::abs(r) / radius); };
  carving_.is_gone = [depth](const Position& x) { return -x[1] < depth(std::hypot(x[0], x[2])); };
  // The depth is that over two spacings.
  expect_steady(carving_, {{"depth", depth_of, depth(solid_spacing)}});
  expect_crater(carving_, depth);
}

TEST_P(KerfOf, ARoundCrater) {
  const double height = 24.0 * mm, radius = 16.0 * mm;
  const auto depth = [=](double r) {
    return height * std::max(0.0, 1.0 - r * r / radius / radius);
  };
  carving_.is_gone = [depth](const Position& x) { return -x[1] < depth(std::hypot(x[0], x[2])); };
  expect_steady(carving_, {{"depth", depth_of, depth(solid_spacing)}});
  expect_crater(carving_, depth);
}

// An inclined jet cuts an inclined slot: its depth is along the jet, its width across.
TEST_P(KerfOf, ASlotInASlopingFace) {
  const double lean = GetParam().angle + 0.25, depth = 28.0 * mm, width = 20.0 * mm;
  carving_.angle = lean;
  carving_.is_block_tilted = false;
  const JetAxis jet(carving_.description().jets[0], carving_.dimension);
  carving_.is_gone = [=](const Position& x) {
    return std::abs(jet.offset(x)) < width / 2.0 &&
           jet.depth(x) - jet.offset(x) * std::tan(lean) < depth;
  };
  const auto thickness_of = [](const Kerf& k) { return k.shape.thickness; };
  expect_steady(carving_, {{"depth", depth_of, depth},
                           {"thickness", thickness_of, thickness / std::cos(lean)},
                           {"top", top_of, width},
                           {"middle", middle_of, width},
                           {"bottom", bottom_of, width}});
}

INSTANTIATE_TEST_SUITE_P(Views, KerfOf,
                         testing::Values(View{2, 0.0}, View{2, 0.4}, View{3, 0.0}, View{3, -0.3}));

}  // namespace
}  // namespace kerf
