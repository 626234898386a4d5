// SPDX-License-Identifier: Apache-2.0
// This file finds the connected pieces of intact solid. A frame of a formulation with bonds says
// which particles unbroken bonds join (Frame::piece), however far they are stretched. In a
// formulation without bonds two neighbours of the initial layout are joined while neither is
// fractured and they still interact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "analysis/metric.hpp"
#include "analysis/workpiece.hpp"

namespace kerf {

// Pairs of the initial layout, for frames without bonds: 1.3 spacings reach the nearest neighbours
// of a jittered or hexagonal lattice (1 spacing), but not the diagonal of a square one (1.41),
// across which a crack one particle wide would be bridged.
inline constexpr double bond_reach = 1.3;  // spacings
// Smaller pieces, as a share of the workpiece, are not counted.
inline constexpr double piece_mass_fraction = 0.05;

// Returns the pairs of slots that are neighbours in the initial layout and belong to the same body
// or to joined bodies.
std::vector<std::pair<std::uint32_t, std::uint32_t>> find_bonds(const Workpiece& workpiece);

// A connected piece of intact solid of any size.
struct Fragment {
  double mass = 0.0;    // kg (2D: kg/m)
  double volume = 0.0;  // m^3 (2D: m^2), as laid out
  std::size_t particles = 0;
  std::array<double, 3> centre{};    // m, of mass
  std::array<double, 3> velocity{};  // m/s, of the centre

  static const MetricList<Fragment>& metrics();
};

struct Pieces {
  int count = 0;  // heavier than piece_mass_fraction of the workpiece
  // Per slot: 1 = part of a counted piece, or of a piece of its body that is heavier than
  // piece_mass_fraction of that body, such as a small inclusion.
  std::vector<std::uint8_t> in_piece;
  // Per slot: a number that the particles of a piece within one body share, or within bodies that
  // are one to the jet (analysis/united_bodies.hpp); Workpiece::none where the particle is not
  // intact.
  std::vector<std::uint32_t> body_piece;
  std::vector<Fragment> fragments;  // the heaviest first
};

Pieces find_pieces(const Workpiece& workpiece, const Frame& frame,
                   const std::vector<std::uint32_t>& rows);

}  // namespace kerf
