// SPDX-License-Identifier: Apache-2.0
#include "verification/parameters.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "input/units.hpp"

namespace kerf {

std::string Parameters::text(const std::string& key) const {
  const auto found = values_.find(key);
  if (found == values_.end()) fail(fmt::format("lacks the key \"{}\"", key));
  read_[key] = true;
  return found->second;
}

std::string Parameters::text(const std::string& key, const std::string& fallback) const {
  return has(key) ? text(key) : fallback;
}

double Parameters::number(const std::string& key, const std::string& si_unit) const {
  if (si_unit.empty()) {
    std::size_t end = 0;
    const double value = std::stod(text(key), &end);
    if (end != text(key).size()) fail(fmt::format("{}: \"{}\" is not a number", key, text(key)));
    return value;
  }
  const Quantity quantity = read_quantity(text(key), si_unit);
  if (!quantity.problem.empty()) fail(fmt::format("{}: {}", key, quantity.problem));
  return quantity.value;
}

double Parameters::number(const std::string& key, const std::string& si_unit,
                          double fallback) const {
  return has(key) ? number(key, si_unit) : fallback;
}

std::vector<std::string> Parameters::unread() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : values_)
    if (!read_.count(key)) keys.push_back(key);
  return keys;
}

void Parameters::fail(const std::string& what) const {
  throw std::logic_error(fmt::format("{}: {}", where_, what));
}

}  // namespace kerf
