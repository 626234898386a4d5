// SPDX-License-Identifier: Apache-2.0
#include "study/key_path.hpp"
#include "model/case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "input/read.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;

Case changed(const std::string& path, double value) {
  toml::table table = toml::parse(test::small_case);
  const KeyPath key = find_key_path(path, table);
  EXPECT_EQ(key.problem, "") << path;
  set_number(table, key, value);
  std::ostringstream text;
  text << table;
  return parse_case(text.str(), "changed");
}

std::string problem_of(const std::string& path) {
  return find_key_path(path, toml::parse(test::small_case)).problem;
}

TEST(KeyPath, LeadsThroughTablesListsAndVectors) {
  EXPECT_EQ(changed("jet.jet.speed", 7.0).jets[0].speed, 7.0);
  EXPECT_EQ(changed("jet.0.speed", 7.0).jets[0].speed, 7.0);
  EXPECT_EQ(changed("time.end", 0.005).time.end, 0.005);
  EXPECT_EQ(changed("body.other.spacing", 0.001).bodies[1].spacing, 0.001);
  EXPECT_EQ(changed("body.block.shape.maximum.1", 0.004).bodies[0].shape.box.maximum[1], 0.004);
  EXPECT_EQ(changed("materials.curd.fracture_energy", 3.0).materials[0].fracture_energy, 3.0);
}

TEST(KeyPath, CreatesAMissingTable) {
  EXPECT_EQ(changed("output.series_interval", 1e-4).output.series_interval, 1e-4);
  EXPECT_EQ(changed("body.other.seed", 5.0).bodies[1].seed, 5u);
}

TEST(KeyPath, DerivesAMaterialFromTheLibrary) {
  const Case original = parse_case(test::small_case, "small");
  const Case result = changed("materials.gelatin-10.density", 1234.0);
  const auto gelatin = [](const Case& description) {
    return description.materials[static_cast<std::size_t>(description.bodies[1].material)];
  };
  EXPECT_EQ(gelatin(result).density, 1234.0);
  EXPECT_EQ(gelatin(result).youngs_modulus, gelatin(original).youngs_modulus);
}

TEST(KeyPath, NamesTheInvalidPartOfAPath) {
  EXPECT_THAT(problem_of("jet.jet.sped"), HasSubstr("(did you mean \"speed\"?)"));
  EXPECT_THAT(problem_of("jet.jett.speed"), HasSubstr("no jet of the name or number \"jett\""));
  EXPECT_THAT(problem_of("jet.1.speed"), HasSubstr("no jet of the name or number \"1\""));
  EXPECT_THAT(problem_of("machin.pressure"), HasSubstr("(did you mean \"machine\"?)"));
  EXPECT_THAT(problem_of("body.block"), HasSubstr("ends at a table"));
  EXPECT_THAT(problem_of("body"), HasSubstr("ends at a list"));
  EXPECT_THAT(problem_of("body.block.shape.maximum.2"), HasSubstr("entry 2"));
  EXPECT_THAT(problem_of("materials.cheese.density"), HasSubstr("\"cheese\""));
  EXPECT_THAT(problem_of("jet.jet.speed.0"), HasSubstr("has no entries"));
  EXPECT_THAT(problem_of(""), HasSubstr("ends at a table"));
}

TEST(KeyPath, RecognisesSingleNumbers) {
  const toml::table table = toml::parse(test::small_case);
  EXPECT_TRUE(find_key_path("jet.jet.speed", table).is_number());
  EXPECT_TRUE(find_key_path("jet.jet.position.1", table).is_number());
  EXPECT_FALSE(find_key_path("jet.jet.position", table).is_number());
  EXPECT_FALSE(find_key_path("materials.curd.criterion", table).is_number());
}

}  // namespace
}  // namespace kerf
