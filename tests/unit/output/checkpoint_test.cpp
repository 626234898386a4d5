// SPDX-License-Identifier: Apache-2.0
#include "output/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "output/files.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using test::message_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

const std::string case_text = "title = \"a\"\nspeed = \"5 m/s\"\n";

Checkpoint some_checkpoint() {
  Checkpoint checkpoint;
  auto& arrays = checkpoint.simulation.arrays;
  std::vector<double> many(100000);
  std::iota(many.begin(), many.end(), 0.125);
  arrays["particles/position"] = many;
  arrays["particles/pressure"] = std::vector<float>{1.0f / 3.0f, -0.0f, 1e-40f};
  arrays["particles/id"] = std::vector<std::uint32_t>{1, 4294967295u};
  arrays["source"] = std::vector<std::uint16_t>{65535};
  arrays["flag"] = std::vector<std::uint8_t>{0, 255};
  arrays["nothing"] = std::vector<double>{};
  checkpoint.simulation.texts["limit"] = "acoustic (water)";
  checkpoint.simulation.texts["empty"] = "";
  checkpoint.run.arrays["schedule"] =
      std::vector<std::uint64_t>{std::numeric_limits<std::uint64_t>::max()};
  checkpoint.run.texts["limit/acoustic (water)"] = "12";
  return checkpoint;
}

void expect_equal(const Checkpoint& a, const Checkpoint& b) {
  EXPECT_EQ(a.simulation.arrays, b.simulation.arrays);
  EXPECT_EQ(a.simulation.texts, b.simulation.texts);
  EXPECT_EQ(a.run.arrays, b.run.arrays);
  EXPECT_EQ(a.run.texts, b.run.texts);
}

class CheckpointFile : public testing::Test {
 protected:
  void SetUp() override { write_checkpoint(path_, case_text, checkpoint_); }
  std::string refusal() const {
    return message_of<UserError>([&] { read_checkpoint(path_, case_text); });
  }
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "checkpoint.h5";
  Checkpoint checkpoint_ = some_checkpoint();
};

TEST_F(CheckpointFile, RestoresEveryBit) {
  expect_equal(read_checkpoint(path_, case_text), checkpoint_);
}

TEST_F(CheckpointFile, TruncatedFileIsRefused) {
  const std::string whole = read_file(path_);
  ASSERT_GT(whole.size(), 800000u);
  for (int part = 0; part < 40; ++part) {
    write_file(path_, whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 40));
    EXPECT_THAT(refusal(),
                AllOf(HasSubstr(path_.string()), HasSubstr("damaged"), HasSubstr("--force")))
        << part << "/40 of the file";
  }
  write_file(path_, whole.substr(0, whole.size() - 1));
  EXPECT_THAT(refusal(), HasSubstr("damaged"));
}

TEST_F(CheckpointFile, ChangedByteIsRefused) {
  const std::string whole = read_file(path_);
  for (std::size_t at = 0; at < whole.size(); at += at < 6000 ? 37 : 9973) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    write_file(path_, changed);
    EXPECT_THAT(refusal(), HasSubstr("damaged")) << "byte " << at;
  }
}

TEST_F(CheckpointFile, FileOfAnotherCaseNamesTheDifference) {
  const std::string other = "title = \"a\"\nspeed = \"6 m/s\"\n";
  EXPECT_THAT(message_of<UserError>([&] { read_checkpoint(path_, other); }),
              AllOf(HasSubstr("another case"), HasSubstr("line 2"), HasSubstr("5 m/s"),
                    HasSubstr("6 m/s"), HasSubstr("--out")));
  EXPECT_THAT(message_of<UserError>([&] { read_checkpoint(path_, case_text + "more\n"); }),
              AllOf(HasSubstr("line 3"), HasSubstr("more")));
}

TEST_F(CheckpointFile, FileOfAnotherFormatVersionIsRefused) {
  std::string content = read_file(path_);
  const std::size_t at = content.rfind("version    19");
  ASSERT_NE(at, std::string::npos);
  content[at + 12] = '8';
  write_file(path_, content);
  EXPECT_THAT(refusal(),
              AllOf(HasSubstr("version 18"), HasSubstr("reads version 19"), HasSubstr("--force")));
}

TEST_F(CheckpointFile, MissingOrForeignFileIsRefused) {
  write_file(path_, "not HDF5 at all");
  EXPECT_THAT(refusal(), HasSubstr("is damaged or is not a checkpoint"));
  std::filesystem::remove(path_);
  EXPECT_THAT(refusal(), HasSubstr("there is no checkpoint"));
}

}  // namespace
}  // namespace kerf
