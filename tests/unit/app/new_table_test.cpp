// SPDX-License-Identifier: Apache-2.0
// The form adds tables with values to start from: the case is then as valid as before.
#include "app/new_table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/embedded.hpp"
#include "core/error.hpp"
#include "geometry/shapes.hpp"
#include "input/edit_tables.hpp"
#include "input/read.hpp"
#include "input/schema.hpp"
#include "model/case.hpp"
#include "support/fake_run.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;

Case with_another(const std::string& text, std::string_view section) {
  return parse_case(with_new_table(text, "case.toml", section, "").text, "case.toml", quick_look);
}

TEST(NewTable, RepeatableSectionsAreThoseOfTheSchema) {
  std::vector<std::string> names;
  for (const SchemaSection& section : schema())
    if (is_repeatable(section.name)) names.emplace_back(section.name);
  EXPECT_THAT(names, testing::ElementsAre("materials", "body", "load", "jet", "probe"));
  EXPECT_EQ(word_of_table("materials"), "material");
  EXPECT_EQ(word_of_table("body"), "body");
}

TEST(NewTable, ABodyStandsBesideTheOthers) {
  const std::string text = write_used(test::fake_case());
  const Case before = parse_case(text, "case.toml"), after = with_another(text, "body");
  ASSERT_EQ(after.bodies.size(), before.bodies.size() + 1);
  const Box box = bounding_box(after.bodies.back().shape, after.dimension);
  for (const Body& body : before.bodies) {
    const Box other = bounding_box(body.shape, before.dimension);
    bool is_apart = false;
    for (std::size_t a = 0; a < 2; ++a)
      is_apart = is_apart || box.minimum[a] >= other.maximum[a] - 1e-9 ||
                 box.maximum[a] <= other.minimum[a] + 1e-9;
    EXPECT_TRUE(is_apart) << body.name;
  }
}

TEST(NewTable, AJetStandsBesideTheLast) {
  const std::string text = write_used(test::fake_case());
  const Case before = parse_case(text, "case.toml"), after = with_another(text, "jet");
  ASSERT_EQ(after.jets.size(), before.jets.size() + 1);
  EXPECT_EQ(after.jets.back().speed, before.jets.back().speed);
  EXPECT_GT(std::abs(after.jets.back().position[0] - before.jets.back().position[0]),
            before.jets.back().width);
  EXPECT_NE(after.jets.back().name, before.jets.back().name);
}

TEST(NewTable, AMaterialHasItsNameInTheHeading) {
  const std::string text = write_used(test::fake_case()) + "\n[materials.own]\nbase = \"agar\"\n";
  const NewTable made = with_new_table(text, "case.toml", "materials", "soft-gel");
  EXPECT_EQ(made.path, "materials.soft-gel");
  EXPECT_THAT(made.text, HasSubstr("[materials.soft-gel]\nbase = "));
  EXPECT_THROW(with_new_table(text, "case.toml", "materials", "own"), UserError);
  EXPECT_THROW(with_new_table(text, "case.toml", "materials", "no name"), UserError);
}

// Whether the case is valid with another table of a section; with what the reader says if not.
std::string problem_with(const std::string& text, std::string_view section) {
  try {
    with_another(text, section);
    return "";
  } catch (const UserError& error) {
    return error.what();
  }
}

bool has_free_body(const Case& description) {
  return std::any_of(description.bodies.begin(), description.bodies.end(), [](const Body& body) {
    return body.role == Role::elastic && !body.fixed && body.displacement[0].empty();
  });
}

// Every template stays valid with another table of any kind, except with a load where there is
// nothing to load, which the reader says. The removal restores the text.
TEST(NewTable, EveryTemplateTakesEveryTable) {
  for (const EmbeddedText& entry : case_templates()) {
    if (entry.name == "stl-part") continue;  // its mesh is beside the case
    const std::string text(entry.text);
    const Case description = parse_case(text, "case.toml", quick_look);
    for (const SchemaSection& section : schema()) {
      const bool is_paper = description.formulation != Formulation::standard;
      if (!is_repeatable(section.name) || (section.name == "load" && is_paper)) continue;
      SCOPED_TRACE(fmt::format("{}: {}", entry.name, section.name));
      const NewTable made = with_new_table(text, "case.toml", section.name, "");
      EXPECT_EQ(without_table(made.text, made.path), text);
      const std::string problem = problem_with(text, section.name);
      if (section.name == "load" && !has_free_body(description))
        EXPECT_THAT(problem, HasSubstr("not an elastic body that is free to move"));
      else
        EXPECT_EQ(problem, "");
    }
  }
}

// Without anything to go by, each table has every key that it needs.
TEST(NewTable, AnEmptyCaseMissesOnlyWhatTheTableIsNot) {
  const std::string empty = "title = \"new\"\ndimension = 2\n[time]\nend = \"1 ms\"\n";
  for (const char* section : {"body", "jet", "probe", "load"})
    EXPECT_THAT(problem_with(empty, section),
                testing::Not(HasSubstr(fmt::format("{}[1].", section))))
        << section;
}

}  // namespace
}  // namespace kerf
