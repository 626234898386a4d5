// SPDX-License-Identifier: Apache-2.0
// The ends of what a study searches are valid cases before its first run.
#include "study/search_ends.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "study/case_maker.hpp"
#include "study/study_runs.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic.hpp"

namespace kerf::search_ends_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class NoExecutor : public Executor {
 public:
  void run(const std::vector<Job>&, JobWatcher&) override { ADD_FAILURE() << "a run was made"; }
  int side_by_side() const override { return 1; }
};

// Returns the refusal of the ends of a study.
std::string refusal(const std::string& text) {
  const StudyPlan plan = test::plan_of(text);
  const test::TemporaryFolder folder;
  const CaseMaker maker(plan);
  StudyDatabase database(folder / "study.db");
  NoExecutor executor;
  const StudyRuns runs(folder.path(), maker, database, executor, {}, false);
  return test::message_of<UserError>([&] { runs.refuse_invalid(search_ends(plan)); });
}

// Above 8 mm the nozzle is in the block.
std::string height_up_to(const std::string& end) {
  return "\"body.block.shape.maximum.1\"\nfrom = \"4 mm\"\nto = \"" + end + "\"\n";
}

TEST(SearchEnds, AnEndWithoutAValidCaseIsRefused) {
  const std::string search = "[search]\nfind = \"greatest\"\ndraft = 1\nkey = ";
  EXPECT_THAT(refusal(search + height_up_to("30 mm")),
              AllOf(HasSubstr("my-study.toml: with body.block.shape.maximum.1 = 30 mm the case is "
                              "not valid"),
                    HasSubstr("jet")));
  EXPECT_EQ(refusal(search + height_up_to("6 mm")), "");
}

TEST(SearchEnds, TheCornersOfAnOptimumAreChecked) {
  const auto vary = [](const std::string& height) {
    return "[vary]\n\"jet.jet.speed\" = { from = \"2 m/s\", to = \"10 m/s\" }\n"
           "\"body.block.shape.maximum.1\" = { from = \"4 mm\", to = \"" +
           height + "\" }\n[search]\nfind = \"minimum\"\nmetric = \"kerf.depth\"\n";
  };
  EXPECT_THAT(refusal(vary("30 mm")),
              AllOf(HasSubstr("jet.jet.speed = 2 m/s, body.block.shape.maximum.1 = 30 mm"),
                    HasSubstr("jet.jet.speed = 10 m/s, body.block.shape.maximum.1 = 30 mm")));
  EXPECT_EQ(refusal(vary("6 mm")), "");
  EXPECT_EQ(search_ends(test::plan_of(vary("6 mm"))).size(), 8u);  // four, also as drafts
}

TEST(SearchEnds, APredictionOfACalibrationIsChecked) {
  const auto calibrate = [](const std::string& height) {
    return "[calibrate]\nkey = \"materials.curd.fracture_energy\"\nfrom = \"1 J/m2\"\n"
           "to = \"9 J/m2\"\nmetric = \"kerf.depth\"\nmeasured = \"3 mm\"\n"
           "[[calibrate.predict]]\n\"body.block.shape.maximum.1\" = \"" +
           height + "\"\n";
  };
  EXPECT_THAT(refusal(calibrate("30 mm")), HasSubstr("body.block.shape.maximum.1 = 30 mm"));
  EXPECT_EQ(refusal(calibrate("6 mm")), "");
}

TEST(SearchEnds, AGridHasNone) {
  EXPECT_TRUE(search_ends(test::plan_of("[vary]\n\"jet.jet.speed\" = [\"1 m/s\"]\n")).empty());
}

}  // namespace
}  // namespace kerf::search_ends_test
