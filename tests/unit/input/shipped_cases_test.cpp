// SPDX-License-Identifier: Apache-2.0
// Every file of cases/ is valid, and its case.used.toml is the same case.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "app/run_folder.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

std::vector<std::filesystem::path> case_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(KERF_SOURCE_DIR "/cases"))
    if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() != "studies")
      files.push_back(entry.path());
  return files;
}

TEST(ShippedCases, AreComplete) {
  std::vector<std::string> names;
  for (const auto& file : case_files()) names.push_back(file.stem());
  for (const char* name : {"tofu-5ms", "tofu-50ms", "tofu-50ms-erased", "tofu-2ms", "tofu-5ms-3d",
                           "tank", "rod-impact", "plate", "rings", "column-on-wall"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

TEST(ShippedCases, AreReadBackBitForBit) {
  for (const auto& file : case_files()) {
    const test::TemporaryFolder folder;
    const std::string name = folder / "case.used.toml";
    const Case original = read_case(file);
    keep_meshes(original, folder.path());
    const std::string used = write_used(original);
    EXPECT_EQ(parse_case(used, name), original) << file << '\n' << used;
    EXPECT_EQ(write_used(parse_case(used, name)), used) << file;
  }
}

// `kerf new` lists templates by their first line, so that has the form "# name: what".
TEST(ShippedCases, StartWithTheirNames) {
  for (const auto& file : case_files()) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line.rfind("# " + file.stem().string() + ": ", 0), 0u) << file;
  }
}

}  // namespace
}  // namespace kerf
