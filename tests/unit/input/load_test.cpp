// SPDX-License-Identifier: Apache-2.0
// Loads in a case file: what they hold, what is written back, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"

namespace kerf::test::load_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string case_with(const std::string& load, const std::string& formulation = "standard") {
  return "title = \"loaded\"\ndimension = 2\nformulation = \"" + formulation + R"("
[time]
end = "10 ms"
[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["0 mm", "0 mm"], maximum = ["20 mm", "10 mm"] }
spacing = "1 mm"
[[body]]
name = "clamp"
material = "tofu"
fixed = true
shape = { type = "box", minimum = ["-5 mm", "0 mm"], maximum = ["0 mm", "10 mm"] }
spacing = "1 mm"
)" + load;
}

const std::string right_end =
    R"(shape = { type = "box", minimum = ["19.9 mm", "-1 mm"], maximum = ["21 mm", "11 mm"] })";

std::string refusal_of_load(const std::string& load, const std::string& formulation = "standard") {
  try {
    parse_case(case_with(load, formulation), "case.toml");
  } catch (const UserError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Load, IsReadAndWrittenBack) {
  const std::string kind = "[[load]]\nbody = \"block\"\nkind = ";
  const Case read =
      parse_case(case_with(kind + "\"traction\"\n" + right_end +
                           "\ntraction = [\"1 kPa\", \"-20 Pa\"]\nhistory = \"min(t/1e-3, 1)\"\n" +
                           kind + "\"pressure\"\n" + right_end + "\npressure = \"2 bar\"\n" + kind +
                           "\"body_force\"\nacceleration = [\"0 m/s2\", \"3 m/s2\"]\n"),
                 "case.toml");
  ASSERT_EQ(read.loads.size(), 3u);
  EXPECT_EQ(read.loads[0].kind, LoadKind::traction);
  EXPECT_EQ(read.loads[0].body, "block");
  EXPECT_EQ(read.loads[0].traction, (Point{1e3, -20.0, 0.0}));
  EXPECT_EQ(read.loads[0].history, "min(t/1e-3, 1)");
  EXPECT_EQ(read.loads[1].kind, LoadKind::pressure);
  EXPECT_EQ(read.loads[1].pressure, 2e5);
  EXPECT_EQ(read.loads[1].history, "1");
  EXPECT_EQ(read.loads[2].acceleration, (Point{0.0, 3.0, 0.0}));
  EXPECT_FALSE(read.loads[2].region);
  EXPECT_EQ(parse_case(write_used(read), "case.used.toml"), read);
}

// A history that is infinite anywhere within the run is refused, also between samples.
TEST(Load, IsRefusedWithAnInfiniteHistory) {
  const auto refusal = [](const std::string& history) {
    return refusal_of_load(
        "[[load]]\nkind = \"body_force\"\nbody = \"block\"\nacceleration = "
        "[\"1 m/s2\", \"0 m/s2\"]\nhistory = \"" +
        history + "\"\n");
  };
  for (const char* finite : {"1", "sin(t/1e-5)", "1/(t+1e-4)", "t<0.005 ? 1 : -1",
                             "exp(-((t-0.0033)/1e-9)^2)", "1/(t-0.02)", "1e6*t"})
    EXPECT_EQ(refusal(finite), "accepted") << finite;
  EXPECT_THAT(refusal("1/t"),
              AllOf(HasSubstr("case.toml:"), HasSubstr("load[1].history = \"1/t\""),
                    HasSubstr("not finite at t = 0 s. Allowed: an expression that is finite from"),
                    HasSubstr("the end of the run, 0.01 s. Correct it")));
  for (const char* infinite :
       {"1/(t-0.005)", "1/(t-0.00333333)", "(t-0.0071234567)^(-2)", "log(0.003-t)", "sqrt(-t)"})
    EXPECT_THAT(refusal(infinite), HasSubstr("load[1].history")) << infinite;
}

TEST(Load, IsRefusedWhereItCannotAct) {
  const std::string pressure = "pressure = \"1 kPa\"\n";
  const auto load = [&](const std::string& body, const std::string& shape,
                        const std::string& value) {
    return "[[load]]\nkind = \"pressure\"\nbody = \"" + body + "\"\n" + shape + "\n" + value;
  };
  EXPECT_EQ(refusal_of_load(load("block", right_end, pressure)), "accepted");
  EXPECT_THAT(refusal_of_load(load("clamp", right_end, pressure)),
              AllOf(HasSubstr("load[1].body"), HasSubstr("free to move"), HasSubstr("block")));
  EXPECT_THAT(refusal_of_load(load("blocks", right_end, pressure)), HasSubstr("load[1].body"));
  EXPECT_THAT(refusal_of_load(load("block", "", pressure)),
              AllOf(HasSubstr("load[1].shape"), HasSubstr("the key is missing")));
  EXPECT_THAT(
      refusal_of_load(load("block", right_end, "traction = [\"1 Pa\", \"0 Pa\"]\n" + pressure)),
      AllOf(HasSubstr("load[1].traction"), HasSubstr("no meaning here")));
  EXPECT_THAT(refusal_of_load(load("block", right_end, pressure + "history = \"x\"\n")),
              AllOf(HasSubstr("load[1].history"), HasSubstr("cannot be used")));
  const std::string inside =
      R"(shape = { type = "box", minimum = ["5 mm", "3 mm"], maximum = ["9 mm", "7 mm"] })";
  EXPECT_THAT(refusal_of_load(load("block", inside, pressure)),
              AllOf(HasSubstr("load[1].shape"), HasSubstr("no part of the surface")));
  EXPECT_THAT(refusal_of_load(load("block", right_end, pressure), "shinohara2004"),
              HasSubstr("no meaning here"));
}

}  // namespace
}  // namespace kerf::test::load_test
