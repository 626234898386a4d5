// SPDX-License-Identifier: Apache-2.0
#include "analysis/crack_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "analysis/jet_face.hpp"
#include "analysis/open_paths.hpp"
#include "analysis/unbroken.hpp"
#include "analysis/void_places.hpp"

namespace kerf {
namespace {

constexpr double least_of_side = 0.75;  // of the intact mass of a side: the rest are scraps

// Returns the counted piece that is most of what is intact on a side; Workpiece::none without one.
std::uint32_t main_piece(const BodySides& sides, std::size_t side, const Workpiece& workpiece,
                         const Pieces& pieces) {
  std::map<std::uint32_t, double> masses;
  double intact = 0.0;
  for (const BodySides::Member& member : sides.members) {
    const std::uint32_t piece = pieces.body_piece[member.slot];
    if (member.side != side || piece == Workpiece::none) continue;
    intact += workpiece.mass[member.slot];
    if (pieces.in_piece[member.slot] != 0) masses[piece] += workpiece.mass[member.slot];
  }
  for (const auto& [piece, mass] : masses)
    if (mass >= least_of_side * intact) return piece;
  return Workpiece::none;
}

// The places of a body as far beside the jet as its sides reach, those that are open, and what the
// layout leaves empty between them.
class OpenSection {
 public:
  OpenSection(const KerfView& view, const KerfAxes& axes)
      : spacing_(view.workpiece.axis_spacing), half_width_(axes.jet.width / 2.0) {
    const Workpiece& workpiece = view.workpiece;
    const double reach =
        half_width_ + side_layers(workpiece, static_cast<std::uint16_t>(view.body), axes).reach;
    const std::vector<std::uint8_t> torn = find_torn(workpiece, view.frame, view.rows);
    std::vector<std::array<double, 3>> solids;
    std::vector<double> sizes;
    for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
      const auto x = axes.local(workpiece.position[slot]);
      if (!view.holds(slot) || std::abs(x[0]) > reach) continue;
      solids.push_back(x);
      sizes.push_back(workpiece.size[slot]);
      widen(x, sizes.back());
      const std::uint8_t standing = view.standing[slot];
      if (standing == 0 || (standing != stands_as_laid_out && torn[slot] != 0))
        open_.push_back({x, sizes.back()});
    }
    of_solid_ = open_.size();
    for (const VoidPlace& empty : find_void_places(solids, sizes, spacing_))
      open_.push_back({empty.position, empty.size});
  }

  // Returns whether a path leads through the body from its face in the space of the jet.
  bool leads_through() const {
    OpenPaths paths(open_);
    bool is_through = false;
    for (std::size_t n = 0; n < of_solid_ && !is_through; ++n)
      if (begins(open_[n]))
        paths.follow(n, [&](std::size_t reached) { is_through = is_through || ends(reached); });
    return is_through;
  }

 private:
  FaceColumn column_of(const std::array<double, 3>& x) const {
    return face_column({x[0], 0.0}, spacing_);
  }
  void widen(const std::array<double, 3>& x, double size) {
    const double top = x[2] - size / 2.0, bottom = x[2] + size / 2.0;
    ColumnEnds& ends = columns_.try_emplace(column_of(x), ColumnEnds{top, bottom}).first->second;
    ends = {std::min(ends.top, top), std::max(ends.bottom, bottom)};
  }
  bool begins(const OpenPlace& place) const {
    return std::abs(place.position[0]) <= in_way_reach(2.0 * half_width_, place.size) &&
           place.position[2] - place.size <= columns_.at(column_of(place.position)).top;
  }
  bool ends(std::size_t n) const {
    const OpenPlace& place = open_[n];
    return n < of_solid_ &&
           place.position[2] + place.size >= columns_.at(column_of(place.position)).bottom;
  }

  double spacing_, half_width_;  // m
  std::map<FaceColumn, ColumnEnds> columns_;
  std::vector<OpenPlace> open_;  // first those of solid
  std::size_t of_solid_ = 0;
};

}  // namespace

bool is_parted_by_crack(const BodySides& sides, const KerfView& view, const KerfAxes& axes,
                        const Pieces& pieces) {
  const std::uint32_t left = main_piece(sides, 0, view.workpiece, pieces);
  const std::uint32_t right = main_piece(sides, 1, view.workpiece, pieces);
  if (left == Workpiece::none || right == Workpiece::none || left == right) return false;
  return OpenSection(view, axes).leads_through();
}

}  // namespace kerf
