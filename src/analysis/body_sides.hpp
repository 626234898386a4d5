// SPDX-License-Identifier: Apache-2.0
// The two sides of a body beside the jet, and whether a piece of the body still joins them. This is
// decided by the pieces (analysis/pieces.hpp) and the initial layout alone, so that a layer of
// solid that the jet only stretches, bends or pushes ahead joins the sides, and a part that breaks
// off elsewhere does not count as a cut.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "analysis/kerf_axes.hpp"

namespace kerf {

struct Workpiece;

enum class Joint { joined, parted, unknown };

// Each side is divided into layers at right angles to a direction across the jet. A layer is
// thicker than the longest bond, so that every chain of bonds that passes it has a particle in it.
// The layers begin where the space of the jet ends, and reach as far as the body is thick, or four
// jet widths if that is more.
struct BodySides {
  struct Member {
    std::uint32_t slot = 0;
    std::uint16_t side = 0, layer = 0;
  };
  std::vector<Member> members;
  std::array<std::vector<double>, 2> mass;  // kg, of each layer in the initial layout
};

// The layers beside the jet, and the body there, m.
struct SideLayers {
  double thickness = 0.0;       // of a layer, across the jet
  double reach = 0.0;           // of all layers of a side
  double body_thickness = 0.0;  // of the body, along the jet
};
SideLayers side_layers(const Workpiece& workpiece, std::uint16_t body, const KerfAxes& axes);

// Returns the sides of a body for each direction across the jet in which the initial layout joins
// them: one in 2D, four in 3D, the first at right angles to the plane of the cut. `body_piece`:
// that of the initial layout, by slot (Pieces).
std::vector<BodySides> find_sides(const Workpiece& workpiece, std::uint16_t body,
                                  const KerfAxes& axes,
                                  const std::vector<std::uint32_t>& body_piece);

// The sides are parted if there is a layer on each that no piece has a particle in both of. A layer
// counts while half of its mass is intact, so that a side that has crumbled beside the jet does not
// part the body, and if it shares a piece with the nearest such layer, so that a part that breaks
// off farther out does not either. Without a layer on each side the answer is unknown.
Joint joint_of(const BodySides& sides, const Workpiece& workpiece,
               const std::vector<std::uint32_t>& body_piece);

}  // namespace kerf
