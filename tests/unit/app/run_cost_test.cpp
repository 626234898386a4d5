// SPDX-License-Identifier: Apache-2.0
// The cost of a run is told for any case within a bounded time, and what is advised is accepted and
// gains what is said.
#include "app/run_cost.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <random>

#include "app/check_warnings.hpp"
#include "app/cost_advice.hpp"
#include "app/measured_pace.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

double cost_processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Returns the largest memory that the process has had, bytes.
double largest_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

struct Piece {
  double pressure = 200e6;                            // Pa
  double orifice = 0.15e-3;                           // m
  double length = 0.01, height = 0.01, depth = 0.01;  // m
  double spacing = 0.0;                               // m; 0 = the default
  double traverse = 0.0;                              // m/s
  int levels = 0;
};

std::string piece_text(const Piece& piece, int dimension) {
  const auto point = [&](double x, double y, double z) {
    return dimension == 2 ? fmt::format("[\"{:.9g} m\", \"{:.9g} m\"]", x, y)
                          : fmt::format("[\"{:.9g} m\", \"{:.9g} m\", \"{:.9g} m\"]", x, y, z);
  };
  return fmt::format(
      R"(title = "a piece"
dimension = {}
[machine]
pressure = "{:.9g} Pa"
orifice_diameter = "{:.9g} m"
standoff = "2 mm"
position = {}
traverse_speed = "{:.9g} m/s"
{}
[[body]]
name = "piece"
material = "tofu"
shape = {{ type = "box", minimum = {}, maximum = {} }}
{}
[domain]
minimum = {}
maximum = {}
)",
      dimension, piece.pressure, piece.orifice, point(0.0, piece.height, 0.0), piece.traverse,
      piece.spacing > 0.0 ? fmt::format("spacing = \"{:.9g} m\"", piece.spacing) : "",
      point(-0.5 * piece.length, 0.0, -0.5 * piece.depth),
      point(0.5 * piece.length, piece.height, 0.5 * piece.depth),
      piece.levels > 0 ? fmt::format("grading = {{ levels = {}, width = \"{:.9g} m\" }}",
                                     piece.levels, 4.0 * piece.orifice)
                       : "",
      point(-10.0, -10.0, -10.0), point(10.0, 10.0, 10.0));
}

CostedCase costed(const std::string& text) {
  CostedCase result;
  result.text = text;
  result.file = "my.toml";
  result.description = parse_case(text, result.file, quick_look);
  result.numbers = derive(result.description);
  result.pace = typical_pace(result.description, 1);
  return result;
}

// All that `kerf check` does but for the pilot run, whose size is bounded by itself.
TEST(RunCost, IsToldForAnySizeInABoundedTimeAndMemory) {
  constexpr double most_time = 5.0, most_memory = 200e6;  // s, bytes
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
  };
  std::vector<std::pair<Piece, int>> pieces;
  for (int n = 0; n < 40; ++n) {
    Piece piece;
    piece.pressure = between(1e4, 1e9);
    piece.orifice = between(2e-5, 1e-2);
    piece.length = between(1e-3, 5.0);
    piece.height = between(1e-3, 1.0);
    piece.depth = between(1e-3, 5.0);
    piece.spacing = n % 3 == 0 ? 0.0 : piece.orifice / between(4.0, 1e4);
    piece.traverse = n % 4 == 0 ? between(1e-4, 1e-1) * 0.1 : 0.0;
    piece.levels = n % 5;
    pieces.emplace_back(piece, 2 + n % 2);
  }
  Piece extreme;
  extreme.length = 0.3, extreme.height = 0.01, extreme.depth = 0.2, extreme.spacing = 1e-5;
  pieces.emplace_back(extreme, 3);
  const double before = largest_memory();
  int answered = 0;
  for (const auto& [piece, dimension] : pieces) {
    const std::string text = piece_text(piece, dimension);
    const double start = cost_processor_time();
    try {
      const CostedCase each = costed(text);
      const RunCost cost = run_cost(each.numbers, each.pace);
      EXPECT_TRUE(cost.seconds > 0.0 && std::isfinite(cost.seconds)) << text;
      EXPECT_TRUE(cost.memory > 0.0 && std::isfinite(cost.memory)) << text;
      check_warnings(each.description, each.numbers);
      resolution_warnings(each.description);
      particle_rows(each.description);
      advice_text(each, 8e9);
      ++answered;
    } catch (const std::exception& error) {
      // A moving nozzle may leave the domain, and more than 1e15 particles are refused at once.
      const std::string told = error.what();
      EXPECT_TRUE(told.find("leaves the domain") != std::string::npos ||
                  told.find("Allowed: at most 5e+08 particles") != std::string::npos)
          << told;
    }
    EXPECT_LT(cost_processor_time() - start, most_time) << text;
  }
  EXPECT_GE(answered, 30);
  EXPECT_LT(largest_memory() - before, most_memory);
}

