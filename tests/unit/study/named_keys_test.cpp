// SPDX-License-Identifier: Apache-2.0
// A key that a study names twice is refused, whatever its names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic.hpp"

namespace kerf::named_keys_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string complaint(const std::string& text) {
  return test::message_of<UserError>([&] { test::plan_of(text); });
}

const std::string by_number = "\"jet.0.speed\" = [\"3 m/s\", \"8 m/s\"]\n";
const std::string by_name = "\"jet.jet.speed\" = [\"5 m/s\", \"9 m/s\"]\n";
const std::string calibrate =
    "[calibrate]\nkey = \"jet.jet.width\"\nfrom = \"2 mm\"\nto = \"4 mm\"\n"
    "metric = \"kerf.depth\"\nmeasured = \"3 mm\"\n";

// Returns a search of the key of that path.
std::string search(const std::string& path) {
  return "[search]\nfind = \"least\"\nkey = \"" + path + "\"\nfrom = \"2 m/s\"\nto = \"4 m/s\"\n";
}

TEST(NamedKeys, OneKeyUnderTwoNamesIsRefusedInEveryDesign) {
  const auto is_refused =
      AllOf(StartsWith("my-study.toml:4: vary.jet.jet.speed = "),
            HasSubstr("the table has this key twice: see vary.jet.0.speed in line 3"),
            HasSubstr("Allowed: each key once"), HasSubstr("Remove one of the two"));
  const std::string vary = "[vary]\n" + by_number + by_name;
  EXPECT_THAT(complaint(vary), is_refused);
  EXPECT_THAT(complaint(vary + "[design]\ntype = \"sobol\"\nruns = 4\n"), is_refused);
  EXPECT_THAT(complaint(vary + "[design]\ntype = \"latin_hypercube\"\nruns = 4\n"), is_refused);
  EXPECT_THAT(complaint("[vary]\n" + by_name + "jet.jet.speed = [\"7 m/s\"]\n"),
              HasSubstr("the table has this key twice"));
  EXPECT_THAT(complaint("repeats = 2\n[set]\n\"body.0.jitter\" = 0.1\n\"body.block.jitter\" = 0.2\n"
                        "[vary]\n" +
                        by_name),
              HasSubstr("set.body.block.jitter = 0.2: the table has this key twice"));
  EXPECT_EQ(complaint("[vary]\n\"body.0.jitter\" = [0.1]\n\"body.other.jitter\" = [0.2]\n"), "");
}

TEST(NamedKeys, NumbersOfAVectorAreKeysOfTheirOwn) {
  const std::string height = "\"body.block.shape.maximum.1\"";
  EXPECT_THAT(complaint("[vary]\n" + height +
                        " = [\"4 mm\"]\n\"body.0.shape.maximum.01\" = "
                        "[\"6 mm\"]\n"),
              HasSubstr("the table has this key twice"));
  EXPECT_THAT(complaint("[set]\n" + height +
                        " = \"4 mm\"\n\"body.0.shape.maximum\" = "
                        "[\"8 mm\", \"6 mm\"]\n[vary]\n" +
                        by_name),
              HasSubstr("the table has this key twice"));
  EXPECT_EQ(complaint("[set]\n\"body.0.shape.maximum\" = [\"8 mm\", \"6 mm\"]\n[vary]\n" + height +
                      " = [\"4 mm\", \"6 mm\"]\n"),
            "");
}

TEST(NamedKeys, AValueThatAnotherReplacesIsRefused) {
  const auto is_refused = HasSubstr(
      "both give the same key a value, and only one can hold: see "
      "set.jet.0.speed in line 3");
  const std::string set = "[set]\n\"jet.0.speed\" = \"3 m/s\"\n";
  EXPECT_THAT(complaint(set + "[vary]\n" + by_number), is_refused);
  EXPECT_THAT(complaint(set + "[vary]\n" + by_name), is_refused);
  EXPECT_THAT(complaint(set + search("jet.0.speed")),
              AllOf(StartsWith("my-study.toml:6: search.key = \"jet.0.speed\""), is_refused));
  EXPECT_THAT(complaint(set + search("jet.jet.speed")), is_refused);
  EXPECT_THAT(complaint(set + calibrate + "at.\"jet.jet.speed\" = \"5 m/s\"\n"), is_refused);
  EXPECT_THAT(complaint("[set]\n\"jet.0.width\" = \"4 mm\"\n" + calibrate),
              HasSubstr("see set.jet.0.width in line 3"));
}

TEST(NamedKeys, ASettingOfACalibrationHasNotItsKey) {
  const auto is_refused = HasSubstr("see calibrate.key in line 3");
  EXPECT_THAT(complaint(calibrate + "at.\"jet.0.width\" = \"3 mm\"\n"), is_refused);
  EXPECT_THAT(complaint(calibrate + "[[calibrate.predict]]\n\"jet.jet.width\" = \"3 mm\"\n"),
              is_refused);
}

TEST(NamedKeys, OneKeyMayServeTwoGoalsUnderOneName) {
  const std::string grid = "[vary]\n" + by_number + "[design]\ntype = \"grid\"\n";
  EXPECT_EQ(complaint(grid + search("jet.0.speed")), "");
  EXPECT_THAT(complaint(grid + search("jet.jet.speed")),
              AllOf(HasSubstr("the same key under another name: see vary.jet.0.speed in line 3"),
                    HasSubstr("Write \"jet.0.speed\" in both places")));
  const std::string predict = "[[calibrate.predict]]\n\"jet.jet.speed\" = \"8 m/s\"\n";
  EXPECT_EQ(complaint(calibrate + "at.\"jet.jet.speed\" = \"5 m/s\"\n" + predict + predict), "");
  EXPECT_EQ(complaint("[set]\n\"jet.jet.speed\" = \"5 m/s\"\n" + calibrate + predict), "");
}

}  // namespace
}  // namespace kerf::named_keys_test
