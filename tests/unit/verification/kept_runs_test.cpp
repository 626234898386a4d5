// SPDX-License-Identifier: Apache-2.0
// Runs of `kerf verify` that are kept, and runs that are not reused.
#include "verification/kept_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "output/files.hpp"
#include "support/flight.hpp"
#include "support/temporary_folder.hpp"
#include "verification/verify.hpp"

namespace kerf {
namespace {

using test::flight;

std::string kept_plan(const std::string& axis, const std::string& reference,
                      const std::string& of_run = "") {
  return R"(
title = "flight"
[[run]]
name = "plain, 2 mm"
picture = "0.05 ms"
)" + of_run +
         R"(
[[check]]
runs = "plain, 2 mm"
quantity = "speed"
signal = "body_mean"
field = "velocity"
reduce = "last"
unit = "m/s"
si_unit = "m/s"
source = "Newton"
tolerance = 0.01
axis = ")" +
         axis + "\"\nreference = " + reference + "\n";
}

class KeptRunsTest : public testing::Test {
 protected:
  // Runs the plan; `made_` then states whether its run was computed.
  Findings findings_of(const std::string& plan) {
    const EmbeddedText texts[] = {{"flight/case", flight}, {"flight/reference", plan}};
    const auto cases = read_verification_cases(texts, {});
    made_ = false;
    return verify(
        cases.at(0), true, [this](const std::string&, double) { made_ = true; },
        KeptRuns(folder_.path() / "kept"));
  }
  std::filesystem::path kept_file() const {
    return folder_.path() / "kept" / "flight" / "plain-2-mm.cbor";
  }

  test::TemporaryFolder folder_;
  bool made_ = false;
};

TEST_F(KeptRunsTest, IsReusedWithTheSameResult) {
  const Findings first = findings_of(kept_plan("x", "3"));
  EXPECT_TRUE(made_);
  const Findings second = findings_of(kept_plan("x", "3"));
  EXPECT_FALSE(made_);
  ASSERT_EQ(second.rows.size(), 1u);
  EXPECT_EQ(second.rows[0].measured, first.rows[0].measured);
  EXPECT_EQ(second.rows[0].seconds, first.rows[0].seconds);
  EXPECT_EQ(second.rows[0].verdict, Verdict::pass);
  ASSERT_EQ(second.images.size(), 1u);
  EXPECT_EQ(second.images[0].frame.time, first.images[0].frame.time);
  EXPECT_EQ(second.images[0].frame.position, first.images[0].frame.position);
}

TEST_F(KeptRunsTest, IsCheckedAgain) {
  findings_of(kept_plan("x", "3"));
  const Findings findings = findings_of(kept_plan("x", "4"));
  EXPECT_FALSE(made_);
  EXPECT_EQ(findings.rows.at(0).verdict, Verdict::fail);
}

TEST_F(KeptRunsTest, OfAnotherCaseOrSignalIsRun) {
  findings_of(kept_plan("x", "3"));
  EXPECT_EQ(findings_of(kept_plan("y", "3")).rows.at(0).measured, 0.0);
  EXPECT_TRUE(made_);
  findings_of(kept_plan("y", "3", "refine = 2"));
  EXPECT_TRUE(made_);
  findings_of(kept_plan("y", "3", "refine = 2\noverride.time.end = \"0.2 ms\""));
  EXPECT_TRUE(made_);
}

TEST_F(KeptRunsTest, DamagedRecordingIsRunAgain) {
  findings_of(kept_plan("x", "3"));
  std::string bytes = read_file(kept_file());
  write_file(kept_file(), bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(findings_of(kept_plan("x", "3")).rows.at(0).verdict, Verdict::pass);
  EXPECT_TRUE(made_);
  findings_of(kept_plan("x", "3"));
  EXPECT_FALSE(made_);
  std::filesystem::remove(kept_file().replace_extension(".vtkhdf"));
  findings_of(kept_plan("x", "3"));
  EXPECT_TRUE(made_);
}

TEST_F(KeptRunsTest, LongRecordingServesAsAShortOne) {
  const std::string plan = kept_plan("x", "3", "long = true\n");
  const EmbeddedText texts[] = {{"flight/case", flight}, {"flight/reference", plan}};
  const KeptRuns kept(folder_.path() / "kept");
  const auto rows = [&] {
    auto verification = read_verification_cases(texts, {}).at(0);
    take_up_kept(verification, kept);
    return verify(
               verification, false, [](const std::string&, double) {}, kept)
        .rows.size();
  };
  EXPECT_EQ(rows(), 0u);
  findings_of(plan);
  EXPECT_EQ(rows(), 1u);
}

// NaN is a value of a signal where there is nothing to measure.
TEST_F(KeptRunsTest, KeepsWhatIsNotANumber) {
  const KeptRuns kept(folder_.path());
  Recording recording;
  recording.series.push_back({{0.0, 1.0}, {std::numeric_limits<double>::quiet_NaN(), 2.0}});
  kept.keep("case", PlannedRun(), {}, recording);
  const auto found = kept.find("case", PlannedRun(), {});
  ASSERT_TRUE(found);
  EXPECT_TRUE(std::isnan(found->series.at(0).value.at(0)));
  EXPECT_EQ(found->series.at(0).value.at(1), 2.0);
}

TEST_F(KeptRunsTest, DoesNotKeepAFailedRun) {
  const KeptRuns kept(folder_.path());
  Recording recording;
  recording.problem = "it broke down";
  kept.keep("case", PlannedRun(), {}, recording);
  EXPECT_FALSE(kept.find("case", PlannedRun(), {}));
}

}  // namespace
}  // namespace kerf
