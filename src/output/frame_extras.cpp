// SPDX-License-Identifier: Apache-2.0
#include "output/frame_extras.hpp"

#include <algorithm>
#include <limits>

#include "model/case.hpp"
#include "model/sources.hpp"

namespace kerf {

FrameLegend legend_of(const Case& description) {
  FrameLegend legend;
  legend.bodies = source_names(description);
  for (const Material& material : description.materials) legend.materials.push_back(material.name);
  legend.materials.push_back("rigid");
  const auto rigid = static_cast<std::uint8_t>(description.materials.size());
  for (const int material : source_materials(description))
    legend.material.push_back(material < 0 ? rigid : static_cast<std::uint8_t>(material));
  return legend;
}

std::vector<std::uint8_t> materials_of(const Frame& frame, const FrameLegend& legend) {
  std::vector<std::uint8_t> materials;
  for (const std::size_t source : frame.source)
    materials.push_back(legend.material[std::min(source, legend.material.size() - 1)]);
  return materials;
}

std::vector<float> full_stress(const Frame& frame) {
  const Column* deviatoric = find_column(frame, "deviatoric_stress");
  if (deviatoric == nullptr || deviatoric->components != 6) return {};
  std::vector<float> stress = deviatoric->values;
  for (std::size_t i = 0; i < frame.pressure.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a) stress[6 * i + a] -= frame.pressure[i];
  return stress;
}

FrameMotion motion_of(const Frame& frame, const FrameLegend& legend) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  FrameMotion motion;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    const auto known = legend.start.find(frame.id[i]);
    const auto start = known == legend.start.end() ? std::array{none, none, none} : known->second;
    std::array<float, 3> moved{};
    for (std::size_t a = 0; a < 3; ++a)
      moved[a] = static_cast<float>(frame.position[i][a] - start[a]);
    motion.reference.push_back(start);
    motion.displacement.push_back(moved);
  }
  return motion;
}

}  // namespace kerf
