// SPDX-License-Identifier: Apache-2.0
#include "study/named_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace kerf {

namespace {

// Returns whether the key of `inner` is that of `outer` or one number of it.
bool is_within(const NamedKey& inner, const NamedKey& outer) {
  return inner.path.place == outer.path.place ||
         inner.path.place.starts_with(outer.path.place + ".");
}

// Returns whether the value that [set] gives a key, or a setting of a calibration gives the key
// that is calibrated, is replaced in the runs that it is for. A prediction may have another value
// than [set], which is that of the measured cut.
bool is_replaced(const NamedKey& one, const NamedKey& other) {
  if (one.table == "set")
    return other.table != "set" && !other.table.starts_with("calibrate.predict");
  return other.table == "calibrate" && one.table.starts_with("calibrate.");
}

bool replace_each_other(const NamedKey& a, const NamedKey& b) {
  return is_replaced(a, b) || is_replaced(b, a);
}

// Returns what is wrong with the later one of two keys; "" = nothing.
std::string fault_of(const NamedKey& earlier, const NamedKey& later) {
  const bool is_same = earlier.path.place == later.path.place;
  const bool is_of_one_table = earlier.table == later.table;
  if (is_of_one_table && (is_within(earlier, later) || is_within(later, earlier)))
    return "the table has this key twice";
  if (!is_same) return "";
  if (replace_each_other(earlier, later))
    return "both give the same key a value, and only one can hold";
  if (earlier.path.text != later.path.text) return "this is the same key under another name";
  return "";
}

std::string remedy_of(const NamedKey& earlier, const NamedKey& later) {
  if (earlier.table == later.table || replace_each_other(earlier, later))
    return "Remove one of the two";
  return fmt::format("Write \"{}\" in both places", earlier.path.text);
}

}  // namespace

void refuse_repeated_keys(const std::vector<NamedKey>& named, Problems& problems) {
  std::vector<NamedKey> sorted = named;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const NamedKey& a, const NamedKey& b) { return a.line < b.line; });
  const auto refuse = [&](std::size_t i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::string fault = fault_of(sorted[j], sorted[i]);
      if (fault.empty()) continue;
      problems.add(
          {sorted[i].reported_key,
           fmt::format("{}: see {} in line {}", fault, sorted[j].reported_key, sorted[j].line),
           "each key once, under one name", remedy_of(sorted[j], sorted[i])});
      return;
    }
  };
  for (std::size_t i = 1; i < sorted.size(); ++i) refuse(i);
}

}  // namespace kerf
