// SPDX-License-Identifier: Apache-2.0
// The comparison of two runs has both and what differs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "output/files.hpp"
#include "report/metric_rows.hpp"
#include "report/report.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Comparison, HasBothRunsAndTheLinesThatDiffer) {
  const test::TemporaryFolder folder;
  Case slow = test::fake_case(), fast = test::fake_case();
  slow.title = "Slow <jet>";
  fast.title = "Fast jet";
  fast.smoothing_ratio = 1.25;
  test::run_fake(slow, folder / "slow");
  test::run_fake(fast, folder / "fast");
  auto result = nlohmann::ordered_json::parse(read_file(folder / "fast/result.json"));
  result["front_depth"] = 0.0123;
  write_file(folder / "fast/result.json", result.dump());
  write_comparison({folder / "slow", slow}, {folder / "fast", fast});
  const std::string page = read_file(folder / "slow/compare.html");
  EXPECT_THAT(page, AllOf(HasSubstr("<h2>Slow &lt;jet&gt;</h2>"), HasSubstr("<h2>Fast jet</h2>"),
                          HasSubstr("12.3\u202fmm</td><td>"), HasSubstr("smoothing_ratio = 1.25")));
  // Lines that both cases have are left out.
  EXPECT_THAT(page, Not(HasSubstr("\ndimension = ")));
}

// A key that several tables have is told with its table, and known as equal only in the same one.
TEST(Comparison, DifferingLinesHaveTheHeadingsOfTheirTables) {
  const test::TemporaryFolder folder;
  const Case description = test::fake_case();
  for (const char* name : {"a", "b"}) test::run_fake(description, folder / name);
  const auto text_of = [](const char* block, const char* jet) {
    return std::string("title = \"one\"\n[[body]]\nname = \"block\"\nspacing = \"") + block +
           " m\"\n[[jet]]\nname = \"jet\"\nspacing = \"" + jet + " m\"\n";
  };
  write_file(folder / "a/case.used.toml", text_of("0.1", "0.2"));
  write_file(folder / "b/case.used.toml", text_of("0.2", "0.1"));
  write_comparison({folder / "a", description}, {folder / "b", description});
  const std::string page = read_file(folder / "a/compare.html");
  const std::string block = "[[body]]  # name = &quot;block&quot;\nspacing = &quot;0.1 m&quot;\n",
                    jet = "[[jet]]  # name = &quot;jet&quot;\nspacing = &quot;0.2 m&quot;\n";
  EXPECT_THAT(page, HasSubstr(block + jet));
  EXPECT_THAT(page, Not(HasSubstr("title = ")));
}

TEST(Comparison, TellsTheDifferenceOfSharesInPercentagePoints) {
  const ResultMetric& margin = *find_result_metric("kerf.margin");
  const auto result = [](double value) {
    return nlohmann::ordered_json{{"dimension", 2}, {"kerf", {{"margin", value}}}};
  };
  EXPECT_EQ(difference_html(result(0.241), result(-1.0), margin), "−124 percentage points");
  EXPECT_EQ(difference_html(result(-1.0), result(0.241), margin), "+124 percentage points");
  EXPECT_EQ(difference_html(result(0.5), result(0.5), margin), "0");
}

TEST(Comparison, TellsTheDifference) {
  const ResultMetric& depth = *find_result_metric("front_depth");
  const auto result = [](nlohmann::ordered_json value) {
    return nlohmann::ordered_json{{"dimension", 2}, {"front_depth", std::move(value)}};
  };
  EXPECT_EQ(difference_html(result(0.010), result(0.012), depth), "+2\u202fmm (+20\u202f%)");
  EXPECT_EQ(difference_html(result(0.010), result(0.009), depth), "−1\u202fmm (−10\u202f%)");
  EXPECT_EQ(difference_html(result(0.0), result(0.012), depth), "+12\u202fmm");
  EXPECT_EQ(difference_html(result(0.01), result(0.01), depth), "0");
  EXPECT_EQ(difference_html(result(nullptr), result(0.01), depth), "");
}

TEST(Comparison, ADamagedResultIsNamed) {
  const test::TemporaryFolder folder;
  const Case description = test::fake_case();
  test::run_fake(description, folder / "a");
  test::run_fake(description, folder / "b");
  const auto file = folder / "b/result.json";
  const std::string whole = read_file(file);
  auto other = nlohmann::ordered_json::parse(whole);
  other["title"] = 3;
  for (const std::string& content : {whole.substr(0, whole.size() / 2), other.dump()}) {
    write_file(file, content);
    EXPECT_THAT(test::message_of<UserError>([&] {
                  write_comparison({folder / "a", description}, {folder / "b", description});
                }),
                AllOf(HasSubstr(file.string() + " is damaged"), HasSubstr("--resume")));
  }
}

}  // namespace
}  // namespace kerf
