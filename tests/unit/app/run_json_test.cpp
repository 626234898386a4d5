// SPDX-License-Identifier: Apache-2.0
// The JSON of `kerf run --json-summary` has the verdict, the numbers of the cut and the folder.
#include "app/run_json.hpp"

#include <gtest/gtest.h>

#include "output/files.hpp"
#include "output/result_metrics.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

class RunJson : public testing::Test {
 protected:
  void SetUp() override {
    test::run_fake(test::fake_case(), folder_.path());
    result_ = Json::parse(read_file(folder_ / "result.json"));
  }
  Json summary() const { return Json::parse(run_json(result_, folder_.path())); }

  test::TemporaryFolder folder_;
  Json result_;
};

TEST_F(RunJson, HasTheVerdictAndTheFiles) {
  const Json json = summary();
  EXPECT_EQ(json.at("verdict"), result_.at("verdict"));
  EXPECT_EQ(json.at("cut_through"), result_.at("cut_through"));
  EXPECT_EQ(json.at("case"), "fake");
  EXPECT_EQ(json.at("folder"), folder_.path().string());
  for (const char* file : {"report", "result"})
    EXPECT_TRUE(std::filesystem::exists(json.at(file).get<std::string>())) << file;
}

TEST_F(RunJson, EveryNumberIsAMetricOfTheResult) {
  const Json json = summary();
  for (const auto& [name, value] : json.at("metrics").items())
    EXPECT_NE(find_result_metric(name), nullptr) << name;
  EXPECT_EQ(json.at("metrics").at("kerf.depth"), result_.at("kerf").at("depth"));
  EXPECT_EQ(json.at("metrics").at("energy_drift"), result_.at("energy_drift"));
}

TEST_F(RunJson, HasNullForWhatTheRunDoesNotHave) {
  result_.erase("kerf");
  const Json json = summary();
  EXPECT_TRUE(json.at("metrics").at("kerf.depth").is_null());
  EXPECT_TRUE(json.at("bodies").empty());
}

TEST_F(RunJson, HasTheVerdictOnEachBody) {
  result_["kerf"]["layers"] = {
      {{"name", "skin"}, {"verdict", "parted"}, {"cut_through_time", 0.002}},
      {{"name", "bone"}, {"verdict", "whole"}}};
  const Json bodies = summary().at("bodies");
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].at("name"), "skin");
  EXPECT_EQ(bodies[0].at("cut_through_time"), 0.002);
  EXPECT_EQ(bodies[1].at("verdict"), "whole");
  EXPECT_TRUE(bodies[1].at("cut_through_time").is_null());
}

TEST_F(RunJson, WarnsOfWhatIsBeyondItsLimit) {
  result_["validity"] = {{{"name", "leak"}, {"state", "warning"}, {"sentence", "It leaks."}},
                         {{"name", "mach"}, {"state", "good"}, {"sentence", "It is slow."}}};
  const Json warnings = summary().at("warnings");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].at("name"), "leak");
}

}  // namespace
}  // namespace kerf
