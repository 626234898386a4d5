// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "input/read.hpp"
#include "output/files.hpp"
#include "study/case_maker.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string complaint(const std::string& text) {
  return test::message_of<UserError>([&] { test::plan_of(text); });
}

const std::string vary = "[vary]\n\"jet.jet.speed\" = [\"1 m/s\", \"2 m/s\"]\n";

TEST(ReadStudy, TakesKeysInQuotesAndSpreadOverTables) {
  const StudyPlan plan = test::plan_of(
      "title = \"t\"\nrefine = 0.5\n[set]\ntime.end = \"3 ms\"\n[vary]\njet.jet.speed = \"1 "
      "m/s\"\n[vary.jet.jet.width]\nfrom = \"4 mm\"\nto = \"0.8 cm\"\ncount = 2\n");
  ASSERT_EQ(plan.axes.size(), 2u);
  EXPECT_EQ(plan.axes[0].name(), "jet.jet.speed");
  EXPECT_EQ(plan.axes[1].values, (std::vector<double>{0.004, 0.008}));
  EXPECT_EQ(plan.refinement, 0.5);
  const CaseMaker maker(plan);
  EXPECT_THAT(maker.make({{}, 0, 1.0}).text, HasSubstr("end = \"0.003 s\""));
}

TEST(ReadStudy, NamesFileLineKeyValueRangeAndRemedy) {
  EXPECT_THAT(complaint("[vary]\n\"jet.jet.speed\" = [\"1 m/s\", \"2 s\"]\n"),
              AllOf(StartsWith("my-study.toml:3: vary.jet.jet.speed = "), HasSubstr("\"2 s\""),
                    HasSubstr("not the unit of a speed"), HasSubstr("Allowed: a speed"),
                    HasSubstr("Write a text such as")));
  EXPECT_THAT(complaint("[vary]\n\"jet.jet.speed\" = [\"-1 m/s\"]\n"),
              AllOf(HasSubstr("\"-1 m/s\" is out of range"), HasSubstr("Allowed: a speed")));
  EXPECT_THAT(complaint("refin = 2\n" + vary),
              AllOf(StartsWith("my-study.toml:2: refin = 2: a study has no such key here"),
                    HasSubstr("Did you mean \"refine\"?")));
  EXPECT_THAT(complaint("refine = 1000\n" + vary), HasSubstr("from 0.01 to 100"));
  EXPECT_THAT(complaint("[vary]\n\"jet.jet.speed\" = { from = \"2 m/s\", to = \"1 m/s\" }\n"),
              HasSubstr("from = \"2 m/s\" is not less than to = \"1 m/s\""));
  EXPECT_THAT(complaint("[vary]\n\"jet.jet.position\" = [\"1 mm\"]\n"),
              HasSubstr("cannot vary this key as a whole"));
  EXPECT_THAT(complaint(""), HasSubstr("nothing is varied"));
  EXPECT_THAT(
      complaint("[vary]\n\"jet.jet.speeed\" = [\"1 m/s\", \"2 m/s\"]\n"),
      testing::AllOf(HasSubstr("jet.jet.speeed"), testing::Not(HasSubstr("nothing is varied"))));
  EXPECT_THAT(complaint(vary + "[design]\ntype = \"sobol\"\n"),
              HasSubstr("design.runs: the key is missing"));
  EXPECT_THAT(complaint(vary + "[design]\ntype = \"sobel\"\n"), HasSubstr("\"latin_hypercube\""));
}

TEST(ReadStudy, KeysOfMaterialsThatNothingHasAreRefused) {
  const std::string of_tofu = "\"materials.tofu.failure_strain\" = [0.1, 0.2]\n";
  EXPECT_THAT(complaint("[vary]\n" + of_tofu),
              AllOf(StartsWith("my-study.toml:3: vary.materials.tofu.failure_strain"),
                    HasSubstr("no body and no jet has the material \"tofu\""),
                    HasSubstr("used are \"curd\", \"gelatin-10\", \"water\"")));
  EXPECT_EQ(complaint("[vary]\n\"body.block.material\" = [\"curd\", \"tofu\"]\n" + of_tofu), "");
  EXPECT_EQ(complaint("[set]\n\"body.block.material\" = \"tofu\"\n[vary]\n" + of_tofu), "");
  EXPECT_THAT(complaint("[search]\nfind = \"greatest\"\nfrom = 0.1\nto = 0.2\n"
                        "key = \"materials.tofu.failure_strain\"\n"),
              HasSubstr("search.key"));
}

TEST(ReadStudy, ACaseIsNoStudyAndAStudyIsNoCase) {
  EXPECT_THAT(test::message_of<UserError>([] { parse_study(test::small_case, "dir/my.toml", {}); }),
              AllOf(StartsWith("dir/my.toml:2: dimension = 2: this is a case"),
                    HasSubstr("\"kerf run dir/my.toml\""), HasSubstr("base = \"my.toml\"")));
  EXPECT_THAT(
      test::message_of<UserError>([] { parse_case("base = \"my.toml\"\n" + vary, "s.toml"); }),
      AllOf(StartsWith("s.toml:2: vary: this is a study"), HasSubstr("\"kerf study s.toml\""),
            testing::Not(HasSubstr("dimension"))));
}

