// SPDX-License-Identifier: Apache-2.0
// Paths of keys and tables in a case, as messages write them: "body[1].grading.levels".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace kerf {

// A name of a path, and the number of an entry where the name is that of a list, from 1.
struct PathStep {
  std::string name;
  std::size_t entry = 0;
};
using PathSteps = std::vector<PathStep>;

PathSteps steps_of(std::string_view path);
PathSteps without_last(const PathSteps& steps);

// Returns the table at a path; null where there is none.
toml::table* table_at(toml::table& root, const PathSteps& steps);

}  // namespace kerf
