// SPDX-License-Identifier: Apache-2.0
#include "output/result_reference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "output/files.hpp"
#include "output/result.hpp"
#include "studies/small_study.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

// Returns the errors that an independent validator finds in `result` by the schema in docs/; empty
// if there are none.
std::string problems_of(const Json& result) {
  const Json document = Json::parse(read_file(KERF_SOURCE_DIR "/docs/result.schema.json"));
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema);
  valijson::ValidationResults results;
  valijson::Validator validator;
  validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(result), &results);
  std::string text;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& part : error.context) text += part;
    text += ": " + error.description + "\n";
  }
  return text;
}

Json plain_result() {
  return Json::parse(result_of(RunOutcome{}).dump());
}

TEST(ResultReference, EqualsTheDocumentation) {
  const std::string page = read_file(KERF_SOURCE_DIR "/docs/metrics.md");
  EXPECT_TRUE(page.ends_with("\n\n" + metrics_table()))
      << "docs/metrics.md does not end with what kerf check --metrics prints";
  const std::string schema = read_file(KERF_SOURCE_DIR "/docs/result.schema.json");
  EXPECT_TRUE(schema == result_schema().dump(2) + "\n")
      << "docs/result.schema.json is not what kerf check --result-schema prints";
}

TEST(ResultSchema, HasTheUnitsOfBothDimensions) {
  const Json kerf = result_schema().at("properties").at("kerf").at("properties");
  EXPECT_EQ(kerf.at("removed_volume").at("unit"), "m3");
  EXPECT_EQ(kerf.at("removed_volume").at("unit_2d"), "m2");
  EXPECT_EQ(kerf.at("top").at("properties").at("width").at("unit"), "m");
  EXPECT_FALSE(kerf.at("depth").contains("unit_2d"));
}

TEST(ResultSchema, AcceptsAResultWithoutAJet) {
  EXPECT_THAT(problems_of(plain_result()), IsEmpty());
}

TEST(ResultSchema, RefusesWrongResults) {
  Json result = plain_result();
  result.erase("front_depth");
  EXPECT_THAT(problems_of(result), HasSubstr("front_depth"));
  result = plain_result();
  result["front_depth"] = "deep";
  EXPECT_THAT(problems_of(result), HasSubstr("front_depth"));
  result = plain_result();
  result["balance"]["momentum_in"] = 1.0;
  EXPECT_THAT(problems_of(result), HasSubstr("momentum_in"));
  result = plain_result();
  result["depth_of_front"] = 1.0;
  EXPECT_THAT(problems_of(result), HasSubstr("depth_of_front"));
}

// Runs the program.
TEST(ResultSchema, AcceptsTheResultOfARun) {
  const test::TemporaryFolder folder;
  write_file(folder / "small.toml", test::small_study_case);
  const std::string command = std::string(KERF_PROGRAM) + " run " +
                              (folder / "small.toml").string() + " --out " +
                              (folder / "run").string() + " > /dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const Json result = Json::parse(read_file(folder / "run" / "result.json"));
  EXPECT_TRUE(result.contains("kerf"));
  EXPECT_THAT(problems_of(result), IsEmpty());
}

}  // namespace
}  // namespace kerf
