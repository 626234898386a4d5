// SPDX-License-Identifier: Apache-2.0
// The cross-section of a kerf with its dimensions, as an SVG element.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

// `kerf` as in result.json; empty where there is none.
std::string draw_kerf(const nlohmann::ordered_json& kerf);

}  // namespace kerf
