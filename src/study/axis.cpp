// SPDX-License-Identifier: Apache-2.0
#include "study/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/units.hpp"

namespace kerf {

void Axis::put_level(std::size_t level, Setting& setting) const {
  if (words.empty())
    setting.numbers[name()] = values.at(level);
  else
    setting.words[name()] = words.at(level);
}

void Axis::put_share(double share, Setting& setting) const {
  if (is_range) {
    setting.numbers[name()] = between(values.front(), values.back(), share, is_logarithmic);
    return;
  }
  const auto count = static_cast<double>(levels());
  put_level(static_cast<std::size_t>(std::clamp(share * count, 0.0, count - 1.0)), setting);
}

double between(double first, double last, double share, bool is_logarithmic) {
  if (is_logarithmic) return first * std::pow(last / first, share);
  return first + (last - first) * share;
}

double Axis::shown_factor() const {
  return path.unit().empty() ? 1.0 : read_quantity("1 " + shown_unit, path.unit()).value;
}

std::string show_number(double value, const Axis& axis, int digits) {
  if (axis.path.unit().empty()) return fmt::format("{:.{}g}", value, digits);
  return fmt::format("{:.{}g} {}", value / axis.shown_factor(), digits, axis.shown_unit);
}

std::string show(const Setting& setting, const std::vector<Axis>& axes) {
  std::vector<std::string> parts;
  for (const Axis& axis : axes) {
    const auto number = setting.numbers.find(axis.name());
    const auto word = setting.words.find(axis.name());
    if (number != setting.numbers.end())
      parts.push_back(
          fmt::format("{} = {}", axis.name(), show_number(axis.of_case(number->second), axis)));
    if (word != setting.words.end())
      parts.push_back(fmt::format("{} = \"{}\"", axis.name(), word->second));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace kerf
