// SPDX-License-Identifier: Apache-2.0
#include "analysis/solid_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

// A larger grid would take more memory than the run itself; the step becomes coarser instead.
constexpr double most_samples = 3e7;
constexpr double spline_reach = 2.0;  // spacings, of the spline

double cubic_spline(double x) {
  const double q = std::abs(x);
  if (q < 1.0) return 2.0 / 3.0 - q * q + q * q * q / 2.0;
  const double rest = std::max(0.0, spline_reach - q);
  return rest * rest * rest / 6.0;
}

// x^2 or x^3.
double to_dimension(double x, int dimension) {
  return dimension == 3 ? x * x * x : x * x;
}

// The weights that a particle adds to the samples of one axis, from sample `first` on.
struct Weights {
  std::size_t first = 0;
  std::vector<double> value;
};

void find_weights(const SampleGrid& grid, std::size_t axis, const SolidPoint& point,
                  Weights& weights) {
  weights.value.clear();
  if (axis == 1 && grid.dimension == 2) {
    weights.first = 0;
    weights.value.push_back(1.0);
    return;
  }
  const double centre = (point.position[axis] - grid.low[axis]) / grid.step;
  const double width = spline_reach * point.size / grid.step;
  const double last = std::min(static_cast<double>(grid.count[axis]) - 1.0, centre + width);
  const double first = std::max(0.0, std::ceil(centre - width));
  weights.first = static_cast<std::size_t>(first);
  for (double n = first; n <= last; n += 1.0)
    weights.value.push_back(cubic_spline((n - centre) * grid.step / point.size));
}

void add_column(float* column, double outer, const std::vector<double>& down) {
  for (std::size_t k = 0; k < down.size(); ++k) column[k] += static_cast<float>(outer * down[k]);
}

}  // namespace

SampleGrid make_grid(const std::vector<SolidPoint>& points, const std::array<double, 3>& low,
                     const std::array<double, 3>& high, double step, int dimension) {
  std::array<double, 3> least, most;
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(-std::numeric_limits<double>::infinity());
  for (const SolidPoint& point : points)
    for (std::size_t a = 0; a < 3; ++a) {
      const double margin = spline_reach * point.size;
      least[a] = std::min(least[a], std::max(low[a], point.position[a] - margin));
      most[a] = std::max(most[a], std::min(high[a], point.position[a] + margin));
    }
  SampleGrid grid;
  grid.dimension = dimension;
  for (std::size_t a = 0; a < 3; ++a)
    if (!(most[a] >= least[a])) return grid;
  double cells = 1.0;
  for (std::size_t a = 0; a < 3; ++a)
    if (a != 1 || dimension == 3) cells *= std::max(1.0, (most[a] - least[a]) / step);
  grid.step = step * std::max(1.0, std::pow(cells / most_samples, 1.0 / dimension));
  for (std::size_t a = 0; a < 3; ++a) {
    // One sample lies on the axis of the jet.
    const double first = std::floor(least[a] / grid.step), last = std::ceil(most[a] / grid.step);
    grid.low[a] = first * grid.step;
    grid.count[a] = static_cast<std::size_t>(last - first) + 1;
  }
  if (dimension == 2) {
    grid.low[1] = 0.0;
    grid.count[1] = 1;
  }
  return grid;
}

void SolidField::add(const std::vector<SolidPoint>& points) {
  if (share_.empty()) return;
  std::array<Weights, 3> weights;
  for (const SolidPoint& point : points) {
    for (std::size_t a = 0; a < 3; ++a) find_weights(grid_, a, point, weights[a]);
    const auto& [across, along, down] = weights;
    if (down.value.empty()) continue;
    const double whole = point.volume / to_dimension(point.size, grid_.dimension);
    for (std::size_t i = 0; i < across.value.size(); ++i)
      for (std::size_t j = 0; j < along.value.size(); ++j)
        add_column(&share_[grid_.index(across.first + i, along.first + j, down.first)],
                   whole * across.value[i] * along.value[j], down.value);
  }
}

float SolidField::share_at(const std::array<double, 3>& position) const {
  if (share_.empty()) return 0.0f;
  std::array<std::size_t, 3> nearest{};
  for (std::size_t a = 0; a < 3; ++a) {
    if (grid_.count[a] == 1) continue;
    const double sample = std::round((position[a] - grid_.low[a]) / grid_.step);
    if (sample < 0.0 || sample >= static_cast<double>(grid_.count[a])) return 0.0f;
    nearest[a] = static_cast<std::size_t>(sample);
  }
  return share_[grid_.index(nearest[0], nearest[1], nearest[2])];
}

float SolidField::share_with(const SolidPoint& point) const {
  const double own = point.volume * to_dimension(cubic_spline(0.0) / point.size, grid_.dimension);
  return share_at(point.position) + static_cast<float>(own);
}

}  // namespace kerf
