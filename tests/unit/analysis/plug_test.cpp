// SPDX-License-Identifier: Apache-2.0
// A plug that the jet has punched out cuts a body through; what breaks off elsewhere does not.
#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "analysis/kerf.hpp"
#include "bonded_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

using Region = std::function<int(const Position&)>;  // bonds between regions break

// A plate 20 mm thick under a jet 10 mm wide. Water has entered its face.
struct PunchedPlate {
  int dimension = 2;
  double angle = 0.0, jitter_share = 0.0, size = 1.0;  // the size multiplies all lengths
  double half = 80.0 * mm, depth = 20.0 * mm;
  double pushed = 0.0;  // m, by which region 0, the plug, has flown

  static PunchedPlate in_space() {
    PunchedPlate plate;
    plate.dimension = 3;
    plate.half = 26.0 * mm;
    plate.depth = 8.0 * mm;
    return plate;
  }
  Case description() const {
    Case made = make_case(dimension, angle);
    made.jets[0].width *= size;
    made.jets[0].standoff *= size;
    return made;
  }
  CutSummary judge(const Region& region, const Region& region_at_start = {}) const {
    Frame before;
    before.dimension = dimension;
    add_box(before, solid(), {-half * size, -depth * size, -half * size},
            {half * size, 0.0, half * size});
    if (jitter_share > 0.0) jitter(before, jitter_share, 7);
    Frame after = before;
    const auto by = [this](const Region& of) -> Breaks {
      if (!of) return breaks_nothing;
      return [this, of](const Position& x, const Position& y) {
        return of(scaled(x)) != of(scaled(y));
      };
    };
    bond(before, after, by(region));
    bond(before, before, by(region_at_start));
    for (Position& x : after.position)
      if (region(scaled(x)) == 0) x[1] -= pushed;
    const Case made = description();
    add_water_beside_bonds(after, made, 8.0 * mm * size);
    tilt(before, angle);
    tilt(after, angle);
    CutMonitor monitor(made, before);
    monitor.observe(after);
    return monitor.summary();
  }
  Position scaled(const Position& x) const { return {x[0] / size, x[1] / size, x[2] / size}; }
};

std::vector<PunchedPlate> punched_plates() {
  std::vector<PunchedPlate> all;
  for (const double angle : {0.0, 0.6, -0.3})
    for (const double jitter_share : {0.0, 0.25})
      for (const double size : {1.0, 2.0}) {
        PunchedPlate plate;
        plate.angle = angle;
        plate.jitter_share = jitter_share;
        plate.size = size;
        plate.pushed = angle == 0.0 ? 0.0 : 100.0 * mm;
        all.push_back(plate);
      }
  return all;
}

// The plug lies between low and high at the face, and is broader by `lean` at the bottom.
Region plug_between(double low, double high, double lean = 0.0) {
  return [=](const Position& x) {
    const double more = -lean * x[1] / (20.0 * mm);
    return x[0] < low - more ? -1 : x[0] > high + more ? 1 : 0;
  };
}

TEST(Plug, HasANameAmongTheKindsOfCuts) {
  EXPECT_EQ(kind_of_cut(true, true), "punched");
  EXPECT_EQ(kind_of_cut(true, false), "severed");
  EXPECT_EQ(kind_of_cut(false, false), "holed");
}

void expect_plug(const CutSummary& summary) {
  EXPECT_TRUE(summary.cut_through && summary.severed && summary.punched);
  EXPECT_TRUE(summary.bodies.at(0).cut.punched);
  EXPECT_EQ(summary.cut_through_time, 0.0);
}

TEST(Plug, BroaderThanTheJetCutsThrough) {
  for (const PunchedPlate& plate : punched_plates()) {
    for (const double half : {7.0 * mm, 12.0 * mm, 20.0 * mm})
      expect_plug(plate.judge(plug_between(-half, half)));
    expect_plug(plate.judge(plug_between(-7.0 * mm, 19.0 * mm)));
    expect_plug(plate.judge(plug_between(-19.0 * mm, 7.0 * mm)));
    expect_plug(plate.judge(plug_between(-8.0 * mm, 8.0 * mm, 10.0 * mm)));
    expect_plug(plate.judge(plug_between(-18.0 * mm, 18.0 * mm, -10.0 * mm)));
    // One crack begins below the jet, the other beyond it.
    expect_plug(plate.judge(plug_between(-1.0 * mm, 15.0 * mm, 8.0 * mm)));
  }
}

