// SPDX-License-Identifier: Apache-2.0
// The removed volume, the damaged zone beside the kerf, and both by layers.
#include "kerf_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

class KerfAmounts : public testing::TestWithParam<int> {
 protected:
  Carving carving_ = [] {
    Carving carving;
    carving.dimension = GetParam();
    if (carving.dimension == 3) {
      carving.low = {-30.0 * mm, -thickness, -12.0 * mm};
      carving.high = {30.0 * mm, 0.0, 12.0 * mm};
    }
    return carving;
  }();

  // m, of the block along the kerf; 1 in 2D.
  double length() const { return GetParam() == 3 ? 24.0 * mm : 1.0; }
  static bool slot(const Position& x, double width, double depth) {
    return std::abs(x[0]) < width / 2.0 && x[1] > -depth;
  }
};

TEST_P(KerfAmounts, RemovedSolidIsFracturedMissingOrFragmented) {
  const auto removed = [&](const Frame& frame) {
    return carving_.measure_pair(carving_.lay_out(0), frame).of<Removal>().volume;
  };
  Frame frame = carving_.lay_out(0);
  EXPECT_EQ(removed(frame), 0.0);
  change(frame, Category::fractured,
         [](const Position& x) { return slot(x, 12.0 * mm, 30.0 * mm); });
  const double slot_volume = 12.0 * mm * 30.0 * mm * length();
  EXPECT_NEAR(removed(frame), slot_volume, 1e-6 * slot_volume);
  const Frame gone = without(frame, [](const Position& x) { return slot(x, 8.0 * mm, 20.0 * mm); });
  EXPECT_NEAR(removed(gone), slot_volume, 1e-6 * slot_volume);
  // A small intact fragment in the middle of the slot, and one detached from the corner.
  Frame crumbs = frame;
  for (std::size_t row = 0; row < crumbs.position.size(); ++row)
    if (slot(crumbs.position[row], 4.0 * mm, 20.0 * mm)) crumbs.category[row] = Category::solid;
  EXPECT_NEAR(removed(crumbs), slot_volume, 1e-6 * slot_volume);
  const double edge = carving_.high[0];
  change(crumbs, Category::fractured, [&](const Position& x) {
    const double a = edge - x[0], b = -x[1];
    return std::max(a, b) > 4.0 * mm && std::max(a, b) < 6.0 * mm;
  });
  const double corner = 36.0 * mm * mm * length();
  EXPECT_NEAR(removed(crumbs), slot_volume + corner, 1e-6 * slot_volume);
}

// A flap at the face that hangs in the way ends the kerf, and hides nothing of what is gone below.
TEST_P(KerfAmounts, LossBelowTheKerfIsThatInTheWay) {
  const auto below = [&](double top, double bottom) {
    carving_.is_gone = [=](const Position& x) {
      return std::abs(x[0]) < 8.0 * mm && x[1] < -top && x[1] > -bottom;
    };
    return carving_.measure(0);
  };
  const Kerf flap = below(6.0 * mm, thickness);
  EXPECT_EQ(flap.shape.depth, 0.0);
  EXPECT_NEAR(flap.of<Removal>().share_below, 44.0 / 50.0, 1e-6);
  for (const KerfLevel& level : {flap.shape.top, flap.shape.middle, flap.shape.bottom})
    EXPECT_TRUE(std::isnan(level.width));
  const Kerf slot = below(0.0, 30.0 * mm);
  EXPECT_NEAR(slot.of<Removal>().share_below, 0.0, Removal::least_share);
  EXPECT_NEAR(slot.shape.middle.width, 16.0 * mm, solid_spacing);
  const Kerf whole = below(1.0, 0.0);
  EXPECT_EQ(whole.of<Removal>().share_below, 0.0);
  EXPECT_EQ(whole.shape.middle.width, 0.0);
  EXPECT_TRUE(std::isnan(below(0.0, thickness).of<Removal>().share_below));
}

