// SPDX-License-Identifier: Apache-2.0
// An archive holds the state of a run as named arrays, independent of the format of checkpoint
// files.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace kerf {

using ArchiveArray =
    std::variant<std::vector<double>, std::vector<float>, std::vector<std::uint64_t>,
                 std::vector<std::uint32_t>, std::vector<std::uint16_t>, std::vector<std::uint8_t>>;

struct Archive {
  std::map<std::string, ArchiveArray> arrays;
  std::map<std::string, std::string> texts;
};

}  // namespace kerf
