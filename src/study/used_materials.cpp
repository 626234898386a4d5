// SPDX-License-Identifier: Apache-2.0
#include "study/used_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/case.hpp"

namespace kerf {

std::vector<std::string> used_materials(const Case& description, const std::vector<Axis>& axes) {
  std::set<std::string> names;
  const auto add = [&](int material) {
    if (material >= 0) names.insert(description.materials.at(std::size_t(material)).name);
  };
  for (const Body& body : description.bodies) add(body.material);
  for (const Jet& jet : description.jets) add(jet.material);
  for (const Axis& axis : axes)
    if (axis.path.key->name == "material") names.insert(axis.words.begin(), axis.words.end());
  return {names.begin(), names.end()};
}

std::string unused_material(const KeyPath& path, const std::vector<std::string>& used) {
  if (path.segments.size() < 2 || path.segments[0] != "materials") return "";
  const std::string& name = path.segments[1];
  if (std::find(used.begin(), used.end(), name) != used.end()) return "";
  return fmt::format(
      "no body and no jet has the material \"{}\", so the key changes nothing; used "
      "are \"{}\"",
      name, fmt::join(used, "\", \""));
}

}  // namespace kerf
