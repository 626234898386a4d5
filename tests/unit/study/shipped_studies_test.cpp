// SPDX-License-Identifier: Apache-2.0
// Every study of cases/studies/ is valid, and the ends of its ranges are valid cases.
#include <gtest/gtest.h>

#include "app/embedded.hpp"
#include "study/case_maker.hpp"
#include "study/run_table.hpp"
#include "study/search_ends.hpp"

namespace kerf {
namespace {

TEST(ShippedStudies, MakeValidCases) {
  ASSERT_GE(study_templates().size(), 4u);
  for (const EmbeddedText& entry : study_templates()) {
    const StudyPlan plan =
        parse_study(std::string(entry.text), std::string(entry.name) + ".toml", case_templates());
    EXPECT_NE(plan.title, plan.name);
    const CaseMaker maker(plan);
    for (const double share : {0.0, 1.0}) {
      Trial trial{{}, 0, plan.refinement};
      for (const Axis& axis : all_axes(plan)) axis.put_share(share, trial.setting);
      EXPECT_GT(maker.make(trial).memory, 0.0) << entry.name;
    }
    for (const Trial& trial : search_ends(plan))
      EXPECT_GT(maker.make(trial).memory, 0.0) << entry.name;
  }
}

TEST(ShippedStudies, BeginWithTheirNameAndDescription) {
  for (const EmbeddedText& entry : study_templates())
    EXPECT_TRUE(entry.text.starts_with("# " + std::string(entry.name) + ": ")) << entry.name;
}

}  // namespace
}  // namespace kerf