TEST_P(KerfAmounts, RateAndSpecificEnergyAreSinceContact) {
  carving_.is_gone = [](const Position& x) { return slot(x, 12.0 * mm, 30.0 * mm); };
  carving_.time = 7e-3;
  carving_.conditions.contact_time = 2e-3;
  carving_.conditions.jet_speed = 200.0;
  carving_.conditions.on_time_factor = 0.5;
  const Removal removal = carving_.measure(0).of<Removal>();
  const double volume = 12.0 * mm * 30.0 * mm * length();
  const double section = GetParam() == 3 ? M_PI / 4.0 * jet_width * jet_width : jet_width;
  const double energy = 0.5 * 1000.0 * section * std::pow(200.0, 3) * 5e-3 * 0.5;
  EXPECT_NEAR(removal.rate, volume / 5e-3, 1e-6 * volume / 5e-3);
  EXPECT_NEAR(removal.specific_energy, energy / volume, 1e-6 * energy / volume);
}

TEST_P(KerfAmounts, NothingRemovedHasNoSpecificEnergy) {
  carving_.is_gone = [](const Position&) { return false; };
  const Removal removal = carving_.measure(0).of<Removal>();
  EXPECT_EQ(removal.volume, 0.0);
  EXPECT_EQ(removal.rate, 0.0);
  EXPECT_TRUE(std::isnan(removal.specific_energy));
}

// What falls off before the water comes has cost the jet no energy.
TEST_P(KerfAmounts, WhatIsRemovedBeforeContactHasNoSpecificEnergy) {
  carving_.is_gone = [](const Position& x) { return slot(x, 12.0 * mm, 30.0 * mm); };
  carving_.time = 7e-3;
  carving_.conditions.jet_speed = 200.0;
  for (const double contact : {std::nan(""), carving_.time}) {
    carving_.conditions.contact_time = contact;
    const Removal removal = carving_.measure(0).of<Removal>();
    EXPECT_GT(removal.volume, 0.0);
    EXPECT_EQ(removal.rate, 0.0);
    EXPECT_TRUE(std::isnan(removal.specific_energy));
  }
}

// A kerf 12 mm wide; the solid beside it is damaged up to 14 mm from the axis on the right and 10
// mm on the left, so the mean zone is 6 mm.
TEST_P(KerfAmounts, DamagedZoneIsMeasuredBesideTheKerf) {
  const auto is_hurt = [](const Position& x) { return x[0] > -10.0 * mm && x[0] < 14.0 * mm; };
  const auto zone = [&](int seed, const std::string& column, float value) {
    const Frame regular = carving_.lay_out(0);
    Frame initial = carving_.lay_out(seed), frame = initial;
    Column damage{column, "1", 1, std::vector<float>(frame.id.size(), 0.0f)};
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      const Position& x = regular.position[row];
      if (slot(x, 12.0 * mm, 30.0 * mm)) frame.category[row] = Category::fractured;
      if (is_hurt(x)) damage.values[row] = value;
    }
    frame.columns.push_back(damage);
    return carving_.measure_pair(initial, frame).of<DamagedZone>().width;
  };
  const double regular = zone(0, "damage", 0.2f);
  EXPECT_NEAR(regular, 6.0 * mm, 0.5 * solid_spacing);
  double most = 0.0;
  for (int seed = 1; seed <= carving_.seeds(); ++seed)
    most = std::max(most, std::abs(zone(seed, "damage", 0.2f) / regular - 1.0));
  EXPECT_LE(most, steady);
  RecordProperty("zone", std::to_string(100.0 * most).substr(0, 4) + "%");
  EXPECT_NEAR(zone(0, "flaw_damage", 0.2f), regular, 1e-9);
  EXPECT_NEAR(zone(0, "damage", 0.05f), 0.0, 0.1 * solid_spacing);
  EXPECT_NEAR(zone(0, "plastic_strain", 0.2f), 0.0, 0.1 * solid_spacing);
}

