// SPDX-License-Identifier: Apache-2.0
// The order of the media of a run, which the field `source` of particles refers to: bodies, each at
// its finest spacing; jets; then the coarser levels of graded bodies. Output refers to bodies only.
#pragma once

#include <cstdint>
#include <vector>

namespace kerf {

struct Case;

struct MediumOrigin {
  std::uint16_t source = 0;  // body, or number of bodies + jet
  int level = 0;             // the spacing is 2^level times that of the case
};

std::vector<MediumOrigin> medium_origins(const Case& description);

// For each body, the media of its levels.
std::vector<std::vector<std::uint16_t>> media_of_levels(const Case& description);

}  // namespace kerf
