// SPDX-License-Identifier: Apache-2.0
// Particles share one list of bonds when they are of one medium, all their bonds are within it, to
// no mirror image and without factors of their own (solid/gradient_correction_levels.hpp), and
// their other ends have the same differences of index and of position. The lists are shared once,
// on the host.
#pragma once

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <limits>
#include <unordered_map>
#include <vector>

#include "core/error.hpp"
#include "solid/bond_table.hpp"
#include "solid/find_bonds.hpp"
#include "solid/unlike_media.hpp"

namespace kerf {

// The lists of a BondTable. Shared lists come first, padded with zeros to full batches of the SIMD
// kernels.
struct StoredBonds {
  static constexpr Index block = 16;

  std::vector<Index> begin;
  std::vector<std::uint16_t> count;
  std::vector<Index> entry;
  std::vector<Index> found_at;  // of each entry, its index in the original lists; or no_bond
  std::vector<Index> owner;     // of each shared list, the first particle that has it
  std::vector<std::uint8_t>
      multi_material;  // per particle: 1: has bonds to other media, or to images
  std::vector<std::uint8_t> several_bodies;  // 1: to other bodies, or to images
  std::vector<std::uint8_t> unlike_media;    // bits of unlike_media.hpp
  Index shared = 0;                          // entries of shared lists

  // Reorders values, one per bond in the order of the search, into the order of storage. Returns an
  // empty array for an empty one.
  template <class Real>
  std::vector<Real> in_order(const std::vector<double>& found) const {
    std::vector<Real> stored;
    if (found.empty()) return stored;
    for (const Index k : found_at)
      stored.push_back(k == no_bond ? Real(1) : static_cast<Real>(found[k]));
    return stored;
  }
};

template <int D>
class ListSharing {
 public:
  ListSharing(const SolidLayout<D>& layout, const BondLists& lists,
              const std::vector<std::uint8_t>& fitted)
      : layout_(layout),
        lists_(lists),
        fitted_(fitted),
        n_(static_cast<Index>(layout.reference.size())) {
    double largest = 0.0;
    for (const auto& x : layout.reference) largest = std::max(largest, norm(x));
    rounding_ = 8.0 * std::numeric_limits<double>::epsilon() * largest;
  }

  StoredBonds store() {
    StoredBonds stored;
    for (Index i = 0; i < n_; ++i) {
      stored.multi_material.push_back(leaves(i, [&](Index j) { return layout_.medium_index[j]; }));
      stored.several_bodies.push_back(leaves(i, [&](Index j) { return body(j); }));
      stored.unlike_media.push_back(unlike_media_of(i));
    }
    find_equal_lists(stored.multi_material);
    stored.begin.resize(n_);
    for (Index i = 0; i < n_; ++i) {
      require(length(i) <= std::numeric_limits<std::uint16_t>::max(),
              "a particle of a solid has 65535 bonds at most");
      stored.count.push_back(static_cast<std::uint16_t>(length(i)));
    }
    for (Index i = 0; i < n_; ++i)
      if (is_shared(i) && model_[i] == i) append(i, stored);
    stored.shared = static_cast<Index>(stored.entry.size());
    for (Index i = 0; i < n_; ++i) {
      if (is_shared(i))
        stored.begin[i] = stored.begin[model_[i]];
      else
        append(i, stored);
    }
    return stored;
  }

 private:
  static constexpr Index least_users = 8;

  const Medium<double>& medium(Index i) const { return layout_.media[layout_.medium_index[i]]; }
  std::uint8_t unlike_media_of(Index i) const {
    std::uint8_t bits = 0;
    for (Index k = lists_.begin[i]; k < lists_.begin[i + 1]; ++k) {
      const Index j = layout_.mirrors.particle(lists_.neighbour[k]);
      if (layout_.medium_index[i] == layout_.medium_index[j]) continue;
      if (have_unlike_waves(medium(i), medium(j))) bits |= unlike_media::waves;
      if (body(i) != body(j) || have_unlike_limits(medium(i), medium(j)))
        bits |= unlike_media::limits;
    }
    return bits;
  }

