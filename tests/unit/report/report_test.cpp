// SPDX-License-Identifier: Apache-2.0
#include "report/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "app/run_loop.hpp"
#include "case/write_used.hpp"
#include "core/error.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using test::message_of;
using testing::AllOf;
using testing::HasSubstr;

// A whole run of the made-up simulation, and the page it ends with.
class Report : public testing::Test {
 protected:
  void SetUp() override {
    description_.title = "Cut <of> & \"tofu\"";
    test::run_fake(description_, out_);
    page_ = read_file(out_ / "report.html");
  }
  test::TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "out";
  Case description_ = test::fake_case();
  std::string page_;
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++found;
  return found;
}

TEST_F(Report, HoldsVerdictPicturesCurvesAndTables) {
  const auto result = nlohmann::json::parse(read_file(out_ / "result.json"));
  EXPECT_THAT(page_, AllOf(HasSubstr(result.at("verdict").get<std::string>()),
                           HasSubstr("Cut &lt;of&gt; &amp; &quot;tofu&quot;"),
                           HasSubstr("Abrasive is not modelled."), HasSubstr("mass_initial"),
                           HasSubstr("acoustic (water)"), HasSubstr("Pressure at the probes"),
                           HasSubstr("Taken away, as laid out")));
  EXPECT_EQ(count(page_, "src=\"data:image/png;base64,iVBOR"), 3u);
  EXPECT_EQ(count(page_, "<svg"), 9u);
  EXPECT_EQ(count(page_, "<table>"), 8u);
}

TEST_F(Report, NeedsNothingFromOutside) {
  EXPECT_FALSE(std::regex_search(page_, std::regex("<(link|iframe|script[^>]*src)")));
  // Names of formats (xmlns) are not fetched; every other address must be inside the page.
  const std::regex address("(src|href)=\"[^d#][^\"]{0,60}");
  std::string outside;
  for (std::sregex_iterator it(page_.begin(), page_.end(), address), end; it != end; ++it)
    outside += it->str() + "\n";
  EXPECT_EQ(outside, "");
}

TEST_F(Report, IdsAreUnique) {
  std::set<std::string> ids;
  std::size_t found = 0;
  const std::regex id("\\sid=\"([^\"]+)\"");
  for (std::sregex_iterator it(page_.begin(), page_.end(), id), end; it != end; ++it, ++found)
    ids.insert((*it)[1]);
  EXPECT_EQ(ids.size(), found);
  EXPECT_GT(found, 0u);
}

TEST_F(Report, MadeAgainItIsTheSame) {
  std::filesystem::remove(out_ / "report.html");
  write_report(out_, description_);
  EXPECT_EQ(read_file(out_ / "report.html"), page_);
}

TEST_F(Report, SaysWhatIsMissingOrDamaged) {
  const auto refusal = [&] {
    return message_of<UserError>([&] { write_report(out_, description_); });
  };
  const std::string result = read_file(out_ / "result.json");
  write_file(out_ / "result.json", result.substr(0, result.size() / 2));
  EXPECT_THAT(refusal(), AllOf(HasSubstr("result.json is damaged"), HasSubstr("--resume")));
  std::filesystem::remove(out_ / "result.json");
  EXPECT_THAT(refusal(), AllOf(HasSubstr("has not ended yet"), HasSubstr("--resume")));
  write_file(out_ / "result.json", result);
  std::filesystem::remove(out_ / "pictures/fake_01.png");
  EXPECT_THAT(refusal(), HasSubstr("fake_01.png"));
}

}  // namespace
}  // namespace kerf
