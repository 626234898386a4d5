// SPDX-License-Identifier: Apache-2.0
#include "simulation/media_order.hpp"

#include "model/case.hpp"

namespace kerf {

std::vector<MediumOrigin> medium_origins(const Case& description) {
  std::vector<MediumOrigin> origins;
  const std::size_t sources = description.bodies.size() + description.jets.size();
  for (std::size_t source = 0; source < sources; ++source)
    origins.push_back({static_cast<std::uint16_t>(source), 0});
  for (std::size_t body = 0; body < description.bodies.size(); ++body)
    for (int level = 1; level <= description.bodies[body].grading.levels; ++level)
      origins.push_back({static_cast<std::uint16_t>(body), level});
  return origins;
}

std::vector<std::vector<std::uint16_t>> media_of_levels(const Case& description) {
  std::vector<std::vector<std::uint16_t>> media(description.bodies.size());
  const auto origins = medium_origins(description);
  for (std::size_t medium = 0; medium < origins.size(); ++medium)
    if (origins[medium].source < media.size())
      media[origins[medium].source].push_back(static_cast<std::uint16_t>(medium));
  return media;
}

}  // namespace kerf