  Index length(Index i) const { return lists_.begin[i + 1] - lists_.begin[i]; }
  bool is_shared(Index i) const { return users_[model_[i]] >= least_users; }

  void append(Index i, StoredBonds& stored) const {
    stored.begin[i] = static_cast<Index>(stored.entry.size());
    if (is_shared(i)) stored.owner.push_back(i);
    for (Index k = lists_.begin[i]; k < lists_.begin[i + 1]; ++k) {
      const Index end = lists_.neighbour[k];
      require(layout_.mirrors.faces == 0 || layout_.mirrors.code(end) != 0 ||
                  std::max(i, end) - std::min(i, end) < BondEntry<D>::most_apart,
              "a solid beside planes of symmetry has too many particles");
      stored.entry.push_back(BondEntry<D>::pack(i, end, layout_.mirrors));
      stored.found_at.push_back(k);
    }
    while (is_shared(i) && stored.entry.size() % StoredBonds::block != 0) {
      stored.entry.push_back(0);
      stored.found_at.push_back(no_bond);
    }
  }

  // Finds for each particle the first particle whose list it can share, and the number of particles
  // that share it.
  void find_equal_lists(const std::vector<std::uint8_t>& multi_material) {
    model_.resize(n_);
    users_.assign(n_, 0);
    std::unordered_map<std::size_t, std::vector<Index>> models;  // by hash
    Index last = no_bond;
    for (Index i = 0; i < n_; ++i) {
      model_[i] = i;
      const bool has_factors = !fitted_.empty() && fitted_[i] != 0;
      if (length(i) == 0 || multi_material[i] != 0 || has_factors) continue;
      if (last == no_bond || !have_equal_lists(i, last)) {
        auto& candidates = models[hash(i)];
        const auto found = std::find_if(candidates.begin(), candidates.end(),
                                        [&](Index j) { return have_equal_lists(i, j); });
        last = found == candidates.end() ? i : *found;
        if (last == i) candidates.push_back(i);
      }
      model_[i] = last;
      ++users_[last];
    }
  }
  // The body of which its medium is a level; without levels its medium.
  std::uint16_t body(Index i) const {
    const std::uint16_t medium = layout_.medium_index[i];
    return layout_.body.empty() ? medium : layout_.body[medium];
  }
  // Whether a bond of i leads to a mirror image, or out of the group that `group` names.
  template <class Group>
  bool leaves(Index i, const Group& group) const {
    for (Index k = lists_.begin[i]; k < lists_.begin[i + 1]; ++k) {
      const Index end = lists_.neighbour[k];
      if (layout_.mirrors.code(end) != 0 || group(end) != group(i)) return true;
    }
    return false;
  }
  std::size_t hash(Index i) const {
    std::size_t seed = layout_.medium_index[i];
    for (Index k = lists_.begin[i]; k < lists_.begin[i + 1]; ++k)
      boost::hash_combine(seed, lists_.neighbour[k] - i);
    return seed;
  }
  bool have_equal_lists(Index i, Index j) const {
    if (length(i) != length(j) || layout_.medium_index[i] != layout_.medium_index[j]) return false;
    const auto& x = layout_.reference;
    for (Index a = lists_.begin[i], b = lists_.begin[j]; a < lists_.begin[i + 1]; ++a, ++b) {
      const Index end = lists_.neighbour[a], other = lists_.neighbour[b];
      if (end - i != other - j) return false;
      const auto apart = (x[end] - x[i]) - (x[other] - x[j]);
      for (int c = 0; c < D; ++c)
        if (std::abs(apart[c]) > rounding_) return false;
    }
    return true;
  }

  const SolidLayout<D>& layout_;
  const BondLists& lists_;
  const std::vector<std::uint8_t>& fitted_;  // per particle: 1 where a bond may have a factor
  Index n_;
  double rounding_ = 0.0;  // m, of differences of positions
  std::vector<Index> model_, users_;
};

}  // namespace kerf
