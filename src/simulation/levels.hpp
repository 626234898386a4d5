// SPDX-License-Identifier: Apache-2.0
// The media of a run in their order, which is what a particle's `source` counts: bodies, each at
// its finest spacing; jets; then the coarser levels of graded bodies. Everybody else sees bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "case/case.hpp"

namespace kerf {

struct MediumOrigin {
  std::uint16_t source = 0;  // body, or number of bodies + jet
  int level = 0;             // the spacing is 2^level times that of the case
};

std::vector<MediumOrigin> medium_origins(const Case& description);

// Of each body, the media of its levels.
std::vector<std::vector<std::uint16_t>> media_of_levels(const Case& description);

}  // namespace kerf
