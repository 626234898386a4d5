// SPDX-License-Identifier: Apache-2.0
#include "analysis/opening_width.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/cell_share.hpp"

namespace kerf {

double fractured_width(const Workpiece& workpiece, const Frame& frame,
                       const std::vector<std::uint32_t>& rows, double depth) {
  const JetAxis& jet = *workpiece.jet;
  const double thickness = std::max(jet.width / 2.0, 2.0 * workpiece.axis_spacing);
  // The section across a round jet is a strip of that thickness through the axis.
  const bool flat = frame.dimension == 2;
  double area = 0.0;
  for (std::size_t slot = 0; slot < rows.size(); ++slot) {
    if (is_intact(frame, rows[slot])) continue;
    const auto& x = workpiece.position[slot];
    const double size = workpiece.size[slot];
    const double strip = flat ? 1.0 : cell_share(jet.side(x), size, thickness) * size / thickness;
    area += size * size * cell_share(jet.depth(x) - depth, size, thickness) * strip;
  }
  return area / thickness;
}

double opening_width(const Workpiece& workpiece, const Frame& frame,
                     const std::vector<std::uint32_t>& rows,
                     const std::vector<std::uint8_t>& in_piece, double depth) {
  const JetAxis& jet = *workpiece.jet;
  double right = std::numeric_limits<double>::infinity();
  double left = right, right_edge = 0.0, left_edge = 0.0;
  for (std::size_t slot = 0; slot < rows.size(); ++slot) {
    const double size = workpiece.size[slot];
    const auto in_layer = [&](const std::array<double, 3>& x) {
      return std::abs(jet.depth(x) - depth) <= size && std::abs(jet.side(x)) <= size;
    };
    const auto& before = workpiece.position[slot];
    if (in_layer(before)) {
      right_edge = std::max(right_edge, jet.offset(before) + size / 2.0);
      left_edge = std::max(left_edge, -jet.offset(before) + size / 2.0);
    }
    if (!in_piece[slot] || !in_layer(frame.position[rows[slot]])) continue;
    const double offset = jet.offset(frame.position[rows[slot]]);
    double& nearest = offset >= 0.0 ? right : left;
    nearest = std::min(nearest, std::max(0.0, std::abs(offset) - size / 2.0));
  }
  return (std::isinf(right) ? right_edge : right) + (std::isinf(left) ? left_edge : left);
}

}  // namespace kerf