TEST(ReadStudy, KeysThatCannotVaryAreRefused) {
  const std::string search =
      "[search]\nfind = \"least\"\nkey = \"jet.jet.width\"\nfrom = \"2 mm\"\nto = \"4 mm\"\n";
  EXPECT_THAT(complaint(vary + search), HasSubstr("neither the search nor the calibration"));
  EXPECT_EQ(complaint(vary + search + "[design]\ntype = \"grid\"\n"), "");
  EXPECT_EQ(complaint(search), "");
}

TEST(ReadStudy, GoalsAreChecked) {
  EXPECT_THAT(complaint("[search]\nfind = \"leest\"\n"), HasSubstr("\"greatest\""));
  EXPECT_THAT(complaint("[search]\nfind = \"least\"\nkey = \"jet.jet.width\"\nfrom = \"2 mm\"\n"),
              HasSubstr("a range needs two numbers"));
  EXPECT_THAT(complaint(vary + "[search]\nfind = \"minimum\"\nmetric = \"kerf.depth\"\n"),
              HasSubstr("[vary] has a list"));
  EXPECT_THAT(complaint(vary + "[model]\nform = \"threshold_linear\"\n"),
              HasSubstr("model.drive: the key is missing"));
  EXPECT_THAT(complaint("[calibrate]\nkey = \"materials.curd.fracture_energy\"\nfrom = \"0 J/m2\"\n"
                        "to = \"9 J/m2\"\nmetric = \"kerf.depth\"\nmeasured = \"3 s\"\n"),
              AllOf(HasSubstr("calibrate.from"), HasSubstr("calibrate.measured = \"3 s\"")));
  EXPECT_THAT(
      complaint("[search]\nfind = \"least\"\nkey = \"jet.jet.width\"\nfrom = \"2 mm\"\nto = \"4 "
                "mm\"\nwhere = { metric = \"kerf.specific_energy\", at_most = \"2 J\" }\n"),
      HasSubstr("\"J\" is not the unit of an energy per volume"));
}

TEST(ReadStudy, MetricsThatNoResultHasAreRefused) {
  const auto is_refused =
      AllOf(HasSubstr("there is no metric \"kerf.dept\""), HasSubstr("docs/metrics.md"),
            HasSubstr("Did you mean \"kerf.depth\"?"));
  EXPECT_THAT(complaint("metrics = [\"kerf.margin\", \"kerf.dept\"]\n" + vary), is_refused);
  const std::string range = "[vary]\n\"jet.jet.speed\" = { from = \"1 m/s\", to = \"2 m/s\" }\n";
  EXPECT_THAT(complaint(range + "[search]\nfind = \"minimum\"\nmetric = \"kerf.dept\"\n"),
              AllOf(HasSubstr("search.metric"), is_refused));
  EXPECT_THAT(complaint("[search]\nfind = \"least\"\nkey = \"jet.jet.speed\"\nfrom = \"1 m/s\"\n"
                        "to = \"2 m/s\"\nwhere = { metric = \"kerf.dept\", at_least = 1 }\n"),
              AllOf(HasSubstr("search.where.metric"), is_refused));
}

TEST(ReadStudy, MetricsThatAreNoNumbersAreRefused) {
  const std::string range = "[vary]\n\"jet.jet.speed\" = { from = \"1 m/s\", to = \"2 m/s\" }\n";
  const auto of_search = [&](const std::string& metric) {
    return complaint(range + "[search]\nfind = \"minimum\"\nmetric = \"" + metric + "\"\n");
  };
  EXPECT_THAT(of_search("verdict"),
              AllOf(StartsWith("my-study.toml:6: search.metric = \"verdict\""),
                    HasSubstr("\"verdict\" is a text and no number"), HasSubstr("Name a number")));
  EXPECT_THAT(of_search("pictures"), HasSubstr("is a list or table and no number"));
  EXPECT_THAT(of_search("balance.mass"), HasSubstr("there is no metric"));
  EXPECT_THAT(of_search("kerf"), HasSubstr("there is no metric \"kerf\""));
  EXPECT_EQ(of_search("cut_through"), "");
  EXPECT_THAT(complaint("metrics = [\"title\"]\n" + vary), HasSubstr("\"title\" is a text"));
  EXPECT_THAT(complaint(vary + "[model]\ndrive = \"jet.jet.sped\"\n"),
              AllOf(HasSubstr("model.drive"), HasSubstr("Did you mean \"jet.jet.speed\"?")));
  EXPECT_THAT(complaint(vary + "[model]\ndrive = \"jet.jet.speed\"\nvariables = [\"title\"]\n"),
              HasSubstr("model.variables"));
  EXPECT_EQ(complaint(vary + "[model]\ndrive = \"stagnation_pressure\"\n"), "");
}

