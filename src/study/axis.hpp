// SPDX-License-Identifier: Apache-2.0
// This header declares an axis of a study: a key of the case that is varied, and its values.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/key_path.hpp"

namespace kerf {

// A setting holds the value of each varied key in one run: a number in SI units, or a word.
struct Setting {
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> words;
  bool operator==(const Setting&) const = default;
};

struct Axis {
  KeyPath path;
  std::string shown_unit;          // the unit that the study file uses
  std::vector<double> values;      // SI; the list, or samples of the range
  std::vector<std::string> words;  // instead of values where the key holds a word
  bool is_range = false;           // any value from the first to the last is allowed
  bool is_logarithmic = false;     // the range is divided into equal ratios
  // Whether the case has minus a value: values are the magnitudes of a component of a vector that
  // points against its axis.
  bool is_reversed = false;

  const std::string& name() const { return path.text; }
  // Returns how many SI units one `shown_unit` has; 1 for a pure number.
  double shown_factor() const;
  // Returns the number that the case has for a value.
  double of_case(double value) const { return is_reversed ? -value : value; }
  std::size_t levels() const { return words.empty() ? values.size() : words.size(); }
  void put_level(std::size_t level, Setting& setting) const;
  // Sets the key to a point of the range, from 0 at its first end to 1 at its last. A list is
  // divided into equal parts, one for each level.
  void put_share(double share, Setting& setting) const;
};

// Returns the value at `share` of the way from `first` to `last`, in ratios if logarithmic.
double between(double first, double last, double share, bool is_logarithmic);

// Return "jet.jet.speed = 4 m/s" and "4 m/s", in the units of the study file.
std::string show(const Setting& setting, const std::vector<Axis>& axes);
std::string show_number(double value, const Axis& axis, int digits = 6);

}  // namespace kerf
