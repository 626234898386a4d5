// SPDX-License-Identifier: Apache-2.0
// The windows of a frame that travels with the nozzle, against hand-computed places and times.
#include "machine/travelling_frame.hpp"

#include "input/write_used.hpp"
#include "output/piece_reasons.hpp"
#include "support/travelling.hpp"

namespace kerf {
namespace {

using test::TravellingText;

// A window of 40 mm, 5 mm a shift, from -120 mm to the edge at 200 mm: 280 mm are ahead.
TEST(TravellingFrame, ShiftsWithThePathOfTheNozzle) {
  const auto frame = travelling_frame(TravellingText{}.read());
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->axis, 0u);
  EXPECT_EQ(frame->most, 56u);
  EXPECT_NEAR(frame->path.maximum[0], 0.2, 1e-12);
  EXPECT_EQ(frame->shifts_due(0.0), 0u);
  EXPECT_EQ(frame->shifts_due(0.499e-3), 0u);
  EXPECT_EQ(frame->shifts_due(0.501e-3), 1u);
  EXPECT_EQ(frame->shifts_due(2.501e-3), 5u);
  EXPECT_EQ(frame->shifts_due(1.0), 56u);
  EXPECT_NEAR(frame->window(5).minimum[0], -95e-3, 1e-12);
  EXPECT_NEAR(frame->end_time(), 57 * 0.5e-3, 1e-12);
}

TEST(TravellingFrame, TravelsBackwardsAndAfterADwell) {
  TravellingText text;
  text.machine = "traverse_speed = \"10 m/s\"\ntraverse_direction = [-1, 0]\ndwell = \"1 ms\"";
  const auto frame = travelling_frame(text.read());
  EXPECT_EQ(frame->sign, -1.0);
  EXPECT_EQ(frame->most, 16u);  // of 120 mm - 40 mm
  EXPECT_EQ(frame->shifts_due(1.4e-3), 0u);
  EXPECT_EQ(frame->shifts_due(1.6e-3), 1u);
  EXPECT_NEAR(frame->window(2).maximum[0], -90e-3, 1e-12);
}

// The nozzle of the shifted case is at the same places at the same times.
TEST(TravellingFrame, ShiftedCaseHasTheSamePath) {
  const Case description = TravellingText{}.read();
  const Case shifted = at_shift(description, 6);
  const auto place = [](const Case& c, double time) {
    return c.jets[0].position[0] + c.jets[0].traverse[0] * (time - c.jets[0].dwell);
  };
  EXPECT_NEAR(place(shifted, 3e-3), place(description, 3e-3), 1e-12);
  EXPECT_GT(shifted.jets[0].dwell, 0.0);
  EXPECT_NEAR(shifted.domain.minimum[0], description.domain.minimum[0] + 30e-3, 1e-12);
  EXPECT_NEAR(shifted.bodies[0].shape.box.minimum[0], -90e-3, 1e-12);
}

TEST(TravellingFrame, WindowIsChosenInWholeCells) {
  for (const int dimension : {2, 3}) {
    TravellingText text;
    text.dimension = dimension;
    std::string written = text.text();
    for (const std::string key : {"minimum", "maximum", "shift"}) {
      const auto first = written.find(key + " = ");
      written.erase(first, written.find('\n', first) + 1 - first);
    }
    const std::string time = "end = \"3 ms\"";
    written.replace(written.find(time), time.size(), "stop = \"stationary\"");
    const Case chosen = parse_case(written, "case.toml");
    const auto frame = travelling_frame(chosen);
    ASSERT_TRUE(frame);
    EXPECT_EQ(chosen.machine->motion, NozzleMotion::travelling);
    EXPECT_EQ(chosen.workpiece->levels, dimension == 2 ? 0 : chosen.workpiece->levels);
    const double cell = coarsest_cell(*chosen.workpiece);
    const double length = frame->first.maximum[0] - frame->first.minimum[0];
    EXPECT_NEAR(length / cell, std::round(length / cell), 1e-9);
    EXPECT_NEAR(frame->shift / cell, std::round(frame->shift / cell), 1e-9);
    EXPECT_NEAR(frame->shift, length / 8.0, cell);
    EXPECT_NEAR(chosen.time.end, frame->end_time(), 1e-12);
    // The written case is the same.
    EXPECT_EQ(parse_case(write_used(chosen), "case.used.toml"), chosen);
    EXPECT_NE(piece_reasons(chosen).back().find("fed in ahead"), std::string::npos);
  }
}

}  // namespace
}  // namespace kerf
