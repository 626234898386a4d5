// SPDX-License-Identifier: Apache-2.0
// Whole tables are added to and removed from the text of a case; every other byte stays.
#include "input/edit_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "input/parse_toml.hpp"
#include "input/problems.hpp"

namespace kerf {
namespace {

// The tables of bodies are in two forms, and comments belong to the table below them.
const std::string case_of_tables = R"(# my case
title = "Gelée"
dimension = 2

# of the first body
[[body]]
name = "gel"
[body.shape]
type = "box"

[[body]]
name = "table"   # below

# the end
[time]
end = "1 ms"

[materials.soft]
base = "tofu"
)";

TEST(EditTables, ATableIsAddedBehindItsKind) {
  const std::string added = with_table(case_of_tables, "[[body]]", "name = \"new\"\n");
  const std::string before = "name = \"table\"   # below\n";
  const auto at = case_of_tables.find(before) + before.size();
  EXPECT_EQ(added, case_of_tables.substr(0, at) + "\n[[body]]\nname = \"new\"\n" +
                       case_of_tables.substr(at));
  EXPECT_EQ(with_table(case_of_tables, "[[jet]]", "name = \"j\"\n"),
            case_of_tables + "\n[[jet]]\nname = \"j\"\n");
  EXPECT_EQ(with_table("", "[[jet]]", "name = \"j\"\n"), "[[jet]]\nname = \"j\"\n");
  EXPECT_EQ(with_table("a = 1", "[materials.gel]", "density = 1\n"),
            "a = 1\n\n[materials.gel]\ndensity = 1\n");
  EXPECT_EQ(with_table("a = 1\r\n", "[[jet]]", "b = 1\n"), "a = 1\r\n\r\n[[jet]]\r\nb = 1\r\n");
}

TEST(EditTables, RemovingUndoesAdding) {
  for (const char* heading : {"[[body]]", "[[jet]]", "[materials.gel]"}) {
    const std::string added = with_table(case_of_tables, heading, "name = \"new\"\n");
    const std::string path = heading[1] != '['   ? "materials.gel"
                             : heading[2] == 'b' ? "body[3]"
                                                 : "jet[1]";
    EXPECT_EQ(without_table(added, path), case_of_tables) << heading;
  }
}

TEST(EditTables, ATableGoesWithItsInnerTablesAndItsComment) {
  const std::string first =
      "\n# of the first body\n[[body]]\nname = \"gel\"\n[body.shape]\ntype = "
      "\"box\"\n";
  std::string left = case_of_tables;
  left.erase(left.find(first), first.size());
  EXPECT_EQ(without_table(case_of_tables, "body[1]"), left);
  const std::string second = "\n[[body]]\nname = \"table\"   # below\n";
  left = case_of_tables;
  left.erase(left.find(second), second.size());
  EXPECT_EQ(without_table(case_of_tables, "body[2]"), left);
  const toml::table last = parse_toml(without_table(case_of_tables, "materials.soft"), "");
  EXPECT_FALSE(last.contains("materials"));
}

TEST(EditTables, WhatCannotBeChangedIsRefused) {
  const std::string in_line = "body = [{ name = \"a\" }, { name = \"b\" }]\n";
  EXPECT_THROW(with_table(in_line, "[[body]]", "name = \"c\"\n"), UserError);
  EXPECT_THROW(without_table(in_line, "body[1]"), UserError);
  EXPECT_THROW(without_table(case_of_tables, "body[3]"), UserError);
  EXPECT_THROW(without_table(case_of_tables, "jet[1]"), UserError);
  EXPECT_THROW(with_table("x = ", "[[body]]", ""), CaseError);
  // The shape of the second body stands behind another table.
  const std::string apart =
      "[[body]]\na = 1\n[[body]]\nb = 1\n[time]\nc = 1\n[body.shape]\nd = 1\n";
  EXPECT_THROW(without_table(apart, "body[2]"), UserError);
  EXPECT_EQ(without_table("[materials]\nsoft = { base = \"tofu\" }\nhard = { base = \"pla\" }\n",
                          "materials.soft"),
            "[materials]\nhard = { base = \"pla\" }\n");
}

}  // namespace
}  // namespace kerf
