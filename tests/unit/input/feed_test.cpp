// SPDX-License-Identifier: Apache-2.0
// Which pumps hold their pressure: those of the `standard` formulation unless the case says
// otherwise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

std::string case_with_pump(const std::string& pump, const std::string& formulation) {
  return "title = \"pump\"\ndimension = 2\nformulation = \"" + formulation + R"("
[time]
end = "1 ms"
[domain]
minimum = ["-50 mm", "-20 mm"]
maximum = ["60 mm", "70 mm"]
)" + pump;
}

const std::string jet_alone = R"([[jet]]
name = "jet"
speed = "5 m/s"
width = "4 mm"
position = ["2 mm", "0 mm"]
standoff = "30 mm"
spacing = "1 mm"
)";
const std::string machine_alone = R"([machine]
pressure = "2 MPa"
orifice_diameter = "4 mm"
position = ["0 mm", "0 mm"]
standoff = "20 mm"
)";

Feed feed_of(const std::string& pump, const std::string& formulation) {
  return parse_case(case_with_pump(pump, formulation), "test").jets.at(0).feed;
}

TEST(Feed, PumpsOfTheStandardFormulationHoldTheirPressure) {
  EXPECT_EQ(feed_of(jet_alone, "standard"), Feed::pressure);
  EXPECT_EQ(feed_of(machine_alone, "standard"), Feed::pressure);
  EXPECT_EQ(feed_of(jet_alone + "feed = \"flow\"\n", "standard"), Feed::flow);
}

TEST(Feed, ThePaperHoldsTheFlow) {
  EXPECT_EQ(feed_of(jet_alone, "shinohara2004"), Feed::flow);
  EXPECT_EQ(feed_of(machine_alone, "shinohara2004"), Feed::flow);
  EXPECT_THROW(feed_of(jet_alone + "feed = \"pressure\"\n", "shinohara2004"), UserError);
}

}  // namespace
}  // namespace kerf
