// SPDX-License-Identifier: Apache-2.0
// Changes of single values keep every other byte of the text.
#include "input/edit_toml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "input/entered_value.hpp"
#include "input/parse_toml.hpp"
#include "input/problems.hpp"
#include "input/read.hpp"
#include "input/schema.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Characters of two bytes precede a value on its line.
const std::string edited_case = R"(# my case
title = "Gelée à 2 mm"  # é
dimension = 2
time.end = "4 ms"       # dotted

[machine]
# the pump
pressure = "50 kPa"     # at the orifice
position = ["0 mm", "6 mm"]

[[body]]
name = "gel"
shape = { type = "box", minimum = ["-1 mm", "0 mm"], maximum = ["1 mm", "1 mm"] }
[[body]]
name = "table"
role = "rigid"

[output]
frame_interval = "1 ms" # last
)";

// Returns the text in which one part is replaced by another; it must occur once.
std::string replaced_once(const std::string& from, const std::string& to) {
  const auto at = edited_case.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_EQ(edited_case.find(from, at + 1), std::string::npos) << from;
  return std::string(edited_case).replace(at, from.size(), to);
}

TEST(EditToml, ReplacesAValueInItsPlace) {
  EXPECT_EQ(with_value(edited_case, "machine.pressure", "\"30 MPa\""),
            replaced_once("\"50 kPa\"", "\"30 MPa\""));
  EXPECT_EQ(with_value(edited_case, "title", "\"ü\""), replaced_once("\"Gelée à 2 mm\"", "\"ü\""));
  EXPECT_EQ(with_value(edited_case, "time.end", "\"5 ms\""), replaced_once("\"4 ms\"", "\"5 ms\""));
  EXPECT_EQ(with_value(edited_case, "body[1].shape.maximum", "[1, 2]"),
            replaced_once("[\"1 mm\", \"1 mm\"]", "[1, 2]"));
  EXPECT_EQ(with_value(edited_case, "body[2].name", "\"t\""), replaced_once("\"table\"", "\"t\""));
}

TEST(EditToml, AddsAKeyBelowTheLastOfItsTable) {
  EXPECT_EQ(with_value(edited_case, "machine.standoff", "\"6 mm\""),
            replaced_once("\"6 mm\"]\n", "\"6 mm\"]\nstandoff = \"6 mm\"\n"));
  EXPECT_EQ(with_value(edited_case, "quality", "\"draft\""),
            replaced_once("# dotted\n", "# dotted\nquality = \"draft\"\n"));
  EXPECT_EQ(with_value(edited_case, "time.courant", "0.3"),
            replaced_once("# dotted\n", "# dotted\ntime.courant = 0.3\n"));
  EXPECT_EQ(with_value(edited_case, "body[1].shape.radius", "1"),
            replaced_once("\"1 mm\"] }", "\"1 mm\"], radius = 1 }"));
  EXPECT_EQ(with_value(edited_case, "body[1].grading.levels", "2"),
            replaced_once("\"1 mm\"] }\n", "\"1 mm\"] }\ngrading = { levels = 2 }\n"));
}

TEST(EditToml, AddsATable) {
  EXPECT_EQ(with_value(edited_case, "numerics.sleep", "false"),
            edited_case + "\n[numerics]\nsleep = false\n");
  EXPECT_EQ(with_value("", "materials.gel.density", "1"), "[materials.gel]\ndensity = 1\n");
  EXPECT_THROW(with_value(edited_case, "body[3].name", "\"x\""), UserError);
}

TEST(EditToml, RemovesAKeyAndAnEmptyTable) {
  EXPECT_EQ(with_value(edited_case, "machine.pressure", ""),
            replaced_once("pressure = \"50 kPa\"     # at the orifice\n", ""));
  EXPECT_EQ(with_value(edited_case, "body[1].shape.type", ""),
            replaced_once("type = \"box\", ", ""));
  EXPECT_EQ(with_value(edited_case, "body[1].shape.maximum", ""),
            replaced_once(", maximum = [\"1 mm\", \"1 mm\"]", ""));
  EXPECT_EQ(with_value(edited_case, "time.end", ""),
            replaced_once("time.end = \"4 ms\"       # dotted\n", ""));
  EXPECT_EQ(with_value(edited_case, "output.frame_interval", ""),
            replaced_once("\n[output]\nframe_interval = \"1 ms\" # last\n", ""));
  EXPECT_EQ(with_value(edited_case, "numerics.sleep", ""), edited_case);
  const std::string graded = with_value(edited_case, "body[1].grading.levels", "2");
  EXPECT_EQ(with_value(graded, "body[1].grading.levels", ""), edited_case);
}

