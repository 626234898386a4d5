// SPDX-License-Identifier: Apache-2.0
// A key that cannot be read is told once, with what stands there and what should; nothing is said
// of what would follow from it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "input/problems.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf::test::unreadable_keys_test {
namespace {

using testing::HasSubstr;

// A jet over a block on a floor, whose spacings follow from it, with a probe.
std::string jet_case(const std::string& pressure, const std::string& normal) {
  return R"(title = "block"
dimension = 2
[domain]
minimum = ["-10 mm", "-10 mm"]
maximum = ["10 mm", "10 mm"]
[machine]
pressure = )" +
         pressure + R"(
orifice_diameter = "1 mm"
standoff = "2 mm"
position = ["0 mm", "4 mm"]
[[body]]
name = "block"
material = "fat"
shape = { type = "box", minimum = ["-5 mm", "0 mm"], maximum = ["5 mm", "4 mm"] }
[[body]]
name = "floor"
role = "rigid"
shape = { type = "box", minimum = ["-5 mm", "-2 mm"], maximum = ["5 mm", "0 mm"] }
[[probe]]
name = "p"
kind = "plane"
position = ["0 mm", "1 mm"]
normal = )" +
         normal + "\n";
}

std::vector<FoundProblem> problems_of(const std::string& text) {
  try {
    parse_case(text, "block.toml", quick_look);
  } catch (const CaseError& error) {
    return error.problems();
  }
  return {};
}

TEST(UnreadableKeys, TheCaseIsGoodOtherwise) {
  EXPECT_TRUE(problems_of(jet_case("\"5 MPa\"", "[0, 1]")).empty());
}

TEST(UnreadableKeys, TextsInAListOfNumbers) {
  const auto problems = problems_of(jet_case("\"5 MPa\"", "[\"0\", \"1\"]"));
  ASSERT_EQ(problems.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(problems[n].key, "probe[1].normal");
    EXPECT_EQ(problems[n].what,
              "entry " + std::to_string(n + 1) + ": this is a text, not a number");
    EXPECT_EQ(problems[n].remedy, "Write " + std::to_string(n) + " without quotes");
  }
  EXPECT_THAT(problems_of(jet_case("\"5 MPa\"", "[\"up\", 1]")).at(0).remedy,
              HasSubstr("without quotes"));
}

// Of a vector that could be read it is still told.
TEST(UnreadableKeys, ANormalWithoutDirection) {
  const auto problems = problems_of(jet_case("\"5 MPa\"", "[0, 0]"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].what, "the normal has no direction");
}

TEST(UnreadableKeys, BodiesAreNotBlamedForTheSpacingOfAJetThatCouldNotBeRead) {
  for (const std::string pressure : {"\"8 m/s\"", "5e6", "\"5 MPa\"\nstandof = \"1 mm\""}) {
    const auto problems = problems_of(jet_case(pressure, "[0, 1]"));
    ASSERT_EQ(problems.size(), 1u) << pressure;
    EXPECT_THAT(problems[0].key, HasSubstr("machine.")) << pressure;
  }
}

TEST(UnreadableKeys, WithoutAJetASpacingIsMissing) {
  std::string text = jet_case("\"5 MPa\"", "[0, 1]");
  const std::size_t machine = text.find("[machine]");
  text.erase(machine, text.find("[[body]]") - machine);
  const auto problems = problems_of(text);
  ASSERT_GE(problems.size(), 2u);
  EXPECT_EQ(problems[0].key, "body[1].spacing");
  EXPECT_THAT(problems[0].remedy, HasSubstr("there is no jet"));
}

}  // namespace
}  // namespace kerf::test::unreadable_keys_test