TEST_P(KerfAmounts, SingleFracturesMakeNoDamagedZone) {
  carving_.is_gone = [](const Position& x) {
    return slot(x, 12.0 * mm, 30.0 * mm) ||
           std::hypot(x[0] - 23.0 * mm, x[1] + 15.0 * mm, x[2]) < 1.2 * mm;
  };
  EXPECT_NEAR(carving_.measure(0).of<DamagedZone>().width, 0.0, 0.1 * solid_spacing);
}

// Two bodies, cut 20 mm wide through the upper and 12 mm wide half into the lower one.
TEST_P(KerfAmounts, LayersAreMeasuredSeparately) {
  constexpr double border = -20.0 * mm;
  for (const bool joined : {false, true}) {
    Case description = carving_.description();
    description.bodies.push_back(description.bodies[0]);
    description.bodies[0].name = "lower";
    description.bodies[1].name = "upper";
    if (joined) description.bodies[1].joined_to = "lower";
    std::array<double, 3> regular{};
    for (int seed = 0; seed <= all_seeds / 2; ++seed) {
      Frame initial = carving_.lay_out(0);
      for (std::size_t row = 0; row < initial.id.size(); ++row)
        initial.source[row] = initial.position[row][1] > border ? 1 : 0;
      Frame frame = initial;
      change(frame, Category::fractured, [](const Position& x) {
        return slot(x, x[1] > border ? 20.0 * mm : 12.0 * mm, 36.0 * mm);
      });
      for (Frame* each : {&initial, &frame}) jitter(*each, seed > 0 ? most_jitter : 0.0, seed);
      const CutMonitor monitor(description, initial);
      const Kerf kerf = measure_kerf(monitor.workpiece(), frame, carving_.conditions);
      ASSERT_EQ(kerf.layers.size(), 2u);
      // A particle far from its initial position has no neighbours in a piece.
      const double bound = (seed > 0 ? 1.0 : 0.0) * std::pow(solid_spacing, GetParam()) +
                           1e-6 * 400.0 * mm * mm * length();
      const KerfLayer &upper = kerf.layers[0], &lower = kerf.layers[1];
      EXPECT_EQ(upper.body, 1);
      EXPECT_NEAR(upper.top, 0.0, solid_spacing);
      EXPECT_NEAR(lower.top, 20.0 * mm, solid_spacing);
      EXPECT_TRUE(upper.shape.through);
      EXPECT_FALSE(lower.shape.through);
      EXPECT_NEAR(upper.shape.thickness, 20.0 * mm, solid_spacing);
      EXPECT_NEAR(lower.shape.depth, 16.0 * mm, solid_spacing);
      EXPECT_NEAR(upper.shape.middle.width, 20.0 * mm, solid_spacing);
      EXPECT_NEAR(lower.shape.top.width, 12.0 * mm, solid_spacing);
      if (seed == 0) regular = {upper.shape.middle.width, lower.shape.depth, upper.shape.thickness};
      EXPECT_NEAR(upper.shape.middle.width, regular[0], steady * regular[0]);
      EXPECT_NEAR(lower.shape.depth, regular[1], steady * regular[1]);
      EXPECT_NEAR(upper.shape.thickness, regular[2], steady * regular[2]);
      EXPECT_NEAR(kerf.shape.depth, 36.0 * mm, solid_spacing);
      EXPECT_NEAR(upper.removed_volume, 400.0 * mm * mm * length(), bound);
      EXPECT_NEAR(lower.removed_volume, 192.0 * mm * mm * length(), bound);
      EXPECT_NEAR(lower.volume, 30.0 * mm * 2.0 * carving_.high[0] * length(), 1e-9);
    }
  }
  carving_.is_gone = [](const Position&) { return false; };
  EXPECT_TRUE(carving_.measure(0).layers.empty());
}

INSTANTIATE_TEST_SUITE_P(TwoAndThree, KerfAmounts, testing::Values(2, 3));

}  // namespace
}  // namespace kerf
