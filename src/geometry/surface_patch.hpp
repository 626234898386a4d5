// SPDX-License-Identifier: Apache-2.0
// A surface is laid out in patches, each the image of a polygon of two parameters under a map that
// keeps ratios of areas. Symmetry planes cut patches in the parameters: the part that is left has
// its share of the area, and its middle.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "geometry/surface_elements.hpp"

namespace kerf {

struct SurfacePoint {
  Point position{};  // m
  Point normal{};    // unit vector, outward
};

class PatchedSurface {
 public:
  using Parameters = std::array<double, 2>;
  using Polygon = std::vector<Parameters>;
  using Map = std::function<SurfacePoint(double, double)>;

  static const Polygon square, triangle;  // from 0 to 1; half of the square

  // `size`: of elements, m.
  PatchedSurface(const SymmetryPlanes& symmetry, double size) : symmetry_(symmetry), size_(size) {}

  // Adds a patch of the area (m^2; 2D: m) around `middle`, or what the planes leave of it. `map`
  // takes parameters to the surface.
  template <class PatchMap>
  void add(double area, const SurfacePoint& middle, const PatchMap& map,
           const Polygon& parameters = square) {
    if (!is_near_plane(middle.position))
      elements_.push_back({middle.position, middle.normal, area});
    else
      add_cut(area, middle, map, parameters);
  }
  // The same for the square, whose middle has the parameters 1/2.
  template <class PatchMap>
  void add(double area, const PatchMap& map) {
    add(area, map(0.5, 0.5), map);
  }
  void add(const SurfaceElement& element) { elements_.push_back(element); }

  // Returns into how many patches a length (m) is divided.
  int pieces(double length) const;

  double size() const { return size_; }
  // A surface without elements, with the same planes.
  PatchedSurface empty() const { return {symmetry_, size_}; }
  const std::vector<SurfaceElement>& elements() const { return elements_; }

 private:
  // Whether a patch with this middle may reach a plane, or lies beyond one.
  bool is_near_plane(const Point& middle) const;
  // Whether the point is part of a face that lies in a plane.
  bool lies_in_plane(const SurfacePoint& point) const;
  Polygon cut(const Polygon& polygon, const Map& map, std::size_t axis, bool upper) const;
  void add_cut(double area, const SurfacePoint& middle, const Map& map, const Polygon& parameters);

  SymmetryPlanes symmetry_;
  double size_;
  std::vector<SurfaceElement> elements_;
};

}  // namespace kerf
