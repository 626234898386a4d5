// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "analysis/jet_face.hpp"
#include "analysis/open_paths.hpp"
#include "analysis/unbroken.hpp"
#include "analysis/void_places.hpp"

namespace kerf {
namespace {

constexpr std::size_t every_body = std::numeric_limits<std::size_t>::max();

// A particle of the layout within the space of the jet, or a place that the layout leaves empty
// below solid, of the body of which it then is.
struct TubePoint {
  std::array<double, 3> position{};  // m, local
  std::array<double, 2> offset{};    // m, across the jet, from the nearest place of its path
  double size = 0.0;                 // m
  std::size_t body = 0;              // index into Workpiece::bodies
  bool is_open = false, is_void = false;
  bool is_aside = false;  // a spacing beside the space, so that none looks empty at its edge
};

using TubeColumn = std::pair<std::size_t, FaceColumn>;  // of a body
using TubeColumns = std::map<TubeColumn, ColumnEnds>;

double tube_edge(const TubePoint& point) {
  return point.position[2] - point.size / 2.0;
}

TubeColumn tube_column(const TubePoint& point, std::size_t body, double spacing) {
  return {body, face_column({point.position[0], point.position[1]}, spacing)};
}

std::vector<TubePoint> points_in_tube(const KerfView& view, const KerfAxes& axes,
                                      const std::vector<BodyCut>& bodies) {
  const Workpiece& workpiece = view.workpiece;
  const double reach = std::max(axes.jet.width, workpiece.axis_spacing);
  const std::vector<std::uint8_t> torn = find_torn(workpiece, view.frame, view.rows);
  std::vector<TubePoint> points;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const auto& x = workpiece.position[slot];
    const auto swept = axes.jet.swept(x, view.frame.time);
    const double distance = axes.jet.distance(swept);
    if (distance > reach + workpiece.size[slot]) continue;
    const bool is_aside = distance > reach;
    const auto body =
        static_cast<std::size_t>(std::find_if(workpiece.bodies.begin(), workpiece.bodies.end(),
                                              [&](const WorkpieceBody& other) {
                                                return other.body == workpiece.body[slot];
                                              }) -
                                 workpiece.bodies.begin());
    const bool is_out =
        bodies[body].left;  // what becomes of a body beyond the domain is not judged
    const std::uint8_t standing = view.standing[slot];
    const bool is_open = !is_out && !is_aside &&
                         (standing == 0 || (standing != stands_as_laid_out && torn[slot] != 0));
    const auto beside = axes.local(swept);
    points.push_back({axes.local(x),
                      {beside[0], beside[1]},
                      workpiece.size[slot],
                      body,
                      is_open,
                      false,
                      is_aside});
  }
  return points;
}

// Adds the places that the layout leaves empty: the water comes through them.
void add_voids(const std::vector<TubePoint>& points, double spacing, std::vector<TubePoint>& open) {
  std::vector<std::array<double, 3>> places;
  std::vector<double> sizes;
  for (const TubePoint& point : points) {
    places.push_back(point.position);
    sizes.push_back(point.size);
  }
  for (const VoidPlace& empty : find_void_places(places, sizes, spacing))
    if (const TubePoint& above = points[empty.above]; !above.is_aside)
      open.push_back({empty.position, above.offset, empty.size, above.body, true, true});
}

// Returns the columns of each body, and those of all together.
TubeColumns find_columns(const std::vector<TubePoint>& points, double spacing) {
  TubeColumns columns;
  for (const TubePoint& point : points)
    for (const std::size_t body : {point.body, every_body}) {
      const double edge = tube_edge(point), end = edge + point.size;
      const auto [column, is_new] =
          columns.try_emplace(tube_column(point, body, spacing), ColumnEnds{edge, end});
      ColumnEnds& ends = column->second;
      ends = {std::min(ends.top, edge), std::max(ends.bottom, end)};
    }
  return columns;
}

std::map<FaceColumn, ColumnEnds> columns_of_all(const TubeColumns& columns) {
  std::map<FaceColumn, ColumnEnds> all;
  for (const auto& [column, ends] : columns)
    if (column.first == every_body) all.emplace(column.second, ends);
  return all;
}

// Returns the greatest length of the workpiece along the jet in its space, m.
double greatest_length(const std::vector<TubePoint>& points, const TubeColumns& columns,
                       double reach, double spacing) {
  double greatest = 0.0;
  for (const TubePoint& point : points) {
    if (std::hypot(point.offset[0], point.offset[1]) > reach) continue;
    const ColumnEnds& ends = columns.at(tube_column(point, every_body, spacing));
    greatest = std::max(greatest, ends.bottom - ends.top);
  }
  return greatest;
}

// Returns whether the water can reach the face of each body: all bodies in the way that begin above
// it are cut through.
std::vector<std::uint8_t> find_bare(const Workpiece& workpiece, const TubeColumns& columns,
                                    const std::vector<BodyCut>& bodies) {
  const double rounding = workpiece.axis_spacing / 2.0;  // of faces at one level
  std::vector<double> begin(bodies.size(), std::numeric_limits<double>::infinity());
  for (const auto& [column, ends] : columns)
    if (const std::size_t body = column.first; body != every_body)
      begin[body] = std::min(begin[body], ends.top);
  std::vector<std::uint8_t> bare(bodies.size(), 1);
  for (std::size_t n = 0; n < bodies.size(); ++n)
    for (std::size_t above = 0; above < bodies.size(); ++above)
      if (begin[above] + rounding < begin[n] && workpiece.bodies[above].is_in_way &&
          !bodies[above].through)
        bare[n] = 0;
  return bare;
}

// The faces from which the water enters, and those below which depths are measured.
class TubeFaces {
 public:
  TubeFaces(const Workpiece& workpiece, TubeColumns columns, const std::vector<BodyCut>& bodies)
      : spacing_(workpiece.axis_spacing),
        columns_(std::move(columns)),
        bare_(find_bare(workpiece, columns_, bodies)),
        at_axis_(columns_of_all(columns_), spacing_, space_of(*workpiece.jet, spacing_),
                 std::max(workpiece.jet->width / 8.0, spacing_)) {}

