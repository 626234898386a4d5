// SPDX-License-Identifier: Apache-2.0
// A key of the case that a study varies, and the values it takes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/key_path.hpp"

namespace kerf {

// Where each varied key stands in one run: numbers in SI units, and texts that are no numbers.
struct Setting {
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> words;
  bool operator==(const Setting&) const = default;
};

struct Axis {
  KeyPath path;
  std::string shown_unit;          // the unit that the study wrote, for what people read
  std::vector<double> values;      // SI; as listed, or evenly over a range
  std::vector<std::string> words;  // instead of values where the key holds no number
  bool is_range = false;           // `values` are samples of all between the first and the last
  bool is_logarithmic = false;     // a range whose ratios count, not its differences

  const std::string& name() const { return path.text; }
  std::size_t levels() const { return words.empty() ? values.size() : words.size(); }
  void put_level(std::size_t level, Setting& setting) const;
  // A place in the range, 0 at its first end and 1 at its last; of a list, the level that is there.
  void put_share(double share, Setting& setting) const;
};

// The value at a share of the way from one to the other.
double between(double first, double last, double share, bool is_logarithmic);

// "jet.jet.speed = 4 m/s", in the units that the study wrote.
std::string show(const Setting& setting, const std::vector<Axis>& axes);
std::string show_number(double value, const Axis& axis);

}  // namespace kerf
