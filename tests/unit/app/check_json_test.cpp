// SPDX-License-Identifier: Apache-2.0
// The JSON of `kerf check` has the numbers of the case in SI units.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/check_json.hpp"
#include "input/read.hpp"

namespace kerf {
namespace {

CheckedCase checked(double memory) {
  const std::string text = R"(
title = "Jet on a block"
dimension = 2
time.end = "4 ms"
[materials.soft]
base = "tofu"
[[body]]
name = "block"
material = "soft"
shape = { type = "box", minimum = ["-20 mm", "0 mm"], maximum = ["20 mm", "20 mm"] }
spacing = "1 mm"
[[jet]]
name = "jet"
speed = "5 m/s"
width = "10 mm"
position = ["0 mm", "20 mm"]
standoff = "5 mm"
spacing = "1 mm"
)";
  Case description = parse_case(text, "block.toml", quick_look);
  const DerivedNumbers numbers = derive(description);
  const Pace pace = typical_pace(description, 1);
  return {{text, "block.toml", std::move(description), numbers, pace},
          {"A sentence."},
          {"A warning."},
          memory};
}

TEST(CheckJson, HasTheNumbersAndTheCost) {
  const auto json = nlohmann::json::parse(check_json(checked(1e12)));
  EXPECT_EQ(json.at("case"), "block.toml");
  EXPECT_EQ(json.at("simulated").at(0), "A sentence.");
  EXPECT_EQ(json.at("warnings").at(0), "A warning.");
  EXPECT_DOUBLE_EQ(json.at("numbers").at("jet_speed"), 5.0);
  const auto& cost = json.at("cost");
  EXPECT_EQ(cost.at("initial_particles"), 800);
  EXPECT_DOUBLE_EQ(cost.at("simulated_time"), 4e-3);
  EXPECT_NEAR(cost.at("steps").get<double>() * cost.at("time_step").get<double>(), 4e-3, 1e-5);
  EXPECT_GT(cost.at("run_time"), 0.0);
  EXPECT_EQ(cost.at("run_time_threads"), 1);
  EXPECT_TRUE(json.at("advice").empty());
}

// The run time is told with the threads for which it holds.
TEST(CheckJson, RunTimeNamesItsThreads) {
  const CostedCase costed = checked(1e12).costed;
  for (const int threads : {1, 8}) {
    const Pace pace = typical_pace(costed.description, threads);
    const std::string text = run_time_text(run_cost(costed.numbers, pace), pace);
    EXPECT_NE(text.find(threads == 1 ? " on 1 thread, by" : " on 8 threads, by"), std::string::npos)
        << text;
  }
}

TEST(CheckJson, AdvisesWhereTheCostIsTooMuch) {
  const auto json = nlohmann::json::parse(check_json(checked(1.0)));
  ASSERT_FALSE(json.at("advice").empty());
  const auto& advice = json.at("advice").at(0);
  EXPECT_FALSE(advice.at("keys").empty());
  EXPECT_LT(advice.at("cost").at("memory"), json.at("cost").at("memory"));
}

}  // namespace
}  // namespace kerf
