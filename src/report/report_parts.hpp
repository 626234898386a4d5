// SPDX-License-Identifier: Apache-2.0
// This header declares the parts of report.html that have files of their own, and how numbers of
// result.json are read for them.
#pragma once

#include <nlohmann/json.hpp>

#include <limits>
#include <string>

namespace kerf {

struct Case;

// Returns a number of result.json; NaN for null.
inline double value_of(const nlohmann::ordered_json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

// Returns the table of the setting of the machine and its jet from result.json.
std::string machine_table(const nlohmann::ordered_json& result);
// Returns the table of the exposure from result.json, which has one.
std::string exposure_table(const nlohmann::ordered_json& result);
// Returns the table of the workpiece, its materials and its thickness at the jet, from the object
// `kerf` of result.json.
std::string workpiece_table(const nlohmann::ordered_json& kerf, const Case& description);

// Returns whether the workpiece is cut through although the kerf goes through nowhere on the path:
// the rest has a crack.
inline bool is_parted(const nlohmann::ordered_json& result) {
  return result.contains("kerf") && result.at("cut_through").get<bool>() &&
         !result.at("kerf").at("through").get<bool>() &&
         !(value_of(result.at("kerf").at("through_share")) > 0.0);
}

// Returns the part on the kerf and the machine, a drawing and tables; empty for a run without a
// jet.
std::string kerf_part(const nlohmann::ordered_json& result, const Case& description);
// Returns the table of the intervals of the headline numbers, from the list `intervals` of
// result.json, or the remark that there are none; empty for a run without a jet.
std::string intervals_table(const nlohmann::ordered_json& result);
// Returns the tables of all other numbers.
std::string report_tables(const nlohmann::ordered_json& result, const Case& description);

}  // namespace kerf
