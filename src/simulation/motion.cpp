// SPDX-License-Identifier: Apache-2.0
#include "simulation/motion.hpp"

namespace kerf {

Motion::Motion(const Case& description, const std::vector<Nozzle>& nozzles)
    : bodies_(description.bodies.size()),
      origins_(medium_origins(description)),
      nozzles_(&nozzles) {
  for (const Body& body : description.bodies) {
    std::vector<Expression> components;
    if (!body.displacement[0].empty())
      for (int a = 0; a < description.dimension; ++a)
        components.emplace_back(body.displacement[static_cast<std::size_t>(a)],
                                std::vector<std::string>{"t"});
    expressions_.push_back(std::move(components));
  }
  erases_ = description.eraser.has_value();
  for (const Jet& jet : description.jets)
    erase_speed_.push_back(erases_ ? description.eraser->speed_fraction * jet.speed : 0.0);
}

Point Motion::displacement(std::size_t body, double time) const {
  Point place{};
  for (std::size_t a = 0; a < expressions_[body].size(); ++a)
    place[a] = expressions_[body][a].evaluate(time) - expressions_[body][a].evaluate(0.0);
  return place;
}

}  // namespace kerf
