// SPDX-License-Identifier: Apache-2.0
// This header declares the JSON of a setting, in study.json and in study.db: its numbers in SI
// units and its words, by their keys.
#pragma once

#include <nlohmann/json.hpp>

#include "study/axis.hpp"

namespace kerf {

nlohmann::ordered_json setting_json(const Setting& setting);
// Reads what setting_json() has made. Throws an exception of the library where it is damaged.
Setting setting_of(const nlohmann::ordered_json& json);

}  // namespace kerf
