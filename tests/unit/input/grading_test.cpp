// SPDX-License-Identifier: Apache-2.0
// The keys of graded bodies are read, written and refused.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/error.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;

std::string block_with(const std::string& keys, const std::string& more = "",
                       const std::string& formulation = "standard") {
  return fmt::format(R"(
title = "a graded block"
dimension = 2
formulation = "{}"
[time]
end = "1 ms"
[[body]]
name = "block"
material = "tofu"
shape = {{ type = "box", minimum = ["-64 mm", "0 mm"], maximum = ["64 mm", "32 mm"] }}
spacing = "1 mm"
{}
{})",
                     formulation, keys, more);
}

const std::string jet = R"([[jet]]
name = "jet"
speed = "5 m/s"
width = "10 mm"
position = ["3 mm", "32 mm"]
standoff = "20 mm"
angle = "30 deg"
spacing = "1 mm"
)";
const std::string box =
    R"({ type = "box", minimum = ["-1 mm", "0 mm"], maximum = ["1 mm", "9 mm"] })";

TEST(Grading, AroundTheJets) {
  const Case read =
      parse_case(block_with(R"(grading = { levels = 2, width = "15 mm" })", jet), "case.toml");
  const Grading& grading = read.bodies[0].grading;
  EXPECT_EQ(grading.levels, 2);
  EXPECT_EQ(grading.width, 15e-3);
  EXPECT_FALSE(grading.around);
  ASSERT_EQ(grading.lines.size(), 1u);
  EXPECT_EQ(grading.lines[0].origin, (Point{3e-3, 32e-3, 0.0}));
  EXPECT_DOUBLE_EQ(grading.lines[0].direction[0], 0.5);
  EXPECT_DOUBLE_EQ(grading.lines[0].direction[1], -std::sqrt(0.75));
  EXPECT_EQ(grading.lines[0].radius, 5e-3);
  EXPECT_EQ(parse_case(write_used(read), "case.used.toml"), read);
}

TEST(Grading, AroundAShape) {
  const Case read = parse_case(
      block_with(R"(grading = { levels = 1, width = "4 mm", around = )" + box + " }"), "case.toml");
  ASSERT_TRUE(read.bodies[0].grading.around);
  EXPECT_EQ(read.bodies[0].grading.around->box.maximum[1], 9e-3);
  EXPECT_TRUE(read.bodies[0].grading.lines.empty());
  EXPECT_EQ(parse_case(write_used(read), "case.used.toml"), read);
}

void expect_grading_refused(const std::string& text, const std::string& what,
                            const std::string& remedy) {
  try {
    parse_case(text, "case.toml");
    ADD_FAILURE() << what << " was not refused";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), HasSubstr(what));
    EXPECT_THAT(error.what(), HasSubstr(remedy));
    EXPECT_THAT(error.what(), HasSubstr("case.toml"));
  }
}

TEST(Grading, InvalidGradingIsRefused) {
  expect_grading_refused(block_with(R"(grading = { levels = 2, width = "3.9 mm" })", jet),
                         "body[1].grading.width = \"3.9 mm\"", "at least 0.004 m");
  expect_grading_refused(block_with(R"(grading = { levels = 2, width = "15 mm" })"),
                         "body[1].grading.around", "there is no jet");
  expect_grading_refused(block_with(R"(grading = { levels = 0, width = "15 mm" })", jet),
                         "body[1].grading.levels = 0", "from 1 to 4");
  expect_grading_refused(
      block_with("lattice = \"hexagonal\"\ngrading = { levels = 1, width = \"15 mm\" }", jet),
      "the lattice of the body is hexagonal or shifted", "a square lattice without offset");
  expect_grading_refused(block_with(R"(grading = { levels = 1, width = "15 mm", speed = 3 })", jet),
                         "body[1].grading.speed", "levels");
  expect_grading_refused(
      block_with(R"(grading = { levels = 1, width = "15 mm" })", jet, "shinohara2004"),
      "body[1].grading", "standard");
}

}  // namespace
}  // namespace kerf
