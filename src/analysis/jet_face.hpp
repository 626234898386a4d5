// SPDX-License-Identifier: Apache-2.0
// The face at the axis of a jet, from which depths count. Beside a step of the face the workpiece
// is thicker, and what is open there is no deeper for it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>

namespace kerf {

// A column of the layout along the jet: which one crosswise and lengthwise.
using FaceColumn = std::pair<long, long>;
// Returns the column of a place, m local (crosswise, lengthwise). `breadth`: of a column, m.
FaceColumn face_column(const std::array<double, 2>& place, double breadth);

// Where the layout begins in a column, and where it ends.
struct ColumnEnds {
  double top = 0.0, bottom = 0.0;  // m, along the jet
};

class JetFace {
 public:
  // `columns`: of the workpiece, `breadth` broad, m. `reach`: of the jet from its axis, m.
  // `core`: of the columns that are on the axis, m.
  JetFace(std::map<FaceColumn, ColumnEnds> columns, double breadth, double reach, double core);

  // Returns the depth of the face beside a place of the path of the axis, m: that at the axis,
  // continued by the slope that the face has within the reach of the jet. `path`: the place, m
  // local (crosswise, lengthwise); `offset`: from it, m; `top`: where the layout begins there, m,
  // which is the face where it is no step above the other, and where nothing is on the axis.
  double depth_at(const std::array<double, 2>& path, const std::array<double, 2>& offset,
                  double top) const;

 private:
  struct Plane {
    double depth = 0.0;             // m, on the axis
    std::array<double, 2> slope{};  // to a plane across the jet
  };
  std::optional<Plane> find_plane(const FaceColumn& path) const;
  double find_slope(const FaceColumn& path, std::size_t direction) const;

  std::map<FaceColumn, ColumnEnds> columns_;
  double breadth_, reach_, core_;
  mutable std::map<FaceColumn, std::optional<Plane>> planes_;  // found so far, by place
};

}  // namespace kerf
