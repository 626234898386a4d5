// SPDX-License-Identifier: Apache-2.0
#include "measure/leak.hpp"

#include <limits>

namespace kerf {

Leak measure_leak(const KerfView& view, const KerfAxes& axes) {
  constexpr double samples_per_spacing = 2.0;
  constexpr double breadth =
      1.5;  // of the spline, in spacings: single particles out of line count less
  constexpr double endless = std::numeric_limits<double>::infinity();
  const Workpiece& workpiece = view.workpiece;
  const Frame& frame = view.frame;
  std::vector<SolidPoint> solid;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot)
    if (is_intact(frame, view.rows[slot]))
      solid.push_back({axes.local(frame.position[view.rows[slot]]), workpiece.volume[slot],
                       breadth * workpiece.size[slot]});
  const SampleGrid grid =
      make_grid(solid, {-endless, -endless, -endless}, {endless, endless, endless},
                workpiece.axis_spacing / samples_per_spacing, frame.dimension);
  SolidField field(grid);
  field.add(solid);
  Leak leak;
  for (std::size_t row = 0; row < frame.id.size(); ++row) {
    if (frame.source[row] != workpiece.jet_source || frame.upstream[row] != 0) continue;
    leak.water += frame.mass[row];
    if (field.share_at(axes.local(frame.position[row])) > leak_share) leak.mass += frame.mass[row];
  }
  return leak;
}

}  // namespace kerf
