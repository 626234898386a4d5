// SPDX-License-Identifier: Apache-2.0
// This file turns particles of a solid into a field on a grid of samples: the share of space that
// the solid fills.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace kerf {

// The samples of a box, in local coordinates of a kerf (KerfAxes). Those of a column along the jet
// are contiguous. In 2D there is one sample along the kerf.
struct SampleGrid {
  std::array<double, 3> low{};  // m, position of the first sample
  std::array<std::size_t, 3> count{};
  double step = 0.0;  // m
  int dimension = 2;

  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    return (i * count[1] + j) * count[2] + k;
  }
  std::size_t size() const { return count[0] * count[1] * count[2]; }
  double at(std::size_t axis, std::size_t n) const {
    return low[axis] + static_cast<double>(n) * step;
  }
};

struct SolidPoint {
  std::array<double, 3> position{};  // m, local
  double volume = 0.0;               // m^3 (2D: m^2)
  double size = 0.0;                 // m, spacing
};

// Returns the smallest grid of that step around the points, with margins for the reach of each, and
// within [low, high].
SampleGrid make_grid(const std::vector<SolidPoint>& points, const std::array<double, 3>& low,
                     const std::array<double, 3>& high, double step, int dimension);

// The sum over the points of volume times a cubic B-spline of each coordinate with a reach of two
// spacings: 1 inside a body and 1/2 at its face, on any lattice; at most 0.45 at a single particle
// and at least 0.55 at a single vacancy. The level of 1/2 thus is the face of a body and does not
// respond to single particles.
class SolidField {
 public:
  explicit SolidField(const SampleGrid& grid) : grid_(grid), share_(grid.size(), 0.0f) {}

  void add(const std::vector<SolidPoint>& points);
  // The share at the nearest sample; 0 outside the grid.
  float share_at(const std::array<double, 3>& position) const;
  // The share at a particle that was not added, with its own contribution.
  float share_with(const SolidPoint& point) const;
  const std::vector<float>& share() const { return share_; }

 private:
  SampleGrid grid_;
  std::vector<float> share_;
};

}  // namespace kerf