  // Returns the distance from the axis within which solid is in the space of the jet, m.
  static double space_of(const JetAxis& jet, double spacing) {
    return in_way_reach(jet.width, spacing);
  }
  // Returns whether the water reaches an open particle without a path: nothing of the workpiece
  // lies above it, or what does is cut through.
  bool is_at_face(const TubePoint& point) const {
    if (point.is_void) return false;
    const std::size_t face = bare_[point.body] != 0 ? point.body : every_body;
    return tube_edge(point) <= top(point, face) + point.size / 2.0;
  }
  // Returns the depth of the face of a point of a path, m: that above it, or that at the axis where
  // the former is a step above the latter.
  double face_of(const TubePoint& point, const std::set<std::size_t>& opened) const {
    const auto& [crosswise, lengthwise] = point.offset;
    return at_axis_.depth_at({point.position[0] - crosswise, point.position[1] - lengthwise},
                             point.offset, face_above(point, opened));
  }

 private:
  // Returns the depth of the face above a point of a path, m: of a body below others that are not
  // cut through and that the path does not pass, its own.
  double face_above(const TubePoint& point, const std::set<std::size_t>& opened) const {
    if (bare_[point.body] != 0) return top(point, every_body);
    double face = top(point, point.body);
    for (const std::size_t body : opened)
      if (const auto found = columns_.find(tube_column(point, body, spacing_));
          found != columns_.end())
        face = std::min(face, found->second.top);
    return face;
  }
  double top(const TubePoint& point, std::size_t body) const {
    return columns_.at(tube_column(point, body, spacing_)).top;
  }

  double spacing_;
  TubeColumns columns_;
  std::vector<std::uint8_t> bare_;
  JetFace at_axis_;
};

std::vector<OpenPlace> places_of(const std::vector<TubePoint>& points) {
  std::vector<OpenPlace> places;
  for (const TubePoint& point : points) places.push_back({point.position, point.size});
  return places;
}

}  // namespace

double measure_cut_depth(const KerfView& view, const KerfAxes& axes,
                         const std::vector<BodyCut>& bodies) {
  const std::vector<TubePoint> points = points_in_tube(view, axes, bodies);
  std::vector<TubePoint> open;
  std::copy_if(points.begin(), points.end(), std::back_inserter(open),
               [](const TubePoint& point) { return point.is_open; });
  if (open.empty()) return 0.0;
  const double spacing = view.workpiece.axis_spacing;
  add_voids(points, spacing, open);
  TubeColumns columns = find_columns(points, spacing);
  const double most =
      greatest_length(points, columns, TubeFaces::space_of(axes.jet, spacing), spacing);
  const TubeFaces faces(view.workpiece, std::move(columns), bodies);
  OpenPaths paths(places_of(open));
  double deepest = 0.0;
  for (std::size_t n = 0; n < open.size(); ++n) {
    if (!faces.is_at_face(open[n])) continue;
    std::vector<std::size_t> path;
    std::set<std::size_t> opened;
    paths.follow(n, [&](std::size_t reached) {
      path.push_back(reached);
      if (!open[reached].is_void) opened.insert(open[reached].body);
    });
    for (const std::size_t reached : path)
      deepest = std::max(deepest, tube_edge(open[reached]) + open[reached].size -
                                      faces.face_of(open[reached], opened));
  }
  return most > 0.0 ? std::min(deepest, most) : deepest;
}

}  // namespace kerf
