// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "geometry/faces_at_edges.hpp"
#include "geometry/level_curve.hpp"
#include "geometry/point_vectors.hpp"
#include "model/body.hpp"

namespace kerf {

namespace {

constexpr double slack = 1e-6;               // of a spacing
constexpr double tracing_step = 1.0 / 16.0;  // of a spacing

// Points in the cells of a square grid, for the question whether one is near.
class NearbyPoints {
 public:
  explicit NearbyPoints(double reach) : reach_(reach) {}
  void add(const Point& point) { cells_[cell_of(point)].push_back(point); }
  bool has_one_near(const Point& point) const {
    const Cell middle = cell_of(point);
    const auto is_near = [&](const Point& other) { return plane_distance(other, point) < reach_; };
    for (std::int64_t k = 0; k < 9; ++k) {
      const auto found = cells_.find({middle[0] + k % 3 - 1, middle[1] + k / 3 - 1});
      if (found == cells_.end()) continue;
      if (std::any_of(found->second.begin(), found->second.end(), is_near)) return true;
    }
    return false;
  }

 private:
  using Cell = std::array<std::int64_t, 2>;
  Cell cell_of(const Point& point) const {
    return {static_cast<std::int64_t>(std::floor(point[0] / reach_)),
            static_cast<std::int64_t>(std::floor(point[1] / reach_))};
  }
  double reach_;
  std::map<Cell, std::vector<Point>> cells_;
};

Point moved_aside(const Point& point, const NearestFace& face, double way) {
  return {point[0] - way * face.normal[1], point[1] + way * face.normal[0], 0.0};
}

// The surface of a body as deep as whole layers of its lattice.
CoveredShape region_of(const SurfaceLayers& layers) {
  const double spacing = layers.body.spacing;
  return {layers.body.shape, layers.others, std::ceil(layers.depth / spacing - slack) * spacing};
}

class PlaneLayers {
 public:
  PlaneLayers(const CoveredShape& region, double spacing, const std::vector<Point>& nodes)
      : nodes_(nodes), spacing_(spacing), region_(region) {
    for (const Point& node : nodes) faces_.push_back(region_.nearest(node, 2));
  }

  // Returns whether every node near the surface is at the depth of a layer, but for those behind a
  // corner that faces outward.
  bool are_laid() const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (faces_[i] && !is_at_layer(*faces_[i]) && !is_behind_corner(nodes_[i], *faces_[i]))
        return false;
    return true;
  }

  std::vector<Point> lay() const {
    std::vector<Point> points;
    NearbyPoints laid(0.6 * spacing_);
    const int count = static_cast<int>(std::lround(region_.reach / spacing_));
    for (int layer = 0; layer < count; ++layer) {
      std::vector<Point> of_layer;
      NearbyPoints same(0.1 * spacing_);  // a curve may pass the middle of a wall both ways
      for (const Point& point : points_of_layer(layer)) {
        if (laid.has_one_near(point) || same.has_one_near(point)) continue;
        same.add(point);
        of_layer.push_back(point);
      }
      for (const Point& point : of_layer) {
        laid.add(point);
        points.push_back(point);
      }
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!faces_[i] && !laid.has_one_near(nodes_[i])) points.push_back(nodes_[i]);
    return points;
  }

 private:
  // The nearest point of the surface stays the same as the point moves along the face.
  bool is_behind_corner(const Point& node, const NearestFace& face) const {
    const double aside = 0.1 * spacing_;
    for (const double side : {-aside, aside}) {
      const Point beside = moved_aside(node, face, side);
      const auto there = region_.nearest(beside, 2);
      if (!there) return false;
      const Point foot = sum(node, face.depth, face.normal);
      const Point other = sum(beside, there->depth, there->normal);
      if (plane_distance(foot, other) > 0.5 * aside) return false;
    }
    return true;
  }
  bool is_at_layer(const NearestFace& face) const {
    return std::abs(face.depth - depth_of(layer_of(face))) < slack * spacing_;
  }
  int layer_of(const NearestFace& face) const {
    return static_cast<int>(std::floor(face.depth / spacing_ + slack));
  }
  double depth_of(int layer) const { return (layer + 0.5) * spacing_; }

  // Every node in the layer leads to a level curve.
  std::vector<Point> points_of_layer(int layer) const {
    const double step = tracing_step * spacing_;
    std::vector<Point> points;
    NearbyPoints traced(1.5 * step);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!faces_[i] || layer_of(*faces_[i]) != layer) continue;
      const Point start = sum(nodes_[i], faces_[i]->depth - depth_of(layer), faces_[i]->normal);
      const auto face = region_.nearest(start, 2);
      if (!face || std::abs(face->depth - depth_of(layer)) > 1e-3 * step) continue;
      if (traced.has_one_near(start)) continue;
      const LevelCurve curve = trace_level_curve(region_, depth_of(layer), start, step);
      for (const Point& point : curve.points) traced.add(point);
      for (const Point& point : spread_on_curve(curve, spacing_)) points.push_back(point);
    }
    return points;
  }

  const std::vector<Point>& nodes_;
  double spacing_;
  const CoveredShape& region_;
  std::vector<std::optional<NearestFace>> faces_;  // of the nodes
};

}  // namespace

std::vector<std::optional<NearestFace>> nearest_faces(const SurfaceLayers& layers, int dimension,
                                                      const std::vector<Point>& points) {
  const CoveredShape region = region_of(layers);
  const FacesAtEdges faces_at_edges(region, layers.body.spacing, dimension);
  std::vector<std::optional<NearestFace>> faces;
  for (const Point& point : points) faces.push_back(faces_at_edges.face_of(point));
  return faces;
}

std::vector<std::optional<NearestFace>> lay_along_surface(const SurfaceLayers& layers,
                                                          int dimension,
                                                          std::vector<Point>& points) {
  if (dimension == 2 && layers.body.grading.levels == 0) {
    const CoveredShape region = region_of(layers);
    const PlaneLayers plane(region, layers.body.spacing, points);
    if (!plane.are_laid()) points = plane.lay();
  }
  return nearest_faces(layers, dimension, points);
}

}  // namespace kerf
