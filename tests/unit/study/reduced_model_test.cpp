// SPDX-License-Identifier: Apache-2.0
#include "study/reduced_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/random.hpp"

namespace kerf {
namespace {

ModelGoal model_goal(ModelForm form, std::vector<std::string> variables) {
  ModelGoal goal;
  goal.form = form;
  goal.drive = "machine.pressure";
  goal.variables = std::move(variables);
  return goal;
}

// Bone under a jet of 0.4 mm, den Dunnen et al., J. Mech. Behav. Biomed. Mater. 62 (2016) 495:
// depth in mm = 0.22 t^0.18 (1.2 - BV/TV) (P - 29), P in MPa, t in s.
double bone_depth(double pressure, double dwell, double volume_share) {
  return 1e-3 * 0.22 * std::pow(dwell, 0.18) * (1.2 - volume_share) * (1e-6 * pressure - 29.0);
}

TEST(ReducedModel, RecoversALineAboveAThreshold) {
  std::vector<ModelDatum> data;
  for (const double pressure : {20e6, 25e6, 40e6, 50e6, 60e6, 70e6})
    data.push_back(
        {{{"machine.pressure", pressure}}, std::max(0.0, bone_depth(pressure, 1.0, 0.3))});
  const ReducedModel model(model_goal(ModelForm::threshold_linear, {}), data);
  ASSERT_EQ(model.problem(), "");
  EXPECT_EQ(model.used(), 4);
  const auto parameters = model.parameters();
  EXPECT_NEAR(parameters[0].value / (0.22e-9 * 0.9), 1.0, 1e-9);
  EXPECT_NEAR(parameters[1].value / 29e6, 1.0, 1e-9);
  EXPECT_EQ(model.predict({{"machine.pressure", 25e6}}).value, 0.0);
  EXPECT_NEAR(model.predict({{"machine.pressure", 55e6}}).value / bone_depth(55e6, 1.0, 0.3), 1.0,
              1e-9);
}

TEST(ReducedModel, APowerLawWithAThresholdIsRecovered) {
  std::vector<ModelDatum> data;
  for (const double pressure : {40e6, 50e6, 70e6, 100e6})
    for (const double dwell : {1.0, 3.0, 5.0})
      data.push_back({{{"machine.pressure", pressure}, {"time.end", dwell}},
                      bone_depth(pressure, dwell, 0.3)});
  const ReducedModel model(model_goal(ModelForm::threshold_power, {"time.end"}), data);
  ASSERT_EQ(model.problem(), "");
  const auto parameters = model.parameters();
  EXPECT_NEAR(parameters[1].value / 29e6, 1.0, 1e-5);
  EXPECT_NEAR(parameters[2].value, 1.0, 1e-5);
  EXPECT_NEAR(parameters[3].value, 0.18, 1e-6);
  EXPECT_NEAR(model.predict({{"machine.pressure", 60e6}, {"time.end", 2.0}}).value /
                  bone_depth(60e6, 2.0, 0.3),
              1.0, 1e-6);
}

TEST(ReducedModel, APlainPowerLawIsRecovered) {
  std::vector<ModelDatum> data;
  for (const double pressure : {1e6, 2e6, 4e6})
    for (const double traverse : {0.01, 0.03})
      data.push_back({{{"machine.pressure", pressure}, {"machine.traverse_speed", traverse}},
                      3e-9 * std::pow(pressure, 1.25) * std::pow(traverse, -0.5)});
  const ReducedModel model(model_goal(ModelForm::power, {"machine.traverse_speed"}), data);
  ASSERT_EQ(model.problem(), "");
  EXPECT_NEAR(std::exp(model.parameters()[0].value) / 3e-9, 1.0, 1e-8);
  EXPECT_NEAR(model.parameters()[1].value, 1.25, 1e-9);
  EXPECT_NEAR(model.parameters()[2].value, -0.5, 1e-9);
}

// The threshold is a ratio of two fitted numbers: its interval must have its nominal coverage, 475
// of 500, within three standard deviations, 15, and 1% for the error of a ratio.
TEST(ReducedModel, TheIntervalOfTheThresholdCoversIt) {
  int covered = 0;
  for (std::uint64_t set = 0; set < 500; ++set) {
    std::vector<ModelDatum> data;
    std::uint64_t n = 0;
    for (double pressure = 35e6; pressure < 80e6; pressure += 5e6) {
      double error = -6.0;  // the sum of twelve uniform numbers is nearly normal
      for (int i = 0; i < 12; ++i) error += random_number(set, n++);
      data.push_back(
          {{{"machine.pressure", pressure}}, bone_depth(pressure, 1.0, 0.3) + 1e-4 * error});
    }
    const ReducedModel model(model_goal(ModelForm::threshold_linear, {}), data);
    const auto threshold = model.parameters()[1];
    covered += threshold.low <= 29e6 && 29e6 <= threshold.high;
  }
  EXPECT_NEAR(covered, 475, 20);
}

TEST(ReducedModel, TheTableCoversTheRangeOfTheData) {
  std::vector<ModelDatum> data;
  for (const double pressure : {40e6, 50e6, 60e6, 80e6})
    data.push_back({{{"machine.pressure", pressure}}, bone_depth(pressure, 1.0, 0.3)});
  ModelGoal goal = model_goal(ModelForm::threshold_linear, {});
  goal.table_points = 5;
  const ReducedModel model(goal, data);
  std::istringstream table(
      model.table_csv([](const std::string& name) { return name == "kerf.depth" ? "m" : "Pa"; }));
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0],
            "machine.pressure (Pa),kerf.depth (m),kerf.depth low (m),kerf.depth high (m)\r");
  EXPECT_EQ(std::stod(lines[1]), 40e6);
  EXPECT_EQ(std::stod(lines[5]), 80e6);
  EXPECT_NEAR(std::stod(lines[2].substr(lines[2].find(',') + 1)) / bone_depth(50e6, 1.0, 0.3), 1.0,
              1e-5);
}

TEST(ReducedModel, RunsWithoutACutAreExcluded) {
  const ReducedModel model(
      model_goal(ModelForm::threshold_linear, {}),
      {{{{"machine.pressure", 1e6}}, 0.0}, {{{"machine.pressure", 2e6}}, 0.0}});
  EXPECT_THAT(model.problem(), testing::HasSubstr("no run has kerf.depth above 0"));
}

TEST(ReducedModel, AConstantVariableIsReported) {
  std::vector<ModelDatum> data;
  for (const double pressure : {40e6, 50e6, 60e6, 80e6, 90e6})
    data.push_back(
        {{{"machine.pressure", pressure}, {"time.end", 1.0}}, bone_depth(pressure, 1.0, 0.3)});
  EXPECT_THAT(ReducedModel(model_goal(ModelForm::power, {"time.end"}), data).problem(),
              testing::HasSubstr("do not determine the parameters"));
  EXPECT_THAT(ReducedModel(model_goal(ModelForm::threshold_power, {"time.end"}), data).problem(),
              testing::HasSubstr("do not determine the parameters"));
}

}  // namespace
}  // namespace kerf
