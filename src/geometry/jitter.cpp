// SPDX-License-Identifier: Apache-2.0
#include "geometry/jitter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "core/random.hpp"
#include "geometry/fill.hpp"
#include "geometry/shapes.hpp"
#include "kernels/wendland_c2.hpp"

namespace kerf {

namespace {

constexpr int relaxing_steps = 10;
constexpr double relaxing_share = 0.2;   // of h^2
constexpr double smoothing_ratio = 1.3;  // h over the spacing, independent of that of the run

// Returns whether the shape extends for a spacing in both directions along an axis.
bool is_inside_along(const Shape& shape, const Point& node, std::size_t axis, double spacing,
                     int dimension) {
  for (const double reach : {-1.0, -0.5, 0.5, 1.0}) {
    Point beside = node;
    beside[axis] += reach * spacing;
    if (!contains(shape, beside, dimension)) return false;
  }
  return true;
}

template <int D>
class Relaxation {
 public:
  using Position = Vector<D, double>;

  Relaxation(const Body& body, const std::vector<Point>& nodes)
      : smoothing_length_(smoothing_ratio * body.spacing),
        volume_(particle_volume(body, D)),
        farthest_(body.jitter * body.spacing) {
    for (const Point& node : nodes) {
      Position position, free;
      for (int a = 0; a < D; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        position[a] = node[axis];
        free[a] = is_inside_along(body.shape, node, axis, body.spacing, D) ? 1.0 : 0.0;
      }
      position_.push_back(position);
      free_.push_back(free);
    }
    node_ = position_;
    at_rest_ = concentration_gradients();
    for (std::size_t i = 0; i < position_.size(); ++i)
      for (int a = 0; a < D; ++a) {
        const std::uint64_t number = 3 * i + static_cast<std::uint64_t>(a);
        const double shift = 2.0 * random_number(body.seed, number) - 1.0;
        position_[i][a] += free_[i][a] * shift * farthest_;
      }
  }

  void step() {
    const std::vector<Position> now = concentration_gradients();
    const double share = relaxing_share * smoothing_length_ * smoothing_length_;
    for (std::size_t i = 0; i < position_.size(); ++i)
      for (int a = 0; a < D; ++a) {
        const double next = position_[i][a] - share * free_[i][a] * (now[i][a] - at_rest_[i][a]);
        position_[i][a] = std::clamp(next, node_[i][a] - farthest_, node_[i][a] + farthest_);
      }
  }

  const std::vector<Position>& positions() const { return position_; }

 private:
  using Cell = std::array<std::int64_t, D>;
  using Cells = std::map<Cell, std::vector<std::size_t>>;

  // Cells are as wide as the support of the kernel.
  Cell cell_of(const Position& x) const {
    Cell cell;
    const double reach = WendlandC2<D>::support * smoothing_length_;
    for (int a = 0; a < D; ++a)
      cell[static_cast<std::size_t>(a)] = static_cast<std::int64_t>(std::floor(x[a] / reach));
    return cell;
  }

  // sum_j V grad W_ij of every particle, 1/m.
  std::vector<Position> concentration_gradients() const {
    Cells cells;
    for (std::size_t i = 0; i < position_.size(); ++i) cells[cell_of(position_[i])].push_back(i);
    std::vector<Position> sums(position_.size(), Position::zero());
    for (const auto& [cell, own] : cells)
      for (int k = 0; k < (D == 2 ? 9 : 27); ++k) {
        Cell beside = cell;
        for (std::size_t a = 0, rest = static_cast<std::size_t>(k); a < D; ++a, rest /= 3)
          beside[a] += static_cast<std::int64_t>(rest % 3) - 1;
        const auto found = cells.find(beside);
        if (found == cells.end()) continue;
        for (const std::size_t i : own)
          sums[i] += concentration_gradient_of(found->second, position_[i]);
      }
    return sums;
  }
  Position concentration_gradient_of(const std::vector<std::size_t>& others,
                                     const Position& x) const {
    auto sum = Position::zero();
    for (const std::size_t j : others) {
      const Position apart = position_[j] - x;  // of itself: 0
      sum += (volume_ * WendlandC2<D>::slope_per_distance(norm(apart), smoothing_length_)) * apart;
    }
    return sum;
  }

  double smoothing_length_, volume_, farthest_;
  std::vector<Position> position_, node_, free_;  // free: 1 along axes on which it may move
  std::vector<Position> at_rest_;                 // concentration_gradients() on the lattice
};

template <int D>
void relaxed(const Body& body, std::vector<Point>& nodes) {
  Relaxation<D> relaxation(body, nodes);
  for (int n = 0; n < relaxing_steps; ++n) relaxation.step();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Point moved{};
    for (int a = 0; a < D; ++a) moved[static_cast<std::size_t>(a)] = relaxation.positions()[i][a];
    if (contains(body.shape, moved, D)) nodes[i] = moved;
  }
}

}  // namespace

void jitter(const Body& body, int dimension, std::vector<Point>& nodes) {
  if (body.jitter == 0.0 || nodes.empty()) return;
  if (dimension == 2)
    relaxed<2>(body, nodes);
  else
    relaxed<3>(body, nodes);
}

}  // namespace kerf
