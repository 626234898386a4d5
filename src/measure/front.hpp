// SPDX-License-Identifier: Apache-2.0
// How deep the water is.
#pragma once

#include <cstdint>
#include <vector>

#include "measure/workpiece.hpp"

namespace kerf {

// The front is the depth beyond which the next jet width holds less than this part of a plug of
// the jet (nozzle section times jet width), so that single leaked drops are no front.
inline constexpr double front_plug_fraction = 0.1;
// Nor are a few particles where the jet itself is only a few particles wide.
inline constexpr double front_least_particles = 3.0;

// Depth of the water front of the first jet, m; 0 before contact or without a jet.
double front_depth(const Workpiece& workpiece, const Frame& frame);

// Depth at which the axis leaves the workpiece now, m: as laid out, moved by the median
// displacement of the intact solid around that place.
double bottom_depth(const Workpiece& workpiece, const Frame& frame,
                    const std::vector<std::uint32_t>& rows);

}  // namespace kerf
