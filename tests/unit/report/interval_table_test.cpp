// SPDX-License-Identifier: Apache-2.0
// The table of intervals of a report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/report_parts.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;

TEST(IntervalsTable, ShowsValueEndsAndCauses) {
  Json depth{{"metric", "kerf.depth"}, {"unit", "m"},       {"value", 3.47e-3}, {"low", 1.2e-3},
             {"high", 5.8e-3},         {"spacing", 2.3e-3}, {"layout", 4e-4},   {"order", nullptr},
             {"rule", "range"},        {"runs", 5}};
  const std::string table =
      intervals_table({{"kerf", Json::object()}, {"intervals", Json::array({depth})}});
  EXPECT_THAT(table, AllOf(HasSubstr("depth of the kerf"), HasSubstr("3.47 mm [1.2 mm, 5.8 mm]"),
                           HasSubstr("spacing 2.3 mm, layout 400 µm; range of 5 runs")));
}

TEST(IntervalsTable, SaysThatNothingWasExamined) {
  EXPECT_THAT(intervals_table({{"kerf", Json::object()}, {"intervals", Json::array()}}),
              HasSubstr("--converge"));
  EXPECT_EQ(intervals_table(Json::object()), "");
  EXPECT_EQ(intervals_table({{"intervals", Json::array()}}), "");
}

}  // namespace
}  // namespace kerf
