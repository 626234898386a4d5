// SPDX-License-Identifier: Apache-2.0
// The tables beside the drawing of a kerf.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "case/case.hpp"

namespace kerf {

// `machine` and `kerf` as in result.json.
std::string machine_table(const nlohmann::ordered_json& machine, int dimension);
// What its bodies are made of, and how thick it is where the jet meets it.
std::string workpiece_table(const nlohmann::ordered_json& kerf, const Case& description);

// Cut through, and yet not by taking material away all the way down: the rest has cracked.
inline bool is_parted(const nlohmann::ordered_json& result) {
  return result.contains("kerf") && result.at("cut_through").get<bool>() &&
         !result.at("kerf").at("through").get<bool>();
}

}  // namespace kerf
