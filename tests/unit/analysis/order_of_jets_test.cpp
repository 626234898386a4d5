// SPDX-License-Identifier: Apache-2.0
// Which jet has cut is the same physics in whichever order a case lists its jets, and mirrored.
#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "analysis/kerf.hpp"
#include "layout.hpp"

namespace kerf::test::order_of_jets_test {
namespace {

using namespace layout;

constexpr double apart = 20.0 * mm;  // of each axis from the middle
constexpr double front = 40.0 * mm;  // of the water of the jet that cuts

// A plate with two jets, of which the one named A cuts a slot (3D: a hole) as wide as itself right
// through; the water of the other one stands on the face.
struct Plate {
  int dimension = 2;
  bool is_a_first = true;
  double side = -1.0;  // of A, by its sign

  std::size_t number_of_a() const { return is_a_first ? 0 : 1; }
  Case description() const {
    Case made = make_case(dimension);
    made.jets.push_back(made.jets.front());
    for (std::size_t n = 0; n < 2; ++n) {
      const bool is_a = n == number_of_a();
      made.jets[n].name = is_a ? "A" : "B";
      made.jets[n].position[0] = (is_a ? side : -side) * apart;
    }
    return made;
  }
  Frame layout() const {
    Frame frame;
    frame.dimension = dimension;
    const double deep = dimension == 3 ? 20.0 * mm : 0.0;
    add_box(frame, solid(), {-60.0 * mm, -thickness, -deep}, {60.0 * mm, 0.0, deep});
    return frame;
  }
  void add_water_of(bool is_a, double depth, Frame& frame) const {
    const std::size_t before = frame.id.size();
    add_water(frame, description(), depth, jet_width);
    for (std::size_t row = before; row < frame.id.size(); ++row) {
      frame.position[row][0] += (is_a ? side : -side) * apart;
      frame.source[row] =
          static_cast<std::uint16_t>(frame.source[row] + (is_a == is_a_first ? 0 : 1));
    }
  }
  Frame at(double time, bool is_cut) const {
    Frame frame = layout();
    if (is_cut)
      change(frame, Category::fractured, [&](const Position& x) {
        return std::hypot(x[0] - side * apart, x[2]) <= 0.6 * jet_width;
      });
    add_water_of(true, is_cut ? front : 0.0, frame);
    add_water_of(false, 0.0, frame);
    frame.time = time;
    return frame;
  }
};

class OrderOfJets : public testing::TestWithParam<int> {};

TEST_P(OrderOfJets, DoesNotDecideWhoseWayIsCut) {
  for (const bool is_a_first : {true, false})
    for (const double side : {-1.0, 1.0}) {
      const Plate plate{GetParam(), is_a_first, side};
      const Case description = plate.description();
      CutMonitor monitor(description, plate.layout());
      monitor.observe(plate.at(1e-3, false));
      EXPECT_FALSE(monitor.summary().cut_through);
      const Frame cut = plate.at(2e-3, true);
      monitor.observe(cut);
      const CutSummary summary = monitor.summary();
      ASSERT_TRUE(summary.cut_through) << is_a_first << side;
      EXPECT_EQ(summary.cut_through_time, 2e-3);
      EXPECT_EQ(summary.severed, GetParam() == 2);
      EXPECT_EQ(static_cast<std::size_t>(summary.cut_jet), plate.number_of_a());
      EXPECT_EQ(summary.is_of_other_jet, !is_a_first);
      EXPECT_NEAR(summary.cut_through_place[0], side * apart, 1e-9);
      EXPECT_NEAR(summary.cut_through_place[1], -front, 3.0 * mm);
      EXPECT_NEAR(summary.front_share_at_cut, front / thickness, 3.0 * mm / thickness);
      EXPECT_FALSE(summary.cracked_ahead());
      // The kerf along the jet that cut is the slot.
      Case seen = description;
      std::swap(seen.jets.front(), seen.jets.at(plate.number_of_a()));
      const Kerf kerf = measure_kerf(monitor.workpiece_along(summary.cut_jet), cut,
                                     kerf_conditions(seen, summary));
      EXPECT_TRUE(kerf.shape.through);
      EXPECT_NEAR(kerf.shape.middle.width, 1.2 * jet_width, 1.5 * solid_spacing);
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, OrderOfJets, testing::Values(2, 3));

}  // namespace
}  // namespace kerf::test::order_of_jets_test
