// SPDX-License-Identifier: Apache-2.0
#include "simulation/flaw_media.hpp"

namespace kerf {

std::vector<GradyKipp<double>> make_flaw_media(const Case& description,
                                               const std::vector<Medium<double>>& media) {
  std::vector<GradyKipp<double>> laws(media.size());
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const Body& body = description.bodies[b];
    if (body.role != Role::elastic) continue;
    const Material& material = description.materials.at(static_cast<std::size_t>(body.material));
    if (material.criterion != BondCriterion::grady_kipp) continue;
    const double depth = description.dimension == 2 ? material.flaw_depth : 1.0;
    laws[b] = GradyKipp<double>::of({material.weibull_k, material.weibull_m,
                                     material.crack_speed_share * media[b].longitudinal_speed},
                                    media[b].volume * depth, body.seed);
  }
  return laws;
}

}  // namespace kerf
