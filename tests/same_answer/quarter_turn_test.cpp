// SPDX-License-Identifier: Apache-2.0
// A set-up that is turned by a right angle, which maps its lattice onto itself, breaks alike: no
// rule of fracture may depend on the order of the axes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "input/read.hpp"
#include "model/case.hpp"
#include "simulation/run_settings.hpp"
#include "support/runs.hpp"

namespace kerf::test {
namespace quarter_turn {

using Place = std::array<double, 2>;  // mm

// The case turned clockwise by a number of right angles about the origin.
class Turned {
 public:
  explicit Turned(int turns) : turns_(turns) {}

  Case description() const {
    return parse_case(fmt::format(R"(title = "a block cracks under a jet"
dimension = 2
formulation = "standard"
precision = "double"
time.end = "0.8 ms"
domain.minimum = ["-26 mm", "-26 mm"]
domain.maximum = ["26 mm", "26 mm"]
[materials.gel]
kind = "elastic"
density = "1000 kg/m3"
youngs_modulus = "200 kPa"
poisson_ratio = 0.45
criterion = "crack_band"
failure_strain = 0.3
fracture_energy = "5 J/m2"
[[body]]
name = "block"
material = "gel"
shape = {}
spacing = "0.8 mm"
[[body]]
name = "table"
role = "rigid"
shape = {}
spacing = "0.8 mm"
[[jet]]
name = "jet"
speed = "12 m/s"
width = "4 mm"
spacing = "0.8 mm"
position = {}
standoff = "4 mm"
angle = "{} deg"
)",
                                  box({-16.0, 0.0}, {16.0, 8.0}), box({-20.8, -2.4}, {20.8, 0.0}),
                                  point({0.0, 8.0}), turns_ == 3 ? 90 : -90 * turns_),
                      "turned.toml");
  }

 private:
  Place turned(Place place) const {
    for (int n = 0; n < turns_; ++n) place = {place[1], -place[0]};
    return place;
  }
  std::string point(const Place& place) const {
    const Place at = turned(place);
    return fmt::format("[\"{} mm\", \"{} mm\"]", at[0] + 0.0, at[1] + 0.0);
  }
  std::string box(const Place& from, const Place& to) const {
    const Place a = turned(from), b = turned(to);
    const auto corner = [&](const double& (*choose)(const double&, const double&)) {
      return fmt::format("[\"{} mm\", \"{} mm\"]", choose(a[0], b[0]) + 0.0,
                         choose(a[1], b[1]) + 0.0);
    };
    return fmt::format("{{ type = \"box\", minimum = {}, maximum = {} }}", corner(std::min<double>),
                       corner(std::max<double>));
  }
  int turns_;
};

// Rounding grows in a run that fractures, up to 1e-9 here.
TEST(QuarterTurn, BreaksAlike) {
  double energy = 0.0;
  for (int turns = 0; turns < 4; ++turns) {
    const auto simulation = make_simulation(Turned(turns).description());
    while (!simulation->finished()) simulation->advance();
    const double dissipated = simulation->balance().dissipated_fracture;
    std::printf("turned by %d right angles: %.12g J/m\n", turns, dissipated);
    if (turns == 0) energy = dissipated;
    EXPECT_GT(dissipated, 0.01);
    EXPECT_NEAR(dissipated, energy, 1e-6 * energy);
  }
}

}  // namespace quarter_turn
}  // namespace kerf::test
