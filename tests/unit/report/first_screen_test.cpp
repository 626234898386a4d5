// SPDX-License-Identifier: Apache-2.0
// The first screen of a report answers an operator: what was cut, and how fast the nozzle may go.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/files.hpp"
#include "report/report.hpp"
#include "report/report_parts.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class FirstScreen : public testing::Test {
 protected:
  void SetUp() override {
    test::run_fake(description_, out_);
    result_ = nlohmann::ordered_json::parse(read_file(out_ / "result.json"));
  }
  std::string screen() const { return first_screen(result_, description_, "<img>"); }
  void set_feeds(const nlohmann::ordered_json& certain, const nlohmann::ordered_json& possible) {
    result_["exposure"] = {{"greatest_feed", certain}, {"possible_feed", possible}};
  }

  test::TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "study/runs/0001";
  Case description_ = test::fake_case();
  nlohmann::ordered_json result_;
};

TEST_F(FirstScreen, NamesEachBodyAndItsFate) {
  result_["kerf"]["layers"] = {{{"name", "skin"},
                                {"verdict", "cut through"},
                                {"through", true},
                                {"cut_through_time", 0.002}},
                               {{"name", "<bone>"},
                                {"verdict", "whole"},
                                {"through", false},
                                {"cut_through_time", nullptr}}};
  EXPECT_THAT(
      screen(),
      AllOf(
          HasSubstr("<li class=\"yes\"><b>✓</b><span><strong>skin</strong> cut through after "
                    "2\u202fms</span></li>"),
          HasSubstr("<li class=\"no\"><b>✗</b><span><strong>&lt;bone&gt;</strong> whole</span>")));
}

TEST_F(FirstScreen, NamesTheOnlyBodyToo) {
  result_["kerf"]["layers"] = nlohmann::ordered_json::array();
  result_["cut_through"] = false;
  result_["fractured_fraction"] = 0.1;
  EXPECT_THAT(screen(), HasSubstr("cut in part"));
  result_["fractured_fraction"] = 0.0;
  result_["kerf"]["margin"] = -0.4;
  EXPECT_THAT(screen(), HasSubstr("cut in part"));
  result_["kerf"]["margin"] = -1.0;
  EXPECT_THAT(screen(), AllOf(HasSubstr("whole"), Not(HasSubstr("cut in part"))));
}

TEST_F(FirstScreen, TellsAPlugFromACrack) {
  result_["kerf"]["layers"] = nlohmann::ordered_json::array();
  result_["kerf"]["through"] = false;
  result_["kerf"]["through_share"] = 0.0;
  result_["cut_through"] = true;
  result_["cut_through_time"] = 0.002;
  result_["cut_through_by"] = "severed";
  EXPECT_THAT(screen(), HasSubstr("✓</b><span><strong>block</strong> parted after"));
  result_["cut_through_by"] = "punched";
  EXPECT_THAT(screen(), HasSubstr("✓</b><span><strong>block</strong> punched out after"));
}

TEST_F(FirstScreen, NamesABodyThatWasPushedOutOrMissed) {
  result_["kerf"]["layers"] = nlohmann::ordered_json::array();
  result_["cut_through"] = false;
  result_["fractured_fraction"] = 1.0;  // fractured or gone
  result_["kerf"]["margin"] = -1.0;
  result_["kerf"]["removed_volume"] = 0.0;
  EXPECT_THAT(screen(), HasSubstr("whole"));
  result_["kerf"]["removed_volume"] = 1e-9;
  EXPECT_THAT(screen(), HasSubstr("cut in part"));
  result_["kerf"]["thickness"] = 0.0;
  EXPECT_THAT(screen(), HasSubstr("<b>·</b>"));
  EXPECT_THAT(screen(), HasSubstr("not under the jet"));
}

TEST_F(FirstScreen, AnswersHowFastTheNozzleMayGo) {
  EXPECT_THAT(screen(), Not(HasSubstr("How fast")));
  set_feeds(0.05, 0.08);
  EXPECT_THAT(screen(),
              HasSubstr("The cut is certain up to <strong>50\u202fmm/s (3000\u202fmm/min)</strong> "
                        "and possible up to <strong>80\u202fmm/s (4800\u202fmm/min)</strong>."));
  set_feeds(25.0, 97.9);  // of 1 500 000 and more mm/min
  EXPECT_THAT(screen(),
              HasSubstr("up to <strong>25\u202fm/s (1500\u202fm/min)</strong> and possible up to "
                        "<strong>97.9\u202fm/s (5874\u202fm/min)</strong>."));
  set_feeds(0.05, 0.08);
  result_["exposure"]["exponent"] = 0.9;  // of a depth that is carried on
  EXPECT_THAT(screen(), HasSubstr("The cut is expected up to <strong>50"));
  set_feeds(nullptr, 0.08);
  EXPECT_THAT(screen(), HasSubstr("No feed is certain to cut; the cut is possible up to"));
  set_feeds(nullptr, nullptr);
  EXPECT_THAT(screen(), HasSubstr("This run shows no feed at which the jet cuts through."));
  result_["exposure"]["may_cut"] = true;  // the run does not reach its exposure
  EXPECT_THAT(screen(), HasSubstr("This run tells no feed: it ends before it shows whether"));
}

TEST_F(FirstScreen, StandsAboveTheNumbersAndTheBalanceIsFolded) {
  const std::string page = report_page(out_, description_, {});
  EXPECT_LT(page.find("<div class=\"first\">"), page.find("<dl class=\"figures\">"));
  const std::size_t folded = page.find("<details class=\"balance\">");
  ASSERT_NE(folded, std::string::npos);
  EXPECT_LT(folded, page.find("<code>mass_initial</code>"));
  EXPECT_LT(page.find("<code>mass_initial</code>"), page.find("</details>", folded));
}

TEST_F(FirstScreen, TheRunOfAStudyLinksBack) {
  const char* link = "<a href=\"../../study.html\">";
  EXPECT_THAT(report_page(out_, description_, {}), Not(HasSubstr(link)));
  write_file(folder_ / "study/study.db", "");
  EXPECT_THAT(report_page(out_, description_, {}), HasSubstr(link));
}

// A curve in percent is not a plain number: the script writes the unit at its axis.
TEST_F(FirstScreen, CurvesInPercentHaveThatUnit) {
  const std::string page = report_page(out_, description_, {});
  EXPECT_THAT(page, AllOf(HasSubstr("fractured mass / %"), HasSubstr("error / %"),
                          Not(HasSubstr(" in %"))));
}

}  // namespace
}  // namespace kerf
