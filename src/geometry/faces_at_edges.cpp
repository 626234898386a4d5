// SPDX-License-Identifier: Apache-2.0
#include "geometry/faces_at_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/point_vectors.hpp"

namespace kerf {

namespace {

constexpr double probe_step = 1e-3;  // spacings
constexpr double much_farther = 2.0;

// The way of unit length along one of the faces away from all others.
Point way_along(const std::vector<NearestFace>& faces, std::size_t which) {
  const Point& normal = faces[which].normal;
  Point way{};
  for (const NearestFace& beyond : faces)
    way = sum(sum(way, -1.0, beyond.normal), dot(beyond.normal, normal), normal);
  return sum({}, 1.0 / std::sqrt(dot(way, way)), way);
}

// What a particle as far from one face as from the other has of both.
NearestFace between(const NearestFace& face, const Point& other) {
  const Point mean = sum(sum({}, 0.5, face.normal), 0.5, other);
  return {mean, face.depth, sum(sum({}, 0.5, face.normal), -0.5, other)};
}

}  // namespace

// Adds the face nearest to a probe beside the point, if it is another one and as far from the
// point.
void FacesAtEdges::add_tied(const Point& point, const Point& probe,
                            std::vector<NearestFace>& faces) const {
  const auto other = region_.nearest(probe, dimension_);
  if (!other) return;
  const bool is_known = std::any_of(faces.begin(), faces.end(), [&](const NearestFace& face) {
    return dot(face.normal, other->normal) > corner_alignment;
  });
  const double depth = other->depth + dot(sum(probe, -1.0, point), other->normal);
  if (is_known || std::abs(depth - faces.front().depth) > 1e-2 * spacing_) return;
  faces.push_back({other->normal, faces.front().depth});
}

// Below the point the others of the faces that are equally far are nearer; in a plane they may be
// curves of which layers are traced, and are sought to both sides.
std::vector<NearestFace> FacesAtEdges::equally_far(const Point& point) const {
  std::vector<NearestFace> faces;
  const auto face = region_.nearest(point, dimension_);
  if (!face) return faces;
  faces.push_back(*face);
  const double step = probe_step * spacing_;
  if (dimension_ == 2) {
    const Point aside{-face->normal[1], face->normal[0], 0.0};
    for (const double side : {-step, step})
      if (faces.size() == 1) add_tied(point, sum(point, side, aside), faces);
    return faces;
  }
  add_tied(point, sum(point, -step, face->normal), faces);
  if (faces.size() == 2)
    add_tied(point, sum(sum(point, -step, face->normal), -step, faces.back().normal), faces);
  return faces;
}

// Returns how far the layer goes along one of the faces, away from the edge at which the others
// begin: powers of two of the spacing, m.
double FacesAtEdges::length_from_edge(const Point& edge, const std::vector<NearestFace>& faces,
                                      std::size_t which) const {
  const NearestFace& face = faces[which];
  const Point way = way_along(faces, which);
  double length = spacing_;
  for (; length < 1e3 * spacing_; length *= 2.0) {
    const auto there = region_.nearest(sum(edge, length, way), dimension_);
    if (!there || std::abs(there->depth - face.depth) > 0.1 * spacing_) break;
    if (dot(there->normal, face.normal) < corner_alignment) break;
  }
  return length;
}

std::optional<NearestFace> FacesAtEdges::face_of(const Point& point) const {
  const auto faces = equally_far(point);
  if (faces.empty()) return {};
  if (faces.size() == 1) return faces.front();
  std::vector<double> length;
  for (std::size_t k = 0; k < faces.size(); ++k)
    length.push_back(length_from_edge(point, faces, k));
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return length[a] > length[b]; });
  const auto goes_much_farther = [&](std::size_t k) {
    return length[order[k]] > much_farther * length[order[k + 1]];
  };
  if (goes_much_farther(0)) return faces[order[0]];
  if (faces.size() == 3 && !goes_much_farther(1)) return {};
  return between(faces[order[0]], faces[order[1]].normal);
}

}  // namespace kerf
