// SPDX-License-Identifier: Apache-2.0
#include "geometry/level_curve.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point_vectors.hpp"
#include "geometry/shapes.hpp"

namespace kerf {

namespace {

constexpr std::size_t most_points = 10'000'000;
constexpr double same_place = 1e-3;  // of a step

// Goes along a level curve, the surface on its right (`side` 1) or on its left (-1).
class Tracer {
 public:
  Tracer(const CoveredShape& region, double depth, double step, double side)
      : region_(region), depth_(depth), step_(step), side_(side) {}

  // Follows the curve from `start`, which is not part of the chain. Returns whether it closes.
  bool follow(const Point& start, LevelCurve& chain) {
    Point point = start;
    auto face = region_.nearest(point, 2);
    const Point first = face ? face->normal : Point{};
    double way = 0.0;
    while (face && chain.points.size() < most_points) {
      const Point direction = along(*face);
      Point next = sum(point, step_, direction);
      auto ahead = contains(region_.shape, next, 2) ? face_ahead(next, *face) : std::nullopt;
      if (!ahead) return false;
      bool is_corner = false;
      if (dot(ahead->normal, face->normal) < corner_alignment) {
        const double slope = dot(ahead->normal, direction);
        if (!(slope > 0.0)) return false;  // the surface ends
        const double more = (ahead->depth - depth_) / slope;
        if (std::abs(more) > 2.0 * step_) return false;
        next = sum(next, more, direction);
        if (turns_back(next, chain)) return false;
        ahead->depth = depth_;
        is_corner = true;
      } else {
        next = sum(next, ahead->depth - depth_, ahead->normal);
        ahead = face_ahead(next, *ahead);
        if (!ahead || std::abs(ahead->depth - depth_) > 0.2 * step_) return false;
      }
      way += plane_distance(point, next);
      const bool is_beside_start = way > 4.0 * step_ && plane_distance(next, start) < 0.75 * step_;
      if (is_beside_start && (is_corner || dot(ahead->normal, first) > corner_alignment)) {
        const bool starts_at_corner = !chain.corners.empty() && chain.corners.front() <= 1;
        if (is_corner && !starts_at_corner) {
          chain.corners.insert(chain.corners.begin(), 0);
          chain.points.front() = next;
        }
        return true;
      }
      if (is_corner) chain.corners.push_back(chain.points.size());
      chain.points.push_back(next);
      point = next;
      face = ahead;
    }
    return false;
  }

 private:
  Point along(const NearestFace& face) const {
    return {-side_ * face.normal[1], side_ * face.normal[0], 0.0};
  }
  // Returns the nearest face; at a place as far from the one followed but for rounding, as at a
  // corner and in the middle of a wall, that one.
  std::optional<NearestFace> face_ahead(const Point& point, const NearestFace& followed) const {
    auto face = region_.nearest(point, 2);
    if (!face || std::abs(face->depth - depth_) > same_place * step_) return face;
    const double alignment = dot(face->normal, followed.normal);
    if (alignment > corner_alignment) return face;
    return NearestFace{followed.normal, alignment < 0.0 ? 2.0 * depth_ - face->depth : depth_};
  }
  // The end of a wall, in its middle, is two corners at one place: there the curve ends.
  bool turns_back(const Point& corner, const LevelCurve& chain) const {
    return !chain.corners.empty() && chain.corners.back() + 1 == chain.points.size() &&
           plane_distance(corner, chain.points.back()) < same_place * step_;
  }

  const CoveredShape& region_;
  double depth_, step_, side_;
};

// Appends the points at these shares of the length of the chain between two of its points.
void spread(const std::vector<Point>& chain, std::size_t first, std::size_t last,
            const std::vector<double>& shares, std::vector<Point>& points) {
  std::vector<double> length{0.0};
  for (std::size_t k = first; k < last; ++k)
    length.push_back(length.back() + plane_distance(chain[k], chain[k + 1]));
  for (const double share : shares) {
    const double at = share * length.back();
    const auto above = std::upper_bound(length.begin(), length.end(), at);
    const auto k = std::clamp<std::ptrdiff_t>(above - length.begin(), 1,
                                              static_cast<std::ptrdiff_t>(length.size()) - 1);
    const double low = length[static_cast<std::size_t>(k - 1)];
    const double high = length[static_cast<std::size_t>(k)];
    const Point& a = chain[first + static_cast<std::size_t>(k) - 1];
    const Point& b = chain[first + static_cast<std::size_t>(k)];
    const double part = high > low ? (at - low) / (high - low) : 0.0;
    points.push_back({a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), 0.0});
  }
}

double chain_length(const std::vector<Point>& chain, std::size_t first, std::size_t last) {
  double length = 0.0;
  for (std::size_t k = first; k < last; ++k) length += plane_distance(chain[k], chain[k + 1]);
  return length;
}

// The shares of a piece's length at which its points lie. Its first and its last point belong to it
// (`from`, `to`) or are half a distance away from the ends.
std::vector<double> shares_of(double length, double spacing, bool from, bool to) {
  const double ends = 0.5 * (from ? 0.0 : 1.0) + 0.5 * (to ? 0.0 : 1.0);
  const double gaps = std::max(std::round(length / spacing - ends), 0.0);
  const double count = gaps + ends;
  std::vector<double> shares;
  if (count == 0.0) return {0.0};
  for (double k = 0.0; k < gaps + 0.5; k += 1.0) shares.push_back((k + (from ? 0.0 : 0.5)) / count);
  return shares;
}

}  // namespace

std::optional<NearestFace> CoveredShape::nearest(const Point& point, int dimension) const {
  return nearest_face(shape, others, point, reach, dimension);
}

LevelCurve trace_level_curve(const CoveredShape& region, double depth, const Point& start,
                             double step) {
  LevelCurve forward;
  forward.points.push_back(start);
  forward.is_closed = Tracer(region, depth, step, 1.0).follow(start, forward);
  if (forward.is_closed) return forward;
  LevelCurve curve;
  Tracer(region, depth, step, -1.0).follow(start, curve);
  std::reverse(curve.points.begin(), curve.points.end());
  const std::size_t before = curve.points.size();
  for (std::size_t& corner : curve.corners) corner = before - 1 - corner;
  std::reverse(curve.corners.begin(), curve.corners.end());
  for (const std::size_t corner : forward.corners) curve.corners.push_back(before + corner);
  curve.points.insert(curve.points.end(), forward.points.begin(), forward.points.end());
  return curve;
}

std::vector<Point> spread_on_curve(const LevelCurve& curve, double spacing) {
  std::vector<Point> chain = curve.points, points;
  std::vector<std::size_t> ends = curve.corners;
  if (curve.is_closed) {
    const std::size_t first = ends.empty() ? 0 : ends.front();
    std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(first), chain.end());
    chain.push_back(chain.front());
    for (std::size_t& corner : ends) corner -= first;
    if (ends.empty()) ends.push_back(0);
    ends.push_back(chain.size() - 1);
  } else {
    ends.insert(ends.begin(), 0);
    ends.push_back(chain.size() - 1);
  }
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const bool from = curve.is_closed || k > 0, to = curve.is_closed || k + 2 < ends.size();
    const double length = chain_length(chain, ends[k], ends[k + 1]);
    auto shares = shares_of(length, spacing, from, to);
    const bool is_followed = k + 2 >= ends.size() || ends[k + 1] < ends[k + 2];
    if (to && is_followed && shares.size() > 1) shares.pop_back();  // the first of the next piece
    if (ends[k] < ends[k + 1]) spread(chain, ends[k], ends[k + 1], shares, points);
  }
  return points;
}

}  // namespace kerf
