// SPDX-License-Identifier: Apache-2.0
// These functions find the depth of the water and of the far face of the workpiece.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/workpiece.hpp"

namespace kerf {

// The front is the depth beyond which the next jet width holds less than this part of a plug of the
// jet (nozzle section times jet width), so that single leaked drops do not make a front.
inline constexpr double front_plug_fraction = 0.1;
// Fewer particles than this do not make a front either, if the jet is only a few particles wide.
inline constexpr double front_least_particles = 3.0;

// Returns the depth of the water front of the first jet, m; 0 before contact or without a jet.
double front_depth(const Workpiece& workpiece, const Frame& frame);

// Returns the depth at which the axis leaves a body in current positions, m: its initial depth,
// moved by the median displacement of the intact solid around that point.
double bottom_depth(const Workpiece& workpiece, const WorkpieceBody& body, const Frame& frame,
                    const std::vector<std::uint32_t>& rows);

}  // namespace kerf
