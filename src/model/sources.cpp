// SPDX-License-Identifier: Apache-2.0
#include "model/sources.hpp"

#include "model/case.hpp"

namespace kerf {

std::vector<std::string> source_names(const Case& description) {
  std::vector<std::string> names;
  for (const Body& body : description.bodies) names.push_back(body.name);
  for (const Jet& jet : description.jets) names.push_back(jet.name);
  return names;
}

std::vector<int> source_materials(const Case& description) {
  std::vector<int> materials;
  for (const Body& body : description.bodies)
    materials.push_back(body.role == Role::rigid ? -1 : body.material);
  for (const Jet& jet : description.jets) materials.push_back(jet.material);
  return materials;
}

}  // namespace kerf
