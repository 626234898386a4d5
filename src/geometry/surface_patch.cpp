// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_patch.hpp"

#include <algorithm>
#include <cmath>

#include "core/regula_falsi.hpp"

namespace kerf {
namespace {

using Parameters = PatchedSurface::Parameters;
using Polygon = PatchedSurface::Polygon;

// m, how far the point is on the inner side of a face of the domain; negative beyond it.
double depth_behind(const Box& domain, std::size_t axis, bool upper, const Point& x) {
  return upper ? domain.maximum[axis] - x[axis] : x[axis] - domain.minimum[axis];
}

double twice_area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Parameters &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += a[0] * b[1] - b[0] * a[1];
  }
  return sum;
}

Parameters centroid(const Polygon& polygon) {
  const Parameters origin = polygon.front();  // near, so that little cancels
  Parameters moment{};
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Parameters a{polygon[i][0] - origin[0], polygon[i][1] - origin[1]};
    const Parameters b{polygon[i + 1][0] - origin[0], polygon[i + 1][1] - origin[1]};
    const double weight = a[0] * b[1] - b[0] * a[1];
    sum += weight;
    for (std::size_t k = 0; k < 2; ++k) moment[k] += weight * (a[k] + b[k]) / 3.0;
  }
  return {origin[0] + moment[0] / sum, origin[1] + moment[1] / sum};
}

bool is_plane(const Faces& faces, std::size_t axis, bool upper) {
  return upper ? faces.maximum[axis] : faces.minimum[axis];
}

}  // namespace

const Polygon PatchedSurface::square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
const Polygon PatchedSurface::triangle{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};

int PatchedSurface::pieces(double length) const {
  const double rounding = 1e-9;  // a length of n sizes is n patches
  return std::max(1, static_cast<int>(std::ceil(length / size_ - rounding)));
}

bool PatchedSurface::is_near_plane(const Point& middle) const {
  const double longest = 1.5 * size_;  // from the middle of a patch to its corners
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true})
      if (is_plane(symmetry_.planes, axis, upper) &&
          depth_behind(symmetry_.domain, axis, upper, middle) < longest)
        return true;
  return false;
}

bool PatchedSurface::lies_in_plane(const SurfacePoint& point) const {
  const double slack = 0.25 * size_, aligned = 0.99;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true})
      if (is_plane(symmetry_.planes, axis, upper) && std::abs(point.normal[axis]) > aligned &&
          depth_behind(symmetry_.domain, axis, upper, point.position) < slack)
        return true;
  return false;
}

// Edges that end in the plane to rounding are not cut.
Polygon PatchedSurface::cut(const Polygon& polygon, const Map& map, std::size_t axis,
                            bool upper) const {
  const double rounding = 1e-9 * size_;
  const auto depth = [&](const Parameters& at) {
    return depth_behind(symmetry_.domain, axis, upper, map(at[0], at[1]).position);
  };
  Polygon left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Parameters &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const bool a_left = depth(a) > -rounding, b_left = depth(b) > -rounding;
    if (a_left) left.push_back(a);
    if (a_left == b_left) continue;
    const Parameters &from = a_left ? a : b, &to = a_left ? b : a;
    const auto between = [&](double t) {
      return Parameters{from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])};
    };
    left.push_back(
        between(regula_falsi([&](double t) { return depth(between(t)); }, 1.0, rounding)));
  }
  return left;
}

void PatchedSurface::add_cut(double area, const SurfacePoint& middle, const Map& map,
                             const Polygon& parameters) {
  const double smallest = 1e-9;  // share of a patch
  Polygon left = parameters;
  for (std::size_t axis = 0; axis < 3 && !left.empty(); ++axis)
    for (const bool upper : {false, true})
      if (is_plane(symmetry_.planes, axis, upper)) left = cut(left, map, axis, upper);
  const double share = twice_area(left) / twice_area(parameters);
  if (!(share > smallest)) return;
  if (left == parameters) {
    if (!lies_in_plane(middle)) elements_.push_back({middle.position, middle.normal, area});
    return;
  }
  const Parameters at = centroid(left);
  const SurfacePoint point = map(at[0], at[1]);
  if (!lies_in_plane(point)) elements_.push_back({point.position, point.normal, share * area});
}

}  // namespace kerf
