// SPDX-License-Identifier: Apache-2.0
// Turns a case in space into one in the plane of x and y.
#include <algorithm>
#include <array>
#include <string_view>

#include "app/case_changes.hpp"

namespace kerf {

namespace {

// Keys that a plane case does not have.
constexpr std::array<std::string_view, 9> depth_keys{"azimuth",   "tilt_angle",    "orifice_length",
                                                     "fan_angle", "length",        "axis",
                                                     "depth",     "depth_minimum", "depth_maximum"};
constexpr std::array<std::string_view, 2> side_keys{"absorbing", "symmetry"};

template <class List>
bool holds(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

void flatten(toml::table& table);

void flatten_list(toml::array& list, bool of_sides) {
  if (of_sides) {
    for (std::size_t i = list.size(); i-- > 0;)
      if (list[i].value_or(std::string()).starts_with("z"))
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
  const bool is_point = list.size() == 3 && std::none_of(list.begin(), list.end(), [](auto& node) {
                          return node.is_table() || node.is_array();
                        });
  if (is_point) list.pop_back();
  for (toml::node& node : list)
    if (toml::table* entry = node.as_table()) flatten(*entry);
}

void flatten(toml::table& table) {
  for (const std::string_view key : depth_keys) table.erase(key);
  for (auto&& [key, node] : table) {
    if (toml::table* inner = node.as_table()) flatten(*inner);
    if (toml::array* list = node.as_array()) flatten_list(*list, holds(side_keys, key.str()));
  }
  if (table["type"].value_or(std::string()) == "sphere") table.insert_or_assign("type", "disc");
}

}  // namespace

toml::table as_plane_case(const toml::table& written) {
  toml::table plane = written;
  flatten(plane);
  plane.insert_or_assign("dimension", 2);
  return plane;
}

}  // namespace kerf
