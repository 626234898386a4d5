// SPDX-License-Identifier: Apache-2.0
// These functions read a case file into plain data.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/public_symbol.hpp"

namespace kerf {

struct Case;

// How large a case may be and how much work its checks are.
struct ReadEffort {
  double most_particles = 5e8;  // of a case; more are refused
  double most_tested = 2e7;     // nodes of a lattice, or columns of a jet, that a check looks at
};
// Accepts any size that can be counted, also those that a run refuses, and looks at so few nodes
// that every case is read within a second or so. A run reads with the default.
inline constexpr ReadEffort quick_look{1e15, 1e5};

// Both throw a UserError that names file, line, key, value, allowed range and remedy of up to ten
// problems. The same text gives the same Case, bit for bit, with any effort.
KERF_PUBLIC Case read_case(const std::filesystem::path& file, const ReadEffort& effort = {});
KERF_PUBLIC Case parse_case(std::string_view text, std::string_view file_name,
                            const ReadEffort& effort = {});
// Returns the text of a case file. Throws a UserError if it cannot be read.
std::string case_text(const std::filesystem::path& file);

}  // namespace kerf
