// SPDX-License-Identifier: Apache-2.0
#include "report/viewer_fields.hpp"

#include <algorithm>
#include <cmath>

#include "report/viewer_groups.hpp"

namespace kerf {
namespace {

constexpr double outliers = 0.002;  // share of the particles at either end of the values

std::vector<float> speeds(const Frame& frame) {
  std::vector<float> values;
  for (const auto& v : frame.velocity)
    values.push_back(static_cast<float>(std::hypot(v[0], v[1], v[2])));
  return values;
}

// Returns von Mises' equivalent stress, Pa, of the deviatoric stress (xx yy zz xy yz xz).
std::vector<float> equivalent_stress(const Column& column) {
  std::vector<float> values;
  for (std::size_t k = 0; k + 5 < column.values.size(); k += 6) {
    const float* s = &column.values[k];
    const double normal = double(s[0]) * s[0] + double(s[1]) * s[1] + double(s[2]) * s[2];
    const double shear = double(s[3]) * s[3] + double(s[4]) * s[4] + double(s[5]) * s[5];
    values.push_back(static_cast<float>(std::sqrt(1.5 * (normal + 2.0 * shear))));
  }
  return values;
}

// "plastic strain" of a column "plastic_strain" that has no label.
std::string label_of(const Column& column) {
  if (column.name == "damage") return "crack (share of broken bonds)";
  std::string label = column.label.empty() ? column.name : column.label;
  if (column.label.empty()) std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

}  // namespace

std::vector<ViewerField> viewer_fields(const Frame& frame, const Case& description) {
  std::vector<ViewerField> fields;
  for (ViewerGroups& groups : viewer_groups(frame, description))
    fields.push_back({groups.key, groups.label, "1", std::move(groups.names)});
  fields.push_back({"speed", "speed", "m/s"});
  fields.push_back({"pressure", "pressure", "Pa"});
  fields.push_back({"equivalent_stress", "equivalent stress (von Mises)", "Pa"});
  for (const Column& column : frame.columns)
    if (column.components == 1) fields.push_back({column.name, label_of(column), column.unit});
  return fields;
}

std::vector<float> field_values(const std::string& key, const Frame& frame,
                                const Case& description) {
  if (auto groups = group_values(key, frame, description)) return std::move(*groups);
  if (key == "speed") return speeds(frame);
  if (key == "pressure") return frame.pressure;
  const Column* column = find_column(frame, key == "equivalent_stress" ? "deviatoric_stress" : key);
  if (column == nullptr) return std::vector<float>(frame.position.size(), 0.0f);
  return key == "equivalent_stress" ? equivalent_stress(*column) : column->values;
}

std::pair<double, double> bounds_of(std::vector<float>& values) {
  if (values.empty()) return {0.0, 0.0};
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const auto rank = static_cast<std::ptrdiff_t>(outliers * static_cast<double>(count));
  const auto at = [&](std::ptrdiff_t n) {
    std::nth_element(values.begin(), values.begin() + n, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(n)]);
  };
  return {std::min(0.0, at(rank)), std::max(0.0, at(count - 1 - rank))};
}

}  // namespace kerf
