// SPDX-License-Identifier: Apache-2.0
// The least thickness of a body that is still unbroken in the way of the jet, on the initial
// layout: a layer that the jet has pushed ahead or stretched keeps the thickness that it was laid
// out with.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/kerf_map.hpp"

namespace kerf {

// A particle is torn if it has lost more than this share of its bonds within its body (the column
// "body_damage", or "damage" where no body is joined to another): one beside a clean crack has lost
// 0.4 of them in 2D and in 3D, one in the row behind it 0.15.
inline constexpr double torn_share = 0.3;

// Returns whether a frame tells which particles are torn: it has one of these columns.
bool tells_torn(const Frame& frame);

// Returns the share of its bonds that each slot has lost, within its body; 1 of one that flaws have
// left no tension, 0 of one without a row.
std::vector<double> find_bond_loss(const Workpiece& workpiece, const Frame& frame,
                                   const std::vector<std::uint32_t>& rows);

// Returns whether each slot is torn; one without a row is not. A layer whose glue has broken is
// whole, but bonds between bodies that are one to the jet count (analysis/united_bodies.hpp).
std::vector<std::uint8_t> find_torn(const Workpiece& workpiece, const Frame& frame,
                                    const std::vector<std::uint32_t>& rows);

// Lengths along the jet, m, means over the window across the jet with the least share of unbroken
// solid, where the body was laid out in it. A window is as broad as that for the depth of a kerf
// (analysis/kerf_sections.hpp).
struct UnbrokenThickness {
  double laid_out = 0.0;
  double unbroken = 0.0;         // of particles that stand and are not torn
  double least = 0.0;            // of `unbroken`, of all windows
  bool is_open = false;          // there is a window without standing solid
  bool is_torn_through = false;  // there is a window without unbroken solid
};

// Measures the body `view.body` in the space of the jet along the path.
UnbrokenThickness measure_unbroken(const KerfView& view, const KerfAxes& axes,
                                   const KerfPath& path);

// How a body counts where bodies are measured together.
enum class BodyCount : std::uint8_t { not_at_all, as_laid_out, in_full };

// Measures bodies together: the lengths on a line are sums over the bodies on it. `counts` is by
// index into Case::bodies. Lines without a body that counts in full are left out.
UnbrokenThickness measure_unbroken(const KerfView& view, const KerfAxes& axes, const KerfPath& path,
                                   const std::vector<BodyCount>& counts);

// Returns the places across the jet, m local, of windows without unbroken solid: the middle of each
// row of them. In 2D, where a nozzle moves across the section.
std::vector<double> torn_places(const KerfView& view, const KerfAxes& axes, const KerfPath& path);

}  // namespace kerf
