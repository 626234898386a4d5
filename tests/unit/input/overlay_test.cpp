// SPDX-License-Identifier: Apache-2.0
#include "input/overlay.hpp"

#include <gtest/gtest.h>

namespace kerf {
namespace {

constexpr std::string_view base = R"(
title = "base"
[time]
end = "1 s"
courant = 0.25
[[body]]
name = "one"
spacing = "2 mm"
[[body]]
name = "two"
spacing = "2 mm"
velocity = ["1 m/s", "0 m/s"]
)";

toml::table overlaid(std::string_view changes) {
  return toml::parse(overlay(base, toml::parse(changes)));
}

TEST(Overlay, MergesTablesKeyByKey) {
  const auto result = overlaid("[time]\nend = \"2 s\"");
  EXPECT_EQ(result["time"]["end"].value_or(""), std::string("2 s"));
  EXPECT_EQ(result["time"]["courant"].value_or(0.0), 0.25);
  EXPECT_EQ(result["title"].value_or(""), std::string("base"));
}

TEST(Overlay, MatchesListEntriesByName) {
  const auto result = overlaid("[[body]]\nname = \"two\"\nspacing = \"1 mm\"");
  const toml::array& bodies = *result["body"].as_array();
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ((*bodies[0].as_table())["spacing"].value_or(""), std::string("2 mm"));
  EXPECT_EQ((*bodies[1].as_table())["spacing"].value_or(""), std::string("1 mm"));
  EXPECT_EQ((*bodies[1].as_table())["velocity"].as_array()->size(), 2u);
}

TEST(Overlay, AddsEntriesWithANewName) {
  const auto result = overlaid("[[body]]\nname = \"three\"\nspacing = \"1 mm\"");
  EXPECT_EQ(result["body"].as_array()->size(), 3u);
}

TEST(Overlay, ReplacesOtherLists) {
  const auto result = overlaid("[[body]]\nname = \"two\"\nvelocity = [\"0 m/s\"]");
  const toml::table& body = *(*result["body"].as_array())[1].as_table();
  EXPECT_EQ(body["velocity"].as_array()->size(), 1u);
}

// Parts of a shape have no names.
TEST(Overlay, ReplacesListsOfUnnamedTables) {
  const std::string notched = "[shape]\ntype = \"difference\"\nparts = [{ x = 1 }, { x = 2 }]";
  const auto result =
      toml::parse(overlay(notched, toml::parse("[shape]\nparts = [{ x = 1 }, { x = 3 }]")));
  const toml::array& parts = *result["shape"]["parts"].as_array();
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ((*parts[1].as_table())["x"].value_or(0), 3);
}

TEST(Overlay, AddsTables) {
  const auto result = overlaid("[artificial_stress]\nepsilon = 0.3");
  EXPECT_EQ(result["artificial_stress"]["epsilon"].value_or(0.0), 0.3);
}

}  // namespace
}  // namespace kerf
