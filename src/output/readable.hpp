// SPDX-License-Identifier: Apache-2.0
// These functions write quantities in sentences and in a terminal: with a suitable prefix, and
// times as those of a clock.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace kerf {

// Returns a time in words: "2.3 s", "12 s", "3 min 20 s", "1 h 05 min", "12 days", "2.5 years"; "?"
// for one that is not finite.
inline std::string duration_text(double seconds) {
  constexpr double day = 86400.0, year = 365.25 * day;
  if (!std::isfinite(seconds)) return "?";
  const long whole = std::lround(seconds);
  if (whole < 10) return fmt::format("{:.2g} s", seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  if (seconds < 2.0 * day) return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
  if (seconds < year) return fmt::format("{:.0f} days", seconds / day);
  return fmt::format("{:.2g} years", seconds / year);
}

// Returns `value` with its SI `unit`: 12.5 kPa, 6.7 us; times of a minute and more in words.
inline std::string readable(double value, const std::string& unit) {
  struct UnitPrefix {
    double factor;
    const char* name;
  };
  static constexpr UnitPrefix prefixes[] = {{1e9, "G"},  {1e6, "M"},  {1e3, "k"}, {1.0, ""},
                                            {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}};
  constexpr double rounded = 0.99995;  // 1.000 in four digits
  if (unit == "s" && value >= 60.0) return duration_text(value);
  for (const UnitPrefix& prefix : prefixes)
    if (std::abs(value) >= rounded * prefix.factor)
      return fmt::format("{:.4g} {}{}", value / prefix.factor, prefix.name, unit);
  return fmt::format("{:.4g} {}", value, unit);
}

}  // namespace kerf
