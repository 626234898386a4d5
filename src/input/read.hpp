// SPDX-License-Identifier: Apache-2.0
// These functions read a case file into plain data.
#pragma once

#include <filesystem>
#include <string_view>

namespace kerf {

struct Case;

// Both throw a UserError that names file, line, key, value, allowed range and remedy of up to ten
// problems. The same text gives the same Case, bit for bit.
Case read_case(const std::filesystem::path& file);
Case parse_case(std::string_view text, std::string_view file_name);

}  // namespace kerf
