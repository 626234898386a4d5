// SPDX-License-Identifier: Apache-2.0
#include "study/read_condition.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <regex>

#include "core/error.hpp"
#include "output/result_metrics.hpp"
#include "study/metrics.hpp"

namespace kerf {

Quantity read_value(const std::string& text, const std::string& si_unit) {
  if (!si_unit.empty()) return read_quantity(text, si_unit);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_number = end != text.c_str() && *end == '\0' && std::isfinite(value);
  return is_number ? Quantity{value, ""} : Quantity{0.0, "this is no number"};
}

Condition read_where(const std::string& text, int dimension) {
  static const std::regex form(R"(\s*([\w.]+)\s*(>=|<=)\s*(\S.*?)\s*)");
  std::smatch parts;
  const bool has_form = std::regex_match(text, parts, form);
  const std::string problem = has_form ? why_no_number(parts[1].str()) : "this is no condition";
  if (!problem.empty())
    throw UserError(fmt::format(
        "--where \"{}\": {}. Allowed: METRIC >= VALUE or METRIC <= VALUE. Write for example "
        "\"kerf.depth >= 5 mm\"; docs/metrics.md has all metrics.",
        text, problem));
  Condition condition;
  condition.metric = parts[1].str();
  condition.at_least = parts[2].str() == ">=";
  const std::string unit = metric_unit(condition.metric, dimension);
  const Quantity quantity = read_value(parts[3].str(), unit);
  if (!quantity.problem.empty())
    throw UserError(fmt::format(
        "--where \"{}\": {}: {}. Allowed: {}. Correct the value.", text, parts[3].str(),
        quantity.problem, unit.empty() ? "a pure number" : "a number with a unit of " + unit));
  condition.bound = quantity.value;
  condition.written = parts[3].str();
  return condition;
}

}  // namespace kerf
