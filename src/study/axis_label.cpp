// SPDX-License-Identifier: Apache-2.0
#include "study/axis_label.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "input/key_text.hpp"

namespace kerf {

namespace {

// Returns the number of the segment that names the key; behind it there may be the entry of a list.
std::size_t place_of_key(const KeyPath& path) {
  const std::size_t last = path.segments.size() - 1;
  return last > 0 && path.segments[last] != path.key->name ? last - 1 : last;
}

std::string short_label(const KeyPath& path) {
  const std::string label = key_label(*path.key);
  const std::size_t place = place_of_key(path);
  if (place + 1 == path.segments.size()) return label;
  const std::string& entry = path.segments.back();
  const bool is_vector = path.key->kind == ValueKind::vector;
  if (is_vector && entry.size() == 1 && entry[0] >= '0' && entry[0] <= '2')
    return fmt::format("{} {}", label, std::string(1, static_cast<char>('x' + (entry[0] - '0'))));
  return fmt::format("{} {}", label, entry);
}

}  // namespace

std::string axis_label(const Axis& axis, const std::vector<Axis>& axes) {
  const std::string label = short_label(axis.path);
  const auto same = std::count_if(axes.begin(), axes.end(), [&](const Axis& other) {
    return short_label(other.path) == label;
  });
  const std::size_t place = place_of_key(axis.path);
  if (same <= 1 || place == 0) return label;
  std::string owner;
  for (std::size_t n = 0; n < place; ++n) owner += (n == 0 ? "" : " ") + axis.path.segments[n];
  std::replace(owner.begin(), owner.end(), '_', ' ');
  return fmt::format("{} of {}", label, owner);
}

}  // namespace kerf
