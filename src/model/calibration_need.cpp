// SPDX-License-Identifier: Apache-2.0
#include "model/calibration_need.hpp"

#include <fmt/format.h>

#include <set>
#include <vector>

#include "model/case.hpp"

namespace kerf {

std::string calibration_need(const Case& description) {
  std::set<int> told;  // materials
  std::vector<std::string> sentences;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic || body.fixed || body.material < 0) continue;
    const Material& material = description.materials.at(static_cast<std::size_t>(body.material));
    if (material.uncalibrated.empty() || !told.insert(body.material).second) continue;
    sentences.push_back(
        fmt::format("{} has values that are known within an interval only: {}. Calibrate them by "
                    "a test cut (kerf study with [calibrate]) before you trust depths and limits.",
                    material.name, material.uncalibrated));
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace kerf
