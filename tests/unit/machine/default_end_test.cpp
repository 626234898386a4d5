// SPDX-License-Identifier: Apache-2.0
// How long a run over a [workpiece] is, and how long it goes on after the cut, by default.
#include <gtest/gtest.h>

#include <cmath>

#include "input/read.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

Case gel_case(const std::string& machine_keys, const std::string& more = "") {
  return parse_case(R"(title = "Gel of 2 mm"
dimension = 2
quality = "draft"
[machine]
pressure = "10 MPa"
orifice_diameter = "0.4 mm"
standoff = "3 mm"
)" + machine_keys + R"(
[workpiece]
material = "gelatin-10"
size = ["100 mm", "2 mm"]
)" + more,
                    "gel.toml");
}

// A nozzle at rest has twice the time of a passage, whether it has a feed or not.
TEST(DefaultEnd, IsTheSameWithAndWithoutAFeed) {
  const Case feeding = gel_case("traverse_speed = \"1 mm/s\""), resting = gel_case("");
  EXPECT_NEAR(resting.time.end, 2.0 * passage_time(resting.jets[0], 2e-3), 1e-12);
  EXPECT_EQ(resting.time.end, feeding.time.end);
  EXPECT_TRUE(std::isfinite(resting.time.after_cut));
  EXPECT_EQ(resting.time.after_cut, feeding.time.after_cut);
}

// The last water of the exposure w / u is at the far face at the latest when the run ends, also of
// an inclined jet and however thin the workpiece is.
TEST(DefaultEnd, HoldsTheWaterOfTheExposure) {
  for (const std::string more : {"", "lead_angle = \"30 deg\"\n"}) {
    const Case gel = gel_case("traverse_speed = \"20 m/s\"\nmotion = \"standing\"\n" + more);
    const Jet& jet = gel.jets[0];
    const double flight = jet.standoff / jet.speed, way = 2e-3 / std::cos(jet.angle);
    const double exposure = exposure_time(*gel.machine, jet, 2);
    EXPECT_GT(gel.time.end, flight + exposure + way / jet.speed);
    EXPECT_LT(gel.time.end, flight + exposure + 1.5 * way / jet.speed);
  }
}

// An end that is stated without a feed is that of the run, cut or not.
TEST(DefaultEnd, AStatedEndIsKept) {
  const std::string end = "[time]\nend = \"70 us\"\n";
  EXPECT_TRUE(std::isinf(gel_case("", end).time.after_cut));
  EXPECT_TRUE(std::isfinite(gel_case("traverse_speed = \"1 mm/s\"", end).time.after_cut));
  EXPECT_EQ(gel_case("", end + "after_cut = \"1 us\"\n").time.after_cut, 1e-6);
}

}  // namespace
}  // namespace kerf
