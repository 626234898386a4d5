// SPDX-License-Identifier: Apache-2.0
#include "app/later_end.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "output/series.hpp"
#include "support/fake_simulation.hpp"
#include "support/results.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class LaterEnd : public testing::Test {
 protected:
  // Runs the case of the fake simulation up to an end in whole ms, with stated intervals of the
  // output or those that follow from the end.
  void run_to(const std::string& name, int end, Existing existing, bool states_intervals = true) {
    std::string text = test::fake_case_text;
    text.replace(text.find("10 ms"), 5, std::to_string(end) + " ms");
    for (const std::string line : {"frame_interval = \"1 ms\"\n", "series_interval = \"0.2 ms\"\n"})
      if (!states_intervals) text.erase(text.find(line), line.size());
    RunLoopSettings settings =
        settings_of_case(parse_case(text, "fake.toml"), "fake.toml", folder_ / name);
    settings.existing = existing;
    settings.quiet = true;
    continue_to_later_end(settings);
    const auto make = [](const Case& description) {
      auto simulation = std::make_unique<test::FakeSimulation>(description);
      simulation->cut_end = 16e-3;
      return simulation;
    };
    RunLoop(settings, make).run();
  }
  std::string text_of(const std::string& file) { return read_file(folder_ / file); }

  test::TemporaryFolder folder_;
};

TEST_F(LaterEnd, GivesTheBitsOfARunThatHadItFromTheStart) {
  run_to("full", 20, Existing::refuse);
  run_to("a", 10, Existing::refuse);
  EXPECT_EQ(nlohmann::json::parse(text_of("a/result.json")).at("end_time"), 0.01);
  run_to("a", 20, Existing::resume);
  test::expect_same_results(folder_ / "full", folder_ / "a");
  EXPECT_EQ(text_of("full/case.used.toml"), text_of("a/case.used.toml"));
  run_to("a", 20, Existing::resume);  // it has finished already
  test::expect_same_results(folder_ / "full", folder_ / "a");
}

TEST_F(LaterEnd, KeepsTheIntervalsOfTheOutput) {
  run_to("a", 10, Existing::refuse, false);
  run_to("a", 20, Existing::resume, false);
  const Case used = parse_case(text_of("a/case.used.toml"), "case.used.toml");
  EXPECT_EQ(used.time.end, 0.02);
  EXPECT_EQ(used.output.series_interval, 0.01 / 500.0);
  const auto result = nlohmann::json::parse(text_of("a/result.json"));
  EXPECT_EQ(result.at("end_time"), 0.02);
  EXPECT_EQ(result.at("frames"), 41);  // 20 in each half, and that of the start
  const std::string before = text_of("a/result.json");
  run_to("a", 20, Existing::resume, false);  // it has finished already
  EXPECT_EQ(text_of("a/result.json"), before);
}

TEST_F(LaterEnd, IsRefusedBesideOtherChanges) {
  run_to("a", 10, Existing::refuse);
  const auto refusal = [&](int end) {
    return test::message_of<UserError>([&] { run_to("a", end, Existing::resume); });
  };
  EXPECT_THAT(refusal(8), AllOf(HasSubstr("belongs to another case"), HasSubstr("--out")));
  Case other = parse_case(test::fake_case_text, "fake.toml");
  other.time.end = 0.02;
  other.jets.front().speed = 6.0;
  RunLoopSettings settings = settings_of_case(other, "fake.toml", folder_ / "a");
  settings.existing = Existing::resume;
  const std::string text = settings.case_text;
  continue_to_later_end(settings);
  EXPECT_EQ(settings.case_text, text);
  EXPECT_TRUE(settings.continued_text.empty());
}

}  // namespace
}  // namespace kerf
