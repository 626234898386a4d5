// SPDX-License-Identifier: Apache-2.0
// How far the water of a jet passes beside bodies.
#pragma once

#include <limits>
#include <vector>

namespace kerf {

struct Body;
struct Jet;

struct BesideJet {
  const Body* body = nullptr;  // the nearest one; none where all lie behind the exit of the nozzle
  double distance = std::numeric_limits<double>::infinity();  // m, from the water to its surface
};

// Returns the body that is nearest to the straight water of a jet. The surface of a body is found
// at its particles, of which `most` are tested.
BesideJet beside_jet(const Jet& jet, const std::vector<const Body*>& bodies, int dimension,
                     double most);

}  // namespace kerf
