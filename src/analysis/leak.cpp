// SPDX-License-Identifier: Apache-2.0
#include "analysis/leak.hpp"

#include <limits>

namespace kerf {

const MetricList<Leak>& Leak::metrics() {
  static const MetricList<Leak> list{
      {"leaked_mass", extensive("kg"), "mass of leaked water",
       "Mass of the jets' water that lies inside intact solid, where no water can be.",
       &Leak::mass}};
  return list;
}

Leak Leak::measure(const KerfScene& scene) {
  // Width of the spline in spacings: over this width single displaced particles have little weight.
  constexpr double breadth = 1.5;
  constexpr double endless = std::numeric_limits<double>::infinity();
  const KerfView& view = scene.view;
  const KerfAxes& axes = scene.axes;
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
    if (!workpiece.is_jet_water(frame, row)) continue;
    leak.water += frame.mass[row];
    if (field.share_at(axes.local(frame.position[row])) > leak_share) leak.mass += frame.mass[row];
  }
  return leak;
}

}  // namespace kerf
