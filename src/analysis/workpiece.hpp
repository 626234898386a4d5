// SPDX-License-Identifier: Apache-2.0
// The workpiece in its initial layout, with which every later frame is compared. docs/metrics.md
// has the definition.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/body_sides.hpp"
#include "analysis/jet_axis.hpp"
#include "analysis/whole_frame.hpp"
#include "model/shape.hpp"
#include "simulation/frame.hpp"

namespace kerf {

struct Case;

// Of the columns and sections by which a kerf is measured.
inline constexpr double samples_per_spacing = 2.0;

// Positions that differ by less than this part of a spacing are one: a lattice whose particles have
// exactly the greatest distance from the axis is in the way of the jet at any angle.
inline constexpr double place_tolerance = 0.05;

// Returns the greatest distance from the axis, m, at which a particle of this size, m, is in the
// way of a jet of this width, m: half the width, or one spacing if that is more.
inline double in_way_reach(double width, double size) {
  return std::max(width / 2.0, size) + place_tolerance * size;
}

// A body of the workpiece.
struct WorkpieceBody {
  std::uint16_t body = 0;                  // index into Case::bodies
  bool can_break = false;                  // its material has a limit; otherwise nothing cuts it
  bool is_in_way = false;                  // the jet meets it at the place where it aims
  double bottom = 0.0;                     // m, depth at which the axis leaves it
  double below = 0.0;                      // m, along the jet, beyond the part that is simulated
  std::vector<std::uint32_t> exit_region;  // slots near that point
  std::vector<BodySides> sides;            // beside the jet, where the layout joins them
};

// A slot is the index of a particle in these tables, in the order of the initial frame. Particles
// are identified by their id, because a run sorts them and removes some. With symmetry planes the
// tables hold the whole workpiece: the slots of the part, then those of its images.
struct Workpiece {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  int dimension = 2;
  SymmetryImages images;
  std::optional<JetAxis> jet;    // the first jet, or `jet_index`
  std::uint16_t jet_index = 0;   // into Case::jets
  std::uint16_t jet_source = 0;  // index of the first jet of the case in Frame::source
  double jet_density = 0.0;      // kg/m^3
  std::unordered_map<std::uint32_t, std::uint32_t> slot_of_id;  // of the part
  std::vector<std::array<double, 3>> position;                  // m, initial
  std::vector<double> mass;                                     // kg (2D: kg/m)
  std::vector<double> volume;                 // m^3 (2D: m^2), at its material's density
  std::vector<double> size;                   // m, spacing of the particle
  std::vector<std::uint16_t> body;            // index into Case::bodies, the least of united ones
  std::vector<std::uint16_t> material_piece;  // bodies joined to each other share a number
  std::vector<WorkpieceBody> bodies;
  // Neighbours of the initial layout within `bond_reach` spacings of each other; empty where frames
  // say which particles bonds join.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> bonds;
  double interaction_range = 0.0;  // 2 h, spacings: longer pairs of particles do not interact
  double total_mass = 0.0;         // kg
  double spacing = 0.0;            // m, the largest
  double axis_spacing = 0.0;       // m, the largest beside the axis of the jet
  double bottom = 0.0;             // m, depth at which the axis leaves
  // As Pieces::in_piece, Pieces::body_piece and Pieces::count, of the first layout.
  std::vector<std::uint8_t> initially_in_piece;
  std::vector<std::uint32_t> initial_body_piece;
  int initial_pieces = 0;
  int jet_count = 0;          // of the case
  std::vector<JetAxis> jets;  // all, with their images
  // By index into Case::bodies: 1 = the body is one with others (analysis/united_bodies.hpp).
  std::vector<std::uint8_t> is_united;
  Box exits;                      // m, the domain; without end where a symmetry plane is its edge
  std::array<double, 3> drift{};  // m/s, at which the bodies in the way move from the start on

  // Returns the thickness of a body, by its index into Case::bodies, or of all (-1) beyond the part
  // that is simulated, along the jet, m.
  double below(int body) const;
  bool empty() const { return position.empty(); }
  // Whether a particle is water that has left a nozzle.
  bool is_jet_water(const Frame& frame, std::size_t row) const {
    const int source = frame.source[row] - jet_source;
    return source >= 0 && source < jet_count && frame.upstream[row] == 0;
  }
  // Whether such water is that of `jet`, or of one of its images.
  bool is_water_of_jet(const Frame& frame, std::size_t row) const {
    return frame.source[row] == jet_source + jet_index && is_jet_water(frame, row);
  }
  bool is_in_united(std::size_t slot) const {
    return !is_united.empty() && is_united[body[slot]] != 0;
  }
};

// Finds the workpiece: every elastic body that is not fixed and at which the first jet aims (a
// particle of it is nearer to the axis than half a jet width, or one spacing if that is more, and
// not behind the nozzle), and the bodies joined to it that are not fixed. Without a jet it is all
// elastic bodies that are not fixed. `initial` is the frame before the first step, of the whole
// workpiece (analysis/whole_frame.hpp).
Workpiece make_workpiece(const Case& description, const Frame& initial);

// Returns the same workpiece as a further jet of the case meets it: the same slots, with depths and
// sides along the axis of that jet. `jet`: index into Case::jets.
Workpiece along_jet(const Workpiece& workpiece, const Case& description, std::size_t jet);

// Returns the row of each slot in `frame`, which is of the whole workpiece; `none` for a particle
// that has left.
std::vector<std::uint32_t> locate(const Workpiece& workpiece, const Frame& frame);

// Returns whether a slot is intact solid, given its row.
inline bool is_intact(const Frame& frame, std::uint32_t row) {
  return row != Workpiece::none && frame.category[row] == Category::solid;
}

}  // namespace kerf
