// SPDX-License-Identifier: Apache-2.0
// What `kerf check` says about spacings: of each body, and where they matter.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"

namespace kerf {

// One row per body: its name, and its particles level by level.
std::vector<std::pair<std::string, std::string>> particle_rows(const Case& description);

// One sentence for each spacing that is too coarse, or each grading that is too steep or too near
// to the cut: key, value, range and remedy.
std::vector<std::string> resolution_warnings(const Case& description);

}  // namespace kerf
