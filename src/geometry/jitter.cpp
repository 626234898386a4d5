// SPDX-License-Identifier: Apache-2.0
#include "geometry/jitter.hpp"

#include <algorithm>
#include <cstdint>

#include "core/random.hpp"
#include "geometry/fill.hpp"
#include "geometry/kernel_gradients.hpp"
#include "geometry/point_vectors.hpp"
#include "geometry/shapes.hpp"

namespace kerf {

namespace {

constexpr int relaxing_steps = 10;

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
      : smoothing_length_(relaxing_smoothing_ratio * body.spacing),
        volume_(particle_volume(body, D)),
        farthest_(body.jitter * body.spacing) {
    for (const Point& node : nodes) {
      Position free;
      for (int a = 0; a < D; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        free[a] = is_inside_along(body.shape, node, axis, body.spacing, D) ? 1.0 : 0.0;
      }
      position_.push_back(vector_of<D>(node));
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
  std::vector<Position> concentration_gradients() const {
    return kernel_gradients<D>(position_, position_.size(), volume_, smoothing_length_);
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
    const Point moved = point_of<D>(relaxation.positions()[i]);
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
