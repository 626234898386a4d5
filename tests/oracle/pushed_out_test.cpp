// SPDX-License-Identifier: Apache-2.0
// A jet pushes a free block of gel out of the domain without a crack: no row of the run may say
// that it is cut, wherever the block and the jet are. In a larger domain the block stays whole.
#include <fmt/format.h>

#include "analysis/cut.hpp"
#include "analysis/kerf.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "support/runs.hpp"

namespace kerf::test {
namespace {

struct Push {
  double width = 12.0, height = 8.0, jet_at = 0.0, spacing = 0.8, floor = -20.0;  // mm

  Case description() const {
    return parse_case(fmt::format(R"(
title = "a block is pushed out"
dimension = 2
[time]
end = "24 ms"
[domain]
minimum = ["-40 mm", "{5} mm"]
maximum = ["40 mm", "30 mm"]
[materials.gel]
kind = "elastic"
density = "1030 kg/m3"
youngs_modulus = "40 kPa"
poisson_ratio = 0.45
criterion = "crack_band"
failure_strain = 0.1
fracture_energy = "4 J/m2"
source = "assumed, for this test"
[[body]]
name = "gel"
material = "gel"
shape = {{ type = "box", minimum = ["{0} mm", "0 mm"], maximum = ["{1} mm", "{2} mm"] }}
spacing = "{4} mm"
[[jet]]
name = "jet"
speed = "3 m/s"
width = "4 mm"
position = ["{3} mm", "{2} mm"]
standoff = "6 mm"
spacing = "{4} mm"
)",
                                  -width / 2.0, width / 2.0, height, jet_at, spacing, floor),
                      "push.toml");
  }
};

TEST(PushedOut, ABlockWithoutACrackIsNotCut) {
  for (const Push& push : {Push{}, Push{.width = 14.4, .height = 6.4, .jet_at = 1.3},
                           Push{.width = 8.0, .height = 12.0, .spacing = 1.0}}) {
    const Case c = push.description();
    const auto run = make_simulation(c);
    CutMonitor monitor(c, run->frame());
    while (run->time() < c.time.end) {
      take_steps(*run, 8);
      ASSERT_FALSE(monitor.observe(run->frame_of_cut()).cut_through) << run->time();
    }
    const CutSummary summary = monitor.summary();
    ASSERT_TRUE(summary.bodies.at(0).cut.left);
    const Kerf kerf = measure_kerf(monitor.workpiece(), run->frame(), kerf_conditions(c, summary));
    EXPECT_EQ(kerf.shape.depth, 0.0);
    EXPECT_NEAR(kerf.of<CutMargin>().value, -1.0, 1e-6);
  }
}

}  // namespace
}  // namespace kerf::test
