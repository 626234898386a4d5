// SPDX-License-Identifier: Apache-2.0
#include "simulation/motion.hpp"

#include "model/case.hpp"

namespace kerf {

Motion::Motion(const Case& description)
    : bodies_(description.bodies.size()), origins_(medium_origins(description)) {
  for (const Body& body : description.bodies) {
    std::vector<Expression> components;
    if (!body.displacement[0].empty())
      for (int a = 0; a < description.dimension; ++a)
        components.emplace_back(body.displacement[static_cast<std::size_t>(a)],
                                std::vector<std::string>{"t"});
    expressions_.push_back(std::move(components));
  }
  removes_back_flow_ = description.back_flow_removal.has_value();
  for (const Jet& jet : description.jets)
    removal_speed_.push_back(
        removes_back_flow_ ? description.back_flow_removal->speed_fraction * jet.speed : 0.0);
}

Point Motion::displacement(std::size_t body, double time) const {
  Point result{};
  for (std::size_t a = 0; a < expressions_[body].size(); ++a)
    result[a] = expressions_[body][a].evaluate(time) - expressions_[body][a].evaluate(0.0);
  return result;
}

}  // namespace kerf
