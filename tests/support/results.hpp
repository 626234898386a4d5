// SPDX-License-Identifier: Apache-2.0
// Compares two result folders: all files except measured times must be equal.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "output/files.hpp"

namespace kerf::test {

inline nlohmann::ordered_json result_without_clock(const std::filesystem::path& folder) {
  auto result = nlohmann::ordered_json::parse(read_file(folder / "result.json"));
  result.erase("wall_time");
  result.erase("stage_times");
  return result;
}

inline std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

// Compares complete contents, because the bytes of pictures would not help in a message.
inline void expect_same_results(const std::filesystem::path& a, const std::filesystem::path& b) {
  EXPECT_TRUE(read_file(a / "series.csv") == read_file(b / "series.csv"));
  EXPECT_EQ(result_without_clock(a), result_without_clock(b));
  EXPECT_EQ(names_in(a), names_in(b));
  for (const char* inner : {"frames", "pictures"}) {
    ASSERT_EQ(names_in(a / inner), names_in(b / inner));
    for (const std::string& name : names_in(a / inner))
      EXPECT_TRUE(read_file(a / inner / name) == read_file(b / inner / name)) << name;
  }
}

}  // namespace kerf::test
