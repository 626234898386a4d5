// SPDX-License-Identifier: Apache-2.0
// This header has the words and JSON values that several answers of a study share.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "study/searches.hpp"
#include "study/study_answers.hpp"

namespace kerf {

inline constexpr const char* alternating_verdicts =
    "The verdicts of the runs are not monotonic: they change more than once, and the interval "
    "contains all changes that were seen.";

// Returns a metric in words; lengths are in mm.
inline std::string metric_text(double value, const std::string& unit) {
  if (unit == "m") return fmt::format("{:.4g} mm", 1e3 * value);
  return unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

inline std::string plural(int count) {
  return count == 1 ? "" : "s";
}

inline nlohmann::ordered_json number_or_null(std::optional<double> value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

inline nlohmann::ordered_json bracket_json(const Bracket& bracket) {
  return {{"low", bracket.low}, {"high", bracket.high}};
}

Answer describe_optimum(const StudyPlan& plan, const OptimumAnswer& answer);

}  // namespace kerf
