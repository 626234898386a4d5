// SPDX-License-Identifier: Apache-2.0
// The map of a kerf describes the remaining part of a workpiece, or of one of its layers, column by
// column along the jet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "analysis/kerf_axes.hpp"
#include "analysis/solid_field.hpp"
#include "analysis/workpiece.hpp"

namespace kerf {

// The positions of the solid that a map uses. Initial positions show the removed material without
// dents, recoil and the motion of separated halves. Current positions also show material that was
// displaced without fracture.
enum class KerfPositions { initial, current };

// In the marks of standing solid: that of a body that was pushed out of the domain, which stands as
// it was laid out whatever has become of its bonds there.
inline constexpr std::uint8_t stands_as_laid_out = 2;

// Marks the solid that stands, by slot: intact and in a counted piece, or intact and in no piece of
// the initial layout either.
std::vector<std::uint8_t> find_standing(const Workpiece& workpiece, const Frame& frame,
                                        const std::vector<std::uint32_t>& rows,
                                        const std::vector<std::uint8_t>& in_piece);

// A column: a line along the jet through the workpiece.
struct KerfColumn {
  bool exists = false;  // false = no solid was laid out here
  double top = 0.0;     // m, depth of the face towards the nozzle, as laid out
  double bottom = 0.0;  // m, of the far face
  double depth = 0.0;   // m, free of standing solid below `top`; all of it = cut through
};

struct KerfMap {
  SampleGrid grid;
  std::vector<float> taken;  // by sample: 0 in standing solid, 1 where it is removed; 1/2: the face
  std::vector<std::uint8_t> laid_out;  // by sample: whether solid was laid out there
  std::vector<KerfColumn> columns;

  const KerfColumn& column(std::size_t i, std::size_t j) const {
    return columns[i * grid.count[1] + j];
  }
  // Returns `taken` at a depth below the top of that column; 0 outside the workpiece.
  double taken_below_top(std::size_t i, std::size_t j, double below) const;
  // Whether solid was laid out at a depth below the top of that column.
  bool is_laid_out_below_top(std::size_t i, std::size_t j, double below) const;

 private:
  // Returns the number of that sample along the jet, with a fraction; negative outside the
  // workpiece.
  double sample_below_top(const KerfColumn& column, double below) const;
};

// The part of the path of the nozzle on which it has cut, as positions of the axis at depth 0.
struct KerfPath {
  std::array<double, 3> begin{};  // m, local
  std::array<double, 3> end{};
  // m, of it before its end, on which water that the nozzle has left behind may still be cutting
  double unsettled = 0.0;
};

// The workpiece, frame and standing particles that are mapped.
struct KerfView {
  const Workpiece& workpiece;
  const Frame& frame;
  const std::vector<std::uint32_t>& rows;
  const std::vector<std::uint8_t>& standing;
  KerfPositions positions = KerfPositions::initial;
  int body = -1;  // -1 = the complete workpiece
  bool holds(std::size_t slot) const { return body < 0 || workpiece.body[slot] == body; }
};

// Makes the map, which reaches `map_reach` jet widths from the path.
inline constexpr double map_reach = 5.0;
KerfMap make_kerf_map(const KerfView& view, const KerfAxes& axes, const KerfPath& path);

}  // namespace kerf
