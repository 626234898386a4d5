// SPDX-License-Identifier: Apache-2.0
// What `kerf run --json-summary` prints, for programs.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

// Returns the summary of a finished run as JSON, in SI units. `result` is the content of its
// result.json; keys that it does not have are null.
std::string run_json(const nlohmann::ordered_json& result, const std::filesystem::path& folder);

}  // namespace kerf
