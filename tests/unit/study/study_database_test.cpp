// SPDX-License-Identifier: Apache-2.0
// A study.db that was damaged is refused with its name and a remedy.
#include "study/study_database.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "output/files.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Returns what is said of a database with a completed run in which `from` was replaced by `to`.
std::string said_of_damaged(const std::string& from, const std::string& to) {
  const test::TemporaryFolder folder;
  const auto file = folder / "study.db";
  {
    StudyDatabase database(file);
    Trial trial;
    trial.setting.numbers["jet.speed"] = 5.0;
    ResolvedCase resolved;
    resolved.id = "run-1";
    resolved.text = "title = \"a\"\n";
    database.add(resolved, trial);
    database.mark_done("run-1", {{"kerf.depth", 0.25}});
    EXPECT_EQ(database.find("run-1")->metrics.at("kerf.depth"), 0.25);
  }
  std::string bytes = read_file(file);
  EXPECT_NE(bytes.find(from), std::string::npos);
  for (std::size_t at = 0; (at = bytes.find(from, at)) != std::string::npos; at += to.size())
    bytes.replace(at, from.size(), to);
  write_file(file, bytes);
  try {
    (void)StudyDatabase(file).runs();
  } catch (const UserError& error) {
    EXPECT_EQ(error.exit_code(), exit_files);
    return error.what();
  }
  return "";
}

TEST(StudyDatabase, ARunOfAnUnknownStateIsRefusedByTheNameOfTheFile) {
  EXPECT_THAT(
      said_of_damaged("done", "dove"),
      AllOf(HasSubstr("/study.db holds a run of the unknown state \"dove\""), HasSubstr("--out")));
}

TEST(StudyDatabase, ATextThatIsCutWithinACharacterIsReadable) {
  const test::TemporaryFolder folder;
  StudyDatabase database(folder / "study.db");
  ResolvedCase resolved;
  resolved.id = "run-1";
  database.add(resolved, Trial());
  database.mark_failed("run-1", "\xb5m is too fine");
  EXPECT_EQ(database.find("run-1")->error, "\xef\xbf\xbdm is too fine");
}

TEST(StudyDatabase, DamagedRunsAreRefused) {
  const auto is_refused = AllOf(HasSubstr("study.db is damaged"), HasSubstr("--out"));
  EXPECT_THAT(said_of_damaged("{\"kerf.depth\":0.25}", "{\"kerf.depth\":0.25]"), is_refused);
  EXPECT_THAT(said_of_damaged("{\"kerf.depth\":0.25}", "{\"kerf.depth\":null}"), is_refused);
  EXPECT_THAT(said_of_damaged("{\"jet.speed\":5.0}", "{\"jet.speed\":[ ]}"), is_refused);
  EXPECT_EQ(said_of_damaged("{\"kerf.depth\":0.25}", "{\"kerf.depth\":0.50}"), "");
}

}  // namespace
}  // namespace kerf
