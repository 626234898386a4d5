// SPDX-License-Identifier: Apache-2.0
// The quantities that particles of the moving picture are coloured by.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "output/read_frame.hpp"

namespace kerf {

struct ViewerField {
  const char *key, *label, *unit;
};
inline constexpr std::array<ViewerField, 8> viewer_fields{{
    {"speed", "speed", "m/s"},
    {"pressure", "pressure", "Pa"},
    {"equivalent_stress", "equivalent stress (von Mises)", "Pa"},
    {"equivalent_strain", "equivalent strain", "1"},
    {"damage", "damage", "1"},
    {"flaw_damage", "damage by flaws", "1"},
    {"plastic_strain", "plastic strain", "1"},
    {"temperature_rise", "rise of temperature", "K"},
}};

// By particle; zeros where the frame has no such column.
std::vector<float> field_values(const std::string& key, const Frame& frame);
// The bounds of values but for outliers; 0 is between them. Reorders the values.
std::pair<double, double> bounds_of(std::vector<float>& values);

}  // namespace kerf
