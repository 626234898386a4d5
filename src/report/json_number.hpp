// SPDX-License-Identifier: Apache-2.0
// Numbers of result.json, where null is no number.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>

namespace kerf {

inline double value_of(const nlohmann::ordered_json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace kerf
