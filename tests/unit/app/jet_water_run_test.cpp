// SPDX-License-Identifier: Apache-2.0
// A run never holds more particles than are told for it, also where its water fills the domain.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/derived.hpp"
#include "engine/device.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace jet_water_run {

std::string wall(const char* name, const char* minimum, const char* maximum) {
  return fmt::format(
      "[[body]]\nname = \"{}\"\nrole = \"rigid\"\nspacing = \"1 mm\"\n"
      "shape = {{ type = \"box\", minimum = [{}], maximum = [{}] }}\n",
      name, minimum, maximum);
}

// A jet of 4 mm and 5 m/s, from above at (0, 12 mm).
std::string jet_into(const std::string& bodies, const char* end) {
  return fmt::format(
             "title = \"filling\"\ndimension = 2\n[time]\nend = \"{}\"\n[domain]\n"
             "minimum = [\"-12 mm\", \"-3 mm\"]\nmaximum = [\"12 mm\", \"18 mm\"]\n[[jet]]\n"
             "name = \"jet\"\nspeed = \"5 m/s\"\nwidth = \"4 mm\"\nspacing = \"1 mm\"\n"
             "position = [\"0 mm\", \"0 mm\"]\nstandoff = \"12 mm\"\n",
             end) +
         bodies;
}

struct Counts {
  double told = 0.0, most = 0.0, emitted = 0.0;
};

Counts counts_of(const std::string& text) {
  const Case description = parse_case(text, "my.toml");
  Counts counts;
  counts.told = static_cast<double>(derive(description).particles_expected);
  counts.emitted = 5.0 * 4e-3 * description.time.end / 1e-6;
  const auto simulation = make_simulation(description);
  while (!simulation->finished()) {
    simulation->advance();
    counts.most = std::max(counts.most, static_cast<double>(simulation->particles()));
  }
  return counts;
}

// The cup holds 14 mm x 10 mm, and the jet brings twice as much.
TEST(JetWaterRun, CupThatOverflows) {
  const std::string cup = wall("floor", "\"-9 mm\", \"-2 mm\"", "\"9 mm\", \"0 mm\"") +
                          wall("left", "\"-9 mm\", \"0 mm\"", "\"-7 mm\", \"10 mm\"") +
                          wall("right", "\"7 mm\", \"0 mm\"", "\"9 mm\", \"10 mm\"");
  const Counts counts = counts_of(jet_into(cup, "15 ms"));
  EXPECT_GT(counts.most, 76.0 + 100.0);  // it fills
  EXPECT_LE(counts.most, counts.told);
  EXPECT_LT(counts.most, counts.emitted);
}

TEST(JetWaterRun, PlateThatTurnsTheJetAside) {
  const Counts counts =
      counts_of(jet_into(wall("plate", "\"-9 mm\", \"-2 mm\"", "\"9 mm\", \"0 mm\""), "100 ms"));
  EXPECT_LE(counts.most, counts.told);
  EXPECT_LT(counts.told, 0.5 * counts.emitted);
}

}  // namespace jet_water_run
}  // namespace kerf
