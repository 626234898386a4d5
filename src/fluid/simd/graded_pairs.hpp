// SPDX-License-Identifier: Apache-2.0
// GradedPairs holds what the SIMD pair kernel needs of the pairs of a nearly incompressible solid
// whose spacing jumps: per entry of the neighbour list the factor s_ij
// (solid/gradient_correction_levels.hpp), also for mirror images, and the ratio of the smoothing
// lengths. A pair keeps both, so they are found once for each list.
#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "fluid/simd/packed_fluid.hpp"
#include "neighbours/neighbour_list.hpp"
#include "solid/pair_correction.hpp"

namespace kerf {

template <int D, class P>
class GradedPairs {
 public:
  using Real = typename P::Real;

  // Takes a new list, of `entries` entries, of particles in their current order; given
  // `listed_anew`, of the particles marked there alone.
  void take(const ParticleView<D, P>& view, Index count, const NeighbourView& list, Index entries,
            const PairCorrection<D, P>& correction, const std::uint8_t* listed_anew) {
    if (correction.factor == nullptr) return;
    constexpr std::size_t beyond = 16;  // entries that a load may read past the end
    graded_.resize(count);
    ends_.resize(count);
    for_each_index(count, PackEnds{view, correction, ends_.data()});
    if (correction_.size() < entries + beyond)
      for (auto* numbers : {&correction_, &length_ratio_})
        numbers->resize(entries + entries / 8 + beyond, Real(1));
    for_each_index(count, Fill{view, list, correction, ends_.data(), listed_anew, graded_.data(),
                               correction_.data(), length_ratio_.data()});
  }

  // The factors of pairs with images; null: 1.
  const Real* correction() const { return graded_.empty() ? nullptr : correction_.data(); }

  void give(FluidKernelTask<D, Real>& task) const {
    if (graded_.empty()) return;
    task.graded = graded_.data();
    task.correction = correction_.data();
    task.length_ratio = length_ratio_.data();
  }

  std::size_t bytes() const {
    return graded_.size() + ends_.size() * sizeof(End) +
           (correction_.size() + length_ratio_.size()) * sizeof(Real);
  }

 public:  // nvcc has no loop bodies that are private
  // What a pair needs of its ends, so that a neighbour is one load.
  struct End {
    Index solid;  // its number among those of solids; no_bond: it has no factors
    Real length;  // h, m
  };
  struct PackEnds {
    ParticleView<D, P> particles;
    PairCorrection<D, P> of_pair;
    End* ends;

    KERF_FUNCTION void operator()(Index i) const {
      const bool has_factors = particles.has(i, flag::fitted) && !particles.fractured[i];
      ends[i] = {has_factors ? of_pair.solid_index_of_id[particles.id[i]] : no_bond,
                 particles.medium(i).smoothing_length};
    }
  };
  struct Fill {
    ParticleView<D, P> particles;
    NeighbourView list;
    PairCorrection<D, P> of_pair;
    const End* ends;
    const std::uint8_t* listed_anew;
    std::uint8_t* graded;
    Real *correction, *length_ratio;

    void operator()(Index i) const {
      if (listed_anew != nullptr && listed_anew[i] == 0) return;
      const End own = ends[i];
      const auto& mirrors = particles.mirrors;
      graded[i] = sums_over_levels(particles, i) ? 1 : 0;
      if (graded[i] == 0 && list.images[i] == 0) return;
      thread_local FactorTable factors;
      factors.set(of_pair, own.solid);
      for (Index k = list.end[i] - list.images[i]; k < list.end[i]; ++k) {
        const Index j = list.neighbour[k];
        correction[k] = factors.of(ends[mirrors.particle(j)].solid | mirrors.code(j));
      }
      for (Index k = list.begin[i]; graded[i] != 0 && k < list.begin[i] + list.same_fluid[i]; ++k) {
        const End other = ends[list.neighbour[k]];
        correction[k] = factors.of(other.solid);
        length_ratio[k] = other.length / own.length;
      }
    }
  };
  // The factors of the bonds of one particle by their other ends, in a table of few kilobytes: a
  // search in the list of bonds would take seven looks.
  class FactorTable {
   public:
    void set(const PairCorrection<D, P>& of_pair, Index own) {
      const auto& bonds = of_pair.bonds;
      const Index first = own == no_bond ? 0 : bonds.first(own);
      const Index last = own == no_bond ? 0 : bonds.last(own);
      const int bits = std::bit_width(2 * (last - first) + 1);
      shift_ = 32 - bits;
      mask_ = (Index(1) << bits) - 1;
      if (entries_.size() <= mask_) entries_.resize(mask_ + 1);
      std::fill_n(entries_.begin(), mask_ + 1, Entry{});
      for (Index k = first; k < last; ++k) {
        const Index end = bonds.end(own, k);
        entries_[place(end)] = {end, of_pair.factor[k]};
      }
    }
    // `end`: its number among those of solids, with the code of its image.
    Real of(Index end) const { return entries_[place(end)].factor; }

   private:
    struct Entry {
      Index end = no_bond;  // none
      Real factor = Real(1);
    };
    // Where this end is, or would be. At least half of the entries are free.
    Index place(Index end) const {
      Index at = (end * 0x9E3779B1u) >> shift_;
      while (entries_[at].end != end && entries_[at].end != no_bond) at = (at + 1) & mask_;
      return at;
    }

    std::vector<Entry> entries_;
    Index mask_ = 0;
    int shift_ = 31;
  };

 private:
  std::vector<End> ends_;                        // per particle, scratch
  std::vector<std::uint8_t> graded_;             // per particle
  std::vector<Real> correction_, length_ratio_;  // per entry of the list
};

}  // namespace kerf
