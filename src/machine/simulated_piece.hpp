// SPDX-License-Identifier: Apache-2.0
// The part of a workpiece that is simulated: a window around the jet, with symmetry planes or a
// graded resolution, and whether the nozzle moves in the run. The rules and their reasons are in
// docs/theory/exposure.md.
#pragma once

#include <optional>

#include "model/jet.hpp"
#include "model/workpiece_setting.hpp"

namespace kerf {

struct Case;
struct Machine;

// The workpiece is simulated up to this distance from the water of the jet, in jet widths. Holes of
// plane jets in soft materials are wider than those of round ones, which push matter to all sides.
constexpr double window_reach(int dimension) {
  return dimension == 2 ? 24.0 : 8.0;
}
// The path of a nozzle that moves in the run, in jet widths.
inline constexpr double traverse_widths = 4.0;
// Water beyond the simulated part by this distance, in jet widths, is removed.
inline constexpr double domain_margin = 2.0;
// The domain below a workpiece, in its thicknesses: a bulge or a plug that the jet pushes out must
// stay in it until the end, since what has left is not judged. It is slower than the water, which
// comes three thicknesses below the workpiece in the time of passage_time(), and seven in twice
// that.
inline constexpr double room_below = 4.0;

// A draft in 3D under a nozzle that stands simulates so much of a workpiece that is thicker than
// `whole_depth`, both in jet widths: the law of the depth shows in it (docs/theory/exposure.md).
inline constexpr double draft_depth = 32.0, whole_depth = 48.0;
// The run of a part that ends within the workpiece ends where the front comes this near to its
// lower face, in jet widths.
inline constexpr double bottom_margin = 2.0;

// Returns the depth (m) of a workpiece that a draft simulates under a nozzle that stands.
double depth_of_draft(const Jet& jet, double thickness);

// Returns the thickness (m, along y) of the workpiece below the part that is simulated.
double thickness_below(const WorkpieceSetting& workpiece);

// Returns the depth of the front, along the jet, at which the run of a case ends, m; infinite where
// the part reaches down to the lower face of the workpiece.
double last_front_depth(const Case& description);

// Returns the time (s) of a run through the thickness (m) of a workpiece: the flight of the jet and
// twice the time of a penetration at half its speed.
double passage_time(const Jet& jet, double thickness);

// Returns the extent (m) of the jet at the workpiece along x, y (0) and z.
Point jet_extent(const Jet& jet, int dimension);

// Returns the time (s) for which the jet of a machine acts on a point of its path: its extent along
// the traverse over the traverse speed; infinity for a nozzle without a traverse.
double exposure_time(const Machine& machine, const Jet& jet, int dimension);

// Returns whether the nozzle may stand still in the run: it would move by less than the extent of
// its jet while that could pass the workpiece.
bool may_stand(const Machine& machine, const Jet& jet, double thickness, int dimension);

// Whether the nozzle of a [workpiece] stands in the run in place of one that moves.
bool stands_for_traverse(const Case& description);

// Returns the longest time (s) for which water can be in a run: that of the run, or that in which a
// window that travels with the nozzle passes a place.
double longest_stay(const Case& description);

struct SimulatedPiece {
  WorkpieceSetting workpiece;  // with its part and its resolution
  Faces symmetry;              // planes that bound the part
  Box domain;                  // m
};

// A narrower level of a grading, in smoothing lengths of the coarser one, would let particles
// interact across it.
inline constexpr double least_level_width = 2.0;

// What the choice is made for.
struct PieceRequest {
  Jet jet;             // its nozzle moves as it does in the run
  Point size;          // m, of the workpiece
  double depth = 0.0;  // m, of the thickness that is simulated
  int dimension = 3;
  double spacing = 0.0;    // m, of the workpiece at the jet
  bool may_mirror = true;  // whether the part may end at symmetry planes
  WorkpieceFrame frame = WorkpieceFrame::fixed;
  double smoothing_ratio = 1.3;  // of the case
  std::optional<int> levels;     // of resolution beside the finest, where they are not to be chosen
};
SimulatedPiece simulated_piece(const PieceRequest& request);

// Returns the domain around a part that ends at such planes, m.
Box domain_around(const PieceRequest& request, const Box& part, const Faces& planes);

// Returns the faces of the part beyond which the workpiece continues: they absorb waves.
Faces continued_faces(const WorkpieceSetting& workpiece, const Faces& symmetry, int dimension);

}  // namespace kerf
