// SPDX-License-Identifier: Apache-2.0
// BondsThroughSolid leaves out the bonds of a body that pass a void of its shape, such as a slit, a
// hole or a pore: the two sides of a void do not hold each other, however near they are. A void
// counts where a point of the bond is outside the piece of solid and so are all points about it, at
// the distance `void_radius` along the axes.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/nearest_face.hpp"
#include "geometry/point_vectors.hpp"
#include "kernels/wendland_c2.hpp"
#include "parallel/threads.hpp"
#include "solid/find_bonds.hpp"

namespace kerf {

template <int D>
class BondsThroughSolid {
 public:
  explicit BondsThroughSolid(const SolidLayout<D>& layout)
      : layout_(layout), is_near_(layout.reference.size()) {
    for (const auto& one : layout.media)
      longest_ = std::max(longest_, WendlandC2<D>::support * one.smoothing_length);
    for_each_on_threads(static_cast<Index>(is_near_.size()),
                        [&](Index i) { is_near_[i] = is_near_face(i); });
  }

  BondLists of(const BondLists& all) const {
    std::vector<std::uint8_t> is_kept(all.neighbour.size(), 1);
    for_each_on_threads(static_cast<Index>(is_near_.size()), [&](Index i) {
      if (is_near_[i] == 0) return;
      for (Index k = all.begin[i]; k < all.begin[i + 1]; ++k)
        is_kept[k] = passes_void(i, all.neighbour[k]) ? 0 : 1;
    });
    BondLists kept;
    kept.begin.push_back(0);
    for (Index i = 0; i < static_cast<Index>(is_near_.size()); ++i) {
      for (Index k = all.begin[i]; k < all.begin[i + 1]; ++k)
        if (is_kept[k] != 0) kept.neighbour.push_back(all.neighbour[k]);
      kept.begin.push_back(static_cast<Index>(kept.neighbour.size()));
    }
    return kept;
  }

 private:
  static constexpr double void_radius = 0.15, step = 0.15;  // spacings

  std::uint16_t medium(Index i) const { return layout_.medium_index[i]; }

  // Whether the longest bond of i could pass a face of its piece.
  std::uint8_t is_near_face(Index i) const {
    const SolidRegion& region = layout_.regions[medium(i)].region;
    if (!region) return 0;
    const Point point = point_of(layout_.reference[i]);
    const bool is_near = std::any_of(region->begin(), region->end(), [&](const Shape& shape) {
      return kerf::is_near_face(shape, point, longest_, D);
    });
    return is_near ? 1 : 0;
  }

  // Whether the bond of i with an entry of its list passes a void. Seen from both of its ends it is
  // the same line, from the first to the second, so that both agree.
  bool passes_void(Index i, Index entry) const {
    const Index j = layout_.mirrors.particle(entry);
    if (is_near_[j] == 0) return false;
    const BondRegion& of_i = layout_.regions[medium(i)];
    if (!of_i.region || of_i.body != layout_.regions[medium(j)].body) return false;
    const MirrorCode code = layout_.mirrors.code(entry);
    const auto from = layout_.mirrors.image_position(code, layout_.reference[std::min(i, j)]);
    const auto bond = layout_.reference[std::max(i, j)] - from;
    const double size =
        std::min(layout_.media[medium(i)].spacing, layout_.media[medium(j)].spacing);
    const int points = static_cast<int>(std::ceil(norm(bond) / (step * size)));
    for (int k = 0; k < points; ++k) {
      const auto x = from + ((k + 0.5) / points) * bond;
      if (is_void(*of_i.region, code, x, void_radius * size)) return true;
    }
    return false;
  }
  bool is_void(const std::vector<Shape>& region, MirrorCode code, const Vector<D, double>& x,
               double radius) const {
    if (is_solid(region, code, x)) return false;
    for (int side = 0; side < 2 * D; ++side) {
      auto beside = x;
      beside[side / 2] += side % 2 == 0 ? radius : -radius;
      if (is_solid(region, code, beside)) return false;
    }
    return true;
  }
  bool is_solid(const std::vector<Shape>& region, MirrorCode code,
                const Vector<D, double>& x) const {
    if (is_within(region, point_of(x), D)) return true;
    return code != 0 && is_within(region, point_of(layout_.mirrors.image_position(code, x)), D);
  }

  const SolidLayout<D>& layout_;
  double longest_ = 0.0;               // m, bond
  std::vector<std::uint8_t> is_near_;  // per particle
};

// Returns the bonds of the reference configuration.
template <int D>
BondLists bonds_of(const SolidLayout<D>& layout) {
  const BondLists all = BondFinder<D>(layout).find();
  return layout.regions.empty() ? all : BondsThroughSolid<D>(layout).of(all);
}

}  // namespace kerf
