// SPDX-License-Identifier: Apache-2.0
#include "output/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <optional>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

std::ptrdiff_t entries_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(Files, WritesAndReplacesWithoutTemporaryFilesLeft) {
  const TemporaryFolder folder;
  write_file(folder / "a", "first, and longer");
  EXPECT_EQ(read_file(folder / "a"), "first, and longer");
  write_file(folder / "a", std::string("sec\0nd", 6));
  EXPECT_EQ(read_file(folder / "a"), std::string("sec\0nd", 6));
  EXPECT_EQ(entries_in(folder.path()), 1);
}

TEST(Files, AppendsToAnExistingFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(append_to_file(folder / "a", "none"), UserError);
  write_file(folder / "a", "one\n");
  append_to_file(folder / "a", "two\n");
  sync_file(folder / "a");
  EXPECT_EQ(read_file(folder / "a"), "one\ntwo\n");
}

TEST(Files, NamesTheFileAndTheRemedyForAMissingFolder) {
  const TemporaryFolder folder;
  const fs::path path = folder / "gone/a";
  EXPECT_THAT(message_of<UserError>([&] { write_file(path, "x"); }),
              AllOf(HasSubstr("cannot write " + path.string()), HasSubstr("restore it")));
  EXPECT_THAT(message_of<UserError>([&] { read_file(path); }),
              HasSubstr("cannot read " + path.string()));
}

TEST(Files, KeepsTheOldContentAfterAFailedWrite) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  // A folder has the name of the temporary file, so opening it fails, even for root.
  fs::create_directory(folder / ".a.tmp");
  EXPECT_THROW(write_file(folder / "a", "new"), UserError);
  EXPECT_EQ(read_file(folder / "a"), "old");
}

TEST(Files, NamesAFileAtThePathOfAFolder) {
  const TemporaryFolder folder;
  write_file(folder / "a", "x");
  EXPECT_THAT(message_of<UserError>([&] { make_folder(folder / "a/b"); }),
              HasSubstr("cannot make the folder " + (folder / "a/b").string()));
  EXPECT_THAT(message_of<UserError>([&] { make_folder(folder / "a"); }),
              testing::AllOf(HasSubstr("It is a file"), testing::Not(HasSubstr("restore it"))));
  EXPECT_THAT(message_of<UserError>([&] { make_inner_folder(folder / "gone/frames"); }),
              HasSubstr("restore it"));
}

TEST(FolderLock, IsExclusive) {
  const TemporaryFolder folder;
  std::optional<FolderLock> first(std::in_place, folder.path());
  EXPECT_THAT(message_of<UserError>([&] { FolderLock second(folder.path()); }),
              HasSubstr("in use by another run"));
  first.reset();
  EXPECT_NO_THROW(FolderLock third(folder.path()));
}

}  // namespace
}  // namespace kerf
