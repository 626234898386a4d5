// SPDX-License-Identifier: Apache-2.0
// The memory that a run reports, and the estimate of `kerf check`, against the heap.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <ostream>

#include "analysis/derived.hpp"
#include "engine/device.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

constexpr std::string_view block = R"toml(
title = "A block"
dimension = {dimension}
formulation = "{formulation}"
precision = "{precision}"
[time]
end = "1 s"
[materials.still_water]
base = "water"
sound_speed = "20 m/s"
[[body]]
name = "block"
material = "{material}"
shape = {{ type = "box", minimum = [{minimum}], maximum = [{maximum}] }}
spacing = "1 mm"
{jitter}
)toml";

struct Block {
  const char* formulation;
  const char* material;
  int dimension;
  const char* precision = "mixed";
  double jitter = 0.0;
};

void PrintTo(const Block& of, std::ostream* out) {
  *out << of.material << " " << of.dimension << "D, " << of.formulation << ", " << of.precision
       << (of.jitter > 0.0 ? ", jittered" : "");
}

Case case_of(const Block& of) {
  const bool plane = of.dimension == 2;
  return parse_case(
      fmt::format(
          block, fmt::arg("dimension", of.dimension), fmt::arg("formulation", of.formulation),
          fmt::arg("precision", of.precision), fmt::arg("material", of.material),
          fmt::arg("jitter", of.jitter > 0.0 ? fmt::format("jitter = {}", of.jitter) : ""),
          fmt::arg("minimum", plane ? R"("0 mm", "0 mm")" : R"("0 mm", "0 mm", "0 mm")"),
          fmt::arg("maximum", plane ? R"("200 mm", "200 mm")" : R"("34 mm", "34 mm", "34 mm")")),
      "block");
}

// Bytes in use.
double heap() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

class Memory : public ::testing::TestWithParam<Block> {
 protected:
  // The program allocates threads, units and similar data once.
  static void SetUpTestSuite() { make_simulation(case_of({"standard", "tofu", 2}))->advance(); }
};

// The block has 40 000 particles, so that its faces and the constant data of a run are negligible.
// The report of a run omits the scratch memory of sums (1% at most); the estimate ignores faces,
// where particles have fewer neighbours (10% in 3D).
TEST_P(Memory, EstimateEqualsTheAllocation) {
  const double before = heap();
  if (before == 0.0) GTEST_SKIP() << "a sanitizer keeps the heap to itself";
  const Case description = case_of(GetParam());
  const auto simulation = make_simulation(description);
  simulation->advance();
  const double held = heap() - before;
  const auto particles = static_cast<double>(simulation->particles());
  EXPECT_NEAR(simulation->bytes_per_particle() * particles, held, 0.02 * held);
  EXPECT_NEAR(derive(description).particle_memory, held, 0.15 * held);
}

// The memory budget of a water particle in 3D in single precision, besides the list of its
// neighbours.
TEST(MemoryBudget, OfWater) {
  constexpr double budget = 400.0, entry = 4.0;  // bytes
  const auto simulation = make_simulation(case_of({"standard", "still_water", 3}));
  simulation->advance();
  const double spare = 1.0 + 1.0 / 8.0;  // of the list
  EXPECT_LE(
      simulation->bytes_per_particle() - entry * spare * simulation->neighbours_per_particle(),
      budget);
}

// The budget of a particle of a solid with all its bonds, in regular and other layouts.
TEST(MemoryBudget, OfSolid) {
  for (const double jitter : {0.0, 0.2}) {
    const auto simulation = make_simulation(case_of({"standard", "tofu", 3, "mixed", jitter}));
    simulation->advance();
    EXPECT_LE(simulation->bytes_per_particle(), 1024.0) << jitter;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Blocks, Memory,
    ::testing::Values(Block{"standard", "still_water", 2}, Block{"standard", "still_water", 3},
                      Block{"standard", "tofu", 2}, Block{"standard", "tofu", 3},
                      Block{"standard", "tofu", 3, "double"},
                      Block{"standard", "tofu", 2, "mixed", 0.2},
                      Block{"standard", "tofu", 3, "mixed", 0.2},
                      Block{"standard", "still_water", 3, "double"},
                      Block{"shinohara2004", "still_water", 2}, Block{"shinohara2004", "tofu", 3}));

}  // namespace
}  // namespace kerf