// Replaces every plain value of a table and puts it back. Returns how many there are.
std::size_t replace_values(const std::string& text, const std::string& section,
                           const toml::table& table) {
  std::size_t values = 0;
  for (const auto& [key, node] : table) {
    if (node.is_table() || node.is_array_of_tables()) continue;
    const std::string path = section + "." + std::string(key.str());
    const std::string once = with_value(text, path, "12345");
    EXPECT_EQ(parse_toml(once, "")[section][key.str()].value_or(0), 12345) << path;
    EXPECT_EQ(with_value(once, path, TextPlaces(text).slice(node.source())), text) << path;
    ++values;
  }
  return values;
}

// A value that the parser finds elsewhere than it stands would change another part of the text.
TEST(EditToml, EveryValueOfTheShippedCasesCanBeReplaced) {
  std::size_t values = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(KERF_SOURCE_DIR "/cases")) {
    const bool is_study = entry.path().parent_path().filename() == "studies";
    if (entry.path().extension() != ".toml" || is_study) continue;
    const std::string text = case_text(entry.path());
    for (const auto& [name, value] : parse_toml(text, ""))
      if (value.is_table())
        values += replace_values(text, std::string(name.str()), *value.as_table());
  }
  EXPECT_GT(values, 50u);
}

TEST(EditToml, RefusesWhatIsNoToml) {
  EXPECT_THROW(with_value("title = ", "title", "1"), CaseError);
  EXPECT_THROW(with_value(edited_case, "title", "no value"), CaseError);
  EXPECT_THROW(with_value(edited_case, "title", "1\nx = 2"), UserError);
}

const Key& key_named(std::string_view section, std::string_view name) {
  return *find_key(section, name, {});
}

TEST(EnteredValue, BecomesTheLiteralOfItsKey) {
  EXPECT_EQ(literal_of(key_named("machine", "pressure"), " 30 MPa "), "\"30 MPa\"");
  EXPECT_EQ(literal_of(key_named("machine", "pressure"), "30"), "\"30\"");
  EXPECT_EQ(literal_of(key_named("machine", "pressure"), "  "), "");
  EXPECT_EQ(literal_of(key_named("machine", "duty"), "0.5"), "0.5");
  EXPECT_EQ(literal_of(key_named("machine", "duty"), "half"), "\"half\"");
  EXPECT_EQ(literal_of(key_named("machine", "duty"), "1\ny = 2"), "\"1\\u000Ay = 2\"");
  EXPECT_EQ(literal_of(key_named("machine", "position"), "1 mm,2 mm"), "[\"1 mm\", \"2 mm\"]");
  EXPECT_EQ(literal_of(key_named("machine", "traverse_direction"), "1, 0"), "[1, 0]");
  EXPECT_EQ(literal_of(key_named("numerics", "sleep"), "false"), "false");
  EXPECT_EQ(literal_of(key_named("", "title"), "a \"b\", c"), "\"a \\\"b\\\", c\"");
  EXPECT_EQ(literal_of(key_named("body", "velocity_expression"), "max(x, 0), y"),
            "[\"max(x, 0)\", \"y\"]");
}

TEST(EnteredValue, ShowsAValueAsItIsEntered) {
  const std::string text = "a = \"30 MPa\"\nb = [\"1 mm\", \"2 mm\"]\nc = 1e3\nd = [[1], [2]]\n";
  const toml::table table = parse_toml(text, "");
  const TextPlaces places(text);
  EXPECT_EQ(entered_value(*table.get("a"), places), "30 MPa");
  EXPECT_EQ(entered_value(*table.get("b"), places), "1 mm, 2 mm");
  EXPECT_EQ(entered_value(*table.get("c"), places), "1e3");
  EXPECT_EQ(entered_value(*table.get("d"), places), "[[1], [2]]");
}

TEST(CaseErrors, NameKeyValueAndRemedy) {
  try {
    parse_case("title = \"x\"\ndimension = 4\n", "my.toml");
    FAIL();
  } catch (const CaseError& error) {
    ASSERT_EQ(error.problems().size(), 1u);
    const FoundProblem& problem = error.problems().front();
    EXPECT_EQ(problem.key, "dimension");
    EXPECT_EQ(problem.value, "4");
    EXPECT_EQ(problem.line, 2);
    EXPECT_THAT(problem.allowed, testing::HasSubstr("from 2 to 3"));
  }
}

}  // namespace
}  // namespace kerf
