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

// Of which jets water counts: of Workpiece::jet, with its images in symmetry planes, or of all.
enum class WaterOf : std::uint8_t { own_jet, all_jets };

// Returns the depth of the front of this water along the axis of Workpiece::jet below `face`, m: a
// depth of the layout. It is 0 before contact or without a jet.
double front_depth(const Workpiece& workpiece, const Frame& frame, double face = 0.0,
                   WaterOf jets = WaterOf::own_jet);

// Returns the depth of the face, m, of a workpiece that comes towards the nozzle: minus the way by
// which nine tenths of its intact solid have come; 0 where it stands or recedes.
double face_depth(const Workpiece& workpiece, const Frame& frame,
                  const std::vector<std::uint32_t>& rows);

// Returns whether this water touches intact solid of the workpiece, or of any body where no body is
// in the way of the first jet.
bool touches_water(const Workpiece& workpiece, const Frame& frame,
                   const std::vector<std::uint32_t>& rows, WaterOf jets = WaterOf::all_jets);

// Returns the depth at which the axis leaves a body in current positions, m: its initial depth,
// moved by the median displacement of the intact solid around that point.
double bottom_depth(const Workpiece& workpiece, const WorkpieceBody& body, const Frame& frame,
                    const std::vector<std::uint32_t>& rows);

}  // namespace kerf