TEST(ReadStudy, AMissingBaseIsNamedWithASuggestion) {
  const EmbeddedText templates[] = {{"small", test::small_case}};
  EXPECT_THAT(test::message_of<UserError>(
                  [&] { parse_study("base = \"smal\"\n" + vary, "s.toml", templates); }),
              AllOf(StartsWith("s.toml:1: base = \"smal\""), HasSubstr("mean \"small\"?")));
}

TEST(ReadStudy, ABaseMayBeAFileBesideTheStudy) {
  const test::TemporaryFolder folder;
  write_file(folder / "mine.toml", test::small_case);
  write_file(folder / "study.toml", "base = \"mine.toml\"\n" + vary);
  EXPECT_EQ(read_study(folder / "study.toml", {}).axes.size(), 1u);
}

// A seed has an effect if the layout or the flaws are random; otherwise all repeats are one run.
TEST(ReadStudy, RepeatsOfADeterministicRunAreRefused) {
  EXPECT_THAT(complaint("repeats = 3\n" + vary),
              AllOf(HasSubstr("all repeats are the same run"), HasSubstr("jitter")));
  const std::string jitter = "[set]\n\"body.block.jitter\" = 0.2\n";
  EXPECT_EQ(complaint("repeats = 3\n" + jitter + vary), "");
  EXPECT_EQ(complaint("repeats = 1\n" + vary), "");
}

TEST(CaseMaker, AKeyMayBeVariedOverNone) {
  const StudyPlan plan = test::plan_of("[vary]\n\"jet.jet.stop\" = [\"none\", \"1 ms\"]\n");
  ASSERT_EQ(plan.axes.size(), 1u);
  EXPECT_EQ(plan.axes[0].levels(), 2u);
  const CaseMaker maker(plan);
  Trial none, stopped;
  plan.axes[0].put_level(0, none.setting);
  plan.axes[0].put_level(1, stopped.setting);
  EXPECT_EQ(maker.make(none).id, maker.make({}).id) << "no end is the default";
  EXPECT_THAT(maker.make(stopped).text, HasSubstr("stop = \"0.001 s\""));
  EXPECT_THROW(test::plan_of("[vary]\n\"jet.jet.stop\" = [\"none\", \"1 kg\"]\n"), UserError);
  EXPECT_THROW(test::plan_of("[vary]\n\"jet.jet.speed\" = [\"none\", \"1 m/s\"]\n"), UserError);
}

TEST(CaseMaker, EqualCasesHaveEqualNames) {
  const CaseMaker by_name(test::plan_of(vary));
  const CaseMaker by_number(test::plan_of("[vary]\n\"jet.0.speed\" = [\"100 cm/s\"]\n"));
  const auto one = by_name.make({{{{"jet.jet.speed", 1.0}}, {}}, 0, 1.0});
  EXPECT_EQ(one.id, by_number.make({{{{"jet.0.speed", 1.0}}, {}}, 0, 1.0}).id);
  EXPECT_NE(one.id, by_name.make({{{{"jet.jet.speed", 2.0}}, {}}, 0, 1.0}).id);
  EXPECT_NE(one.id, by_name.make({{{{"jet.jet.speed", 1.0}}, {}}, 0, 2.0}).id);
  EXPECT_NE(one.id, by_name.make({{{{"jet.jet.speed", 1.0}}, {}}, 1, 1.0}).id);
  EXPECT_EQ(one.spacing, 0.002);
  EXPECT_EQ(by_name.make({{}, 0, 2.0}).spacing, 0.001);
}

TEST(ReadStudy, ASetThatMakesTheCaseInvalidIsNamedWithItsFile) {
  EXPECT_THAT(complaint("[set]\ntime.end = \"2p ms\"\n" + vary),
              AllOf(StartsWith("my-study.toml: with [set] the case is not valid:\n"),
                    HasSubstr("\n  time.end = \"2p ms\": the unit")));
}

TEST(CaseMaker, ReportsAnInvalidCaseByTheKeysOfTheStudy) {
  const EmbeddedText templates[] = {{"small", test::small_case}};
  const CaseMaker maker(parse_study("base = \"small\"\n[vary]\n\"jet.jet.standoff\" = [\"2 mm\"]\n",
                                    "runs/my-study.toml", templates));
  const std::string message = test::message_of<UserError>([&] {
    maker.make({{{{"jet.jet.standoff", -0.5}}, {}}, 0, 1.0});
  });
  EXPECT_THAT(message, AllOf(StartsWith("runs/my-study.toml: with jet.jet.standoff = -500 mm"),
                             HasSubstr("not valid")));
}

}  // namespace
}  // namespace kerf
