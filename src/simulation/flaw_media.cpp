// SPDX-License-Identifier: Apache-2.0
#include "simulation/flaw_media.hpp"

#include "simulation/levels.hpp"

namespace kerf {

std::vector<GradyKipp<double>> make_flaw_media(const Case& description,
                                               const std::vector<Medium<double>>& media) {
  std::vector<GradyKipp<double>> laws(media.size());
  const auto origins = medium_origins(description);
  for (std::size_t m = 0; m < origins.size(); ++m) {
    if (origins[m].source >= description.bodies.size()) continue;
    const Body& body = description.bodies[origins[m].source];
    if (body.role != Role::elastic) continue;
    const Material& material = description.materials.at(static_cast<std::size_t>(body.material));
    if (material.criterion != BondCriterion::grady_kipp) continue;
    const double depth = description.dimension == 2 ? material.flaw_depth : 1.0;
    laws[m] = GradyKipp<double>::of({material.weibull_k, material.weibull_m,
                                     material.crack_speed_share * media[m].longitudinal_speed},
                                    media[m].volume * depth, body.seed);
  }
  return laws;
}

}  // namespace kerf
