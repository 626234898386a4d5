// SPDX-License-Identifier: Apache-2.0
// This header declares the fields by which particles of the moving picture are coloured.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "output/read_frame.hpp"

namespace kerf {

struct Case;

struct ViewerField {
  std::string key, label, unit;
  std::vector<std::string> names = {};  // of the groups that the values number; empty = a quantity
};

// The groups (report/viewer_groups.hpp), the speed, the pressure, the equivalent stress, and each
// further column of one number.
std::vector<ViewerField> viewer_fields(const Frame& frame, const Case& description);

// Returns the field of every particle; zeros where the frame has no such column.
std::vector<float> field_values(const std::string& key, const Frame& frame,
                                const Case& description);
// Returns the bounds of the values without outliers; they include 0. Reorders the values.
std::pair<double, double> bounds_of(std::vector<float>& values);

}  // namespace kerf