// A crack on one side alone leaves a flap, and one that is not all the way down holds.
TEST(Plug, ThatHangsOnASideIsNoCut) {
  for (const PunchedPlate& plate : punched_plates()) {
    EXPECT_FALSE(plate.judge(plug_between(-12.0 * mm, 1.0)).cut_through);
    EXPECT_FALSE(plate.judge(plug_between(-1.0, 12.0 * mm)).cut_through);
    const Region floor = [](const Position& x) {
      return x[1] < -15.0 * mm || std::abs(x[0]) > 12.0 * mm ? 1 : 0;
    };
    EXPECT_FALSE(plate.judge(floor).cut_through);
  }
}

// Ends that are torn off far away, by clamps, and rows that crumble at the edges are no cut.
TEST(Plug, OfMostOfThePlateIsNoCut) {
  for (const PunchedPlate& plate : punched_plates()) {
    EXPECT_FALSE(plate.judge(plug_between(-60.0 * mm, 60.0 * mm)).cut_through);
    EXPECT_FALSE(plate.judge(plug_between(-60.0 * mm, 12.0 * mm)).cut_through);
    EXPECT_FALSE(plate.judge(plug_between(-1.0, 1.0)).cut_through);
  }
  PunchedPlate narrow;
  narrow.half = 24.0 * mm;
  EXPECT_FALSE(narrow.judge(plug_between(-22.5 * mm, 22.5 * mm)).cut_through);
}

// The parts that a body has from the start are no rims; within them the jet may still punch.
TEST(Plug, PartsOfTheLayoutAreNoRims) {
  for (const PunchedPlate& plate : punched_plates()) {
    const Region parts = plug_between(-20.0 * mm, 20.0 * mm);
    EXPECT_FALSE(plate.judge(parts, parts).cut_through);
    const Region punched = [](const Position& x) {
      const double off = std::abs(x[0]);
      return off < 9.0 * mm ? 0 : off < 20.0 * mm ? (x[0] > 0.0 ? 1 : 2) : (x[0] > 0.0 ? 3 : 4);
    };
    expect_plug(plate.judge(punched, parts));
  }
}

// In space a plug of any outline is apart all around; one that hangs on an eighth of it is not.
TEST(Plug, InSpaceIsApartAllAround) {
  const auto round = [](const Position& x) {
    return std::hypot(x[0], x[2]) < 8.5 * mm - 0.2 * x[1] ? 0 : 1;
  };
  const auto square = [](const Position& x) {
    return std::max(std::abs(x[0]), std::abs(x[2])) < 9.0 * mm ? 0 : 1;
  };
  const auto aside = [](const Position& x) {
    return std::hypot(x[0] - 3.0 * mm, x[2] + 2.0 * mm) < 10.0 * mm ? 0 : 1;
  };
  const auto strip = [](const Position& x) {
    const double off = x[0] + 0.4 * x[2];
    return off < -8.0 * mm ? -1 : off > 8.0 * mm ? 1 : 0;
  };
  for (const double angle : {0.0, 0.4}) {
    PunchedPlate plate = PunchedPlate::in_space();
    plate.angle = angle;
    for (const Region& region : {Region(round), Region(square), Region(aside), Region(strip)})
      expect_plug(plate.judge(region));
    const auto hung = [&](const Position& x) {
      return x[0] > 0.0 && std::abs(x[2]) < 0.4 * x[0] ? 0 : round(x);
    };
    EXPECT_FALSE(plate.judge(hung).cut_through);
    const auto most = [](const Position& x) { return std::hypot(x[0], x[2]) < 24.0 * mm ? 0 : 1; };
    EXPECT_FALSE(plate.judge(most).cut_through);
    const auto corner = [](const Position& x) { return x[0] + x[2] < 20.0 * mm ? 0 : 1; };
    EXPECT_FALSE(plate.judge(corner).cut_through);
  }
}

// A nozzle that travels punches where it is, and not where it has not been.
TEST(Plug, IsWhereTheNozzleIs) {
  for (const double way : {1.0, -1.0}) {
    Case description = make_case(2);
    description.jets[0].traverse = {2.0 * way, 0.0, 0.0};
    Frame initial;
    add_box(initial, solid(), {-80.0 * mm, -20.0 * mm, 0.0}, {80.0 * mm, 0.0, 0.0});
    for (const double time : {0.0, 20e-3}) {
      Frame frame = initial;
      frame.time = time;
      bond(initial, frame, [&](const Position& x, const Position& y) {
        const Region plug = plug_between(30.0 * mm, 50.0 * mm);
        return plug({way * x[0], x[1], 0.0}) != plug({way * y[0], y[1], 0.0});
      });
      Frame before = initial;
      bond(before, before);
      add_water_beside_bonds(frame, description, 8.0 * mm);
      CutMonitor monitor(description, before);
      monitor.observe(frame);
      EXPECT_EQ(monitor.summary().punched, time > 0.0) << way;
    }
  }
}

}  // namespace
}  // namespace kerf
