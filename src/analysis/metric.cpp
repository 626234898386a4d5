// SPDX-License-Identifier: Apache-2.0
#include "analysis/metric.hpp"

#include <limits>

namespace kerf {

std::string MetricUnit::in(int dimension) const {
  if (dimension != 2 || !extensive) return in_space;
  if (in_space.starts_with("m3")) return "m2" + in_space.substr(2);
  return in_space + "/m";
}

double number_of(const MetricValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? 1.0 : 0.0;
  if (const auto* count = std::get_if<std::int64_t>(&value)) return static_cast<double>(*count);
  if (const double* number = std::get_if<double>(&value)) return *number;
  return std::numeric_limits<double>::quiet_NaN();
}

std::string with_word(std::string text, const std::string& word) {
  for (std::size_t at; (at = text.find("{}")) != std::string::npos;) text.replace(at, 2, word);
  return text;
}

}  // namespace kerf