TEST(RunCost, AdviceIsAcceptedAndGainsWhatIsSaid) {
  for (const int dimension : {2, 3}) {
    Piece piece;
    piece.spacing = dimension == 2 ? 2e-6 : 1e-5;
    const CostedCase before = costed(piece_text(piece, dimension));
    const RunCost cost = run_cost(before.numbers, before.pace);
    ASSERT_GT(cost.seconds, long_run);
    const std::vector<Advice> advice = cost_advice(before);
    ASSERT_GE(advice.size(), dimension == 2 ? 4u : 5u);
    for (const Advice& each : advice) {
      const CostedCase after = costed(each.text);
      const RunCost then = run_cost(after.numbers, after.pace);
      EXPECT_NEAR(then.seconds, each.after.seconds, 1e-6 * then.seconds) << each.sentence();
      EXPECT_EQ(then.memory, each.after.memory) << each.sentence();
      EXPECT_LT(then.seconds, cost.seconds / 1.1) << each.sentence();
    }
    EXPECT_LT(advice.back().after.seconds, cost.seconds / 100.0) << advice.back().sentence();
  }
}

// Twice the spacing: 4 and 8 times fewer particles, and steps that are twice as long.
TEST(RunCost, DoubleSpacingGainsThePowersOfTwo) {
  for (const int dimension : {2, 3}) {
    Piece piece;
    piece.spacing = 1e-5;
    piece.length = piece.height = piece.depth = 4e-3;
    const CostedCase before = costed(piece_text(piece, dimension));
    bool found = false;
    for (const Advice& each : cost_advice(before)) {
      if (each.lines.front() != "[machine] spacing = \"0.02 mm\"" || each.lines.size() > 1)
        continue;
      found = true;
      const double fewer = std::pow(2.0, dimension);
      EXPECT_NEAR(each.before.particles / each.after.particles, fewer, 0.05 * fewer);
      EXPECT_NEAR(each.before.steps / each.after.steps, 2.0, 0.02);
    }
    EXPECT_TRUE(found);
  }
}

TEST(RunCost, CheapCasesGetNoAdvice) {
  Piece small;
  small.length = small.height = 2e-3;
  const CostedCase cheap = costed(piece_text(small, 2));
  ASSERT_LT(run_cost(cheap.numbers, cheap.pace).seconds, long_run);
  EXPECT_EQ(advice_text(cheap, 8e9), "");
  EXPECT_NE(advice_text(cheap, 1.0), "");
}

// The plane x = 0 halves the particles of a case that is drawn whole: also those of its jet.
TEST(RunCost, SymmetryPlanesHalveTheParticles) {
  std::string whole = piece_text({}, 3);
  const CostedCase before = costed(whole);
  const std::string corner = "minimum = [\"-10 m\", \"-10 m\", \"-10 m\"]";
  ASSERT_NE(whole.find(corner), std::string::npos);
  whole.replace(whole.find(corner), corner.size(),
                "symmetry = [\"x-\", \"z-\"]\nminimum = [\"0 m\", \"-10 m\", \"0 m\"]");
  const CostedCase quarter = costed(whole);
  const auto ratio = static_cast<double>(before.numbers.particles_expected) /
                     static_cast<double>(quarter.numbers.particles_expected);
  EXPECT_NEAR(ratio, 4.0, 0.05);
  const auto water = [](const DerivedNumbers& numbers) {
    return static_cast<double>(numbers.particles_expected - numbers.particles_initial);
  };
  EXPECT_NEAR(water(before.numbers) / water(quarter.numbers), 4.0, 0.01);
}

// Fifty times as many rows of series.csv: the rows that are added take what a pilot run says of
// each.
TEST(RunCost, RowsOfTheSeriesCount) {
  Piece small;
  small.length = small.height = 2e-3;
  const std::string text = piece_text(small, 2);
  const CostedCase few = costed(text + "[output]\nseries_interval = \"0.1 us\"\n"),
                   many = costed(text + "[output]\nseries_interval = \"0.002 us\"\n");
  const Pace pace = measured_pace(many.description, many.numbers, 1);
  EXPECT_GT(pace.particle_row, 0.01 * pace.particle_step);
  EXPECT_LT(pace.particle_row, 10.0 * pace.particle_step);
  const double rows = many.description.time.end * (1.0 / 2e-9 - 1.0 / 1e-7);
  const auto seconds_with = [&](const CostedCase& costed) {
    Pace same = pace;
    same.rows = costed.pace.rows;
    return run_cost(costed.numbers, same).seconds;
  };
  const double added = rows * pace.particle_row * run_cost(many.numbers, pace).particles;
  EXPECT_NEAR(seconds_with(many) - seconds_with(few), added, 1e-6 * added);
}

TEST(RunCost, PilotsAreSmall) {
  for (const double spacing : {1e-4, 1e-5, 1e-6}) {
    Piece piece;
    piece.spacing = spacing;
    const CostedCase each = costed(piece_text(piece, 3));
    const DerivedNumbers pilot = derive(pilot_case(each.description, each.numbers));
    EXPECT_LT(static_cast<double>(pilot.particles_initial), 2e4);
    EXPECT_GE(pilot.jet_resolution, 1.0);
  }
}

}  // namespace
}  // namespace kerf
