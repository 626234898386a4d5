// SPDX-License-Identifier: Apache-2.0
// GradedPairs holds what the SIMD pair kernel needs of the pairs of a nearly incompressible solid
// whose spacing jumps: per entry of the neighbour list the factor s_ij
// (solid/gradient_correction_levels.hpp), also for mirror images, and the ratio of the smoothing
// lengths. A pair keeps both, so they are found once for each list.
#pragma once

#include <array>
#include <vector>

#include "fluid/simd/packed_fluid.hpp"
#include "fluid/simd/packed_unlike.hpp"
#include "neighbours/neighbour_list.hpp"
#include "solid/pair_correction.hpp"

namespace kerf {

template <int D, class P>
class GradedPairs {
 public:
  using Real = typename P::Real;

  // Takes a new list, of particles in their current order, the first `count` of which have lists;
  // given `listed_anew`, of the particles marked there alone.
  void take(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
            const PairCorrection<D, P>& correction, const std::uint8_t* listed_anew) {
    if (correction.factor == nullptr) return;
    const Index all = count + view.ghosts.count;
    graded_.resize(all);
    ends_.resize(all);
    for_each_index(all, PackEnds{view, correction, ends_.data(), graded_.data()});
    begin_.resize(count + 1, begin_.empty() ? 0 : begin_.back());  // newcomers have no factors
    const Wanted wanted{list, ends_.data(), graded_.data()};
    const bool lacks_room =
        listed_anew == nullptr ||
        reduce_unordered(count, LacksRoom{wanted, begin_.data()}, false, Either{});
    if (lacks_room) make_room(wanted, count);
    for_each_index(count,
                   Fill{view, list, correction, ends_.data(), lacks_room ? nullptr : listed_anew,
                        graded_.data(), begin_.data(), correction_.data(), length_ratio_.data()});
  }

  // Gives the numbers of the pairs to the kernels of a fluid and of what is unlike it.
  void give(FluidKernelTask<D, Real>& task) const {
    if (graded_.empty()) return;
    task.graded = graded_.data();
    task.graded_begin = begin_.data();
    task.correction = correction_.data();
    task.length_ratio = length_ratio_.data();
  }
  void give(UnlikeKernelTask<D, Real>& task) const {
    if (graded_.empty()) return;
    task.graded = graded_.data();
    task.graded_begin = begin_.data();
    task.correction = correction_.data();
  }

  std::size_t bytes() const {
    return graded_.size() + ends_.size() * sizeof(End) + begin_.size() * sizeof(Index) +
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
    std::uint8_t* graded;

    KERF_FUNCTION void operator()(Index i) const {
      const bool has_factors = particles.has(i, flag::fitted) && !particles.fractured[i];
      ends[i] = {has_factors ? of_pair.solid_index_of_id[particles.id[i]] : no_bond,
                 particles.medium(i).smoothing_length};
      graded[i] = sums_over_levels(particles, i) ? 1 : 0;
    }
  };
  // How many pairs of a particle have factors: those with images, and of a graded one the others of
  // its class before them.
  struct Wanted {
    NeighbourView list;
    const End* ends;
    const std::uint8_t* graded;

    Index operator()(Index i) const {
      if (ends[i].solid == no_bond) return 0;
      return list.images[i] + (graded[i] != 0 ? list.same_fluid[i] : 0);
    }
  };
  struct LacksRoom {
    Wanted wanted;
    const Index* begin;
    bool operator()(Index i) const { return wanted(i) > begin[i + 1] - begin[i]; }
  };
  struct Fill {
    ParticleView<D, P> particles;
    NeighbourView list;
    PairCorrection<D, P> of_pair;
    const End* ends;
    const std::uint8_t* listed_anew;
    const std::uint8_t* graded;
    const Index* begin;
    Real *correction, *length_ratio;

    void operator()(Index i) const {
      const End own = ends[i];
      if (own.solid == no_bond || (listed_anew != nullptr && listed_anew[i] == 0)) return;
      thread_local FactorTable factors;
      factors.set(of_pair, own.solid);
      Index n = begin[i];
      for (Index k = list.begin[i]; graded[i] != 0 && k < list.begin[i] + list.same_fluid[i]; ++k) {
        const End other = ends[list.neighbour[k]];
        correction[n] = factors.of(other.solid, 0);
        length_ratio[n++] = other.length / own.length;
      }
      const auto& mirrors = particles.mirrors;
      for (Index k = list.end[i] - list.images[i]; k < list.end[i]; ++k) {
        const Index j = list.neighbour[k];
        correction[n++] = factors.of(ends[mirrors.particle(j)].solid, mirrors.code(j));
      }
      factors.reset(of_pair, own.solid);
    }
  };
  // The factors of the bonds of one particle, by the number of the other end and the code of its
  // image: one look each, where a search in the list of bonds would take seven. A hash table of the
  // bonds of the particle alone takes several times as long: its branches are hard to predict.
  class FactorTable {
   public:
    void set(const PairCorrection<D, P>& of_pair, Index own) {
      for_each_bond(of_pair, own, [&](Index other, MirrorCode code, Index bond) {
        auto& factors = factors_[number(code)];
        if (factors.size() <= other) factors.resize(other + other / 2 + 1, Real(1));
        factors[other] = of_pair.factor[bond];
      });
    }
    void reset(const PairCorrection<D, P>& of_pair, Index own) {
      for_each_bond(of_pair, own, [&](Index other, MirrorCode code, Index) {
        factors_[number(code)][other] = Real(1);
      });
    }
    Real of(Index other, MirrorCode code) const {
      const auto& factors = factors_[number(code)];
      return other < factors.size() ? factors[other] : Real(1);
    }

   private:
    template <class Visit>
    static void for_each_bond(const PairCorrection<D, P>& of_pair, Index own, const Visit& visit) {
      const auto& bonds = of_pair.bonds;
      for (Index k = bonds.first(own); k < bonds.last(own); ++k) {
        const Index end = bonds.end(own, k);
        visit(bonds.mirrors.particle(end), bonds.mirrors.code(end), k);
      }
    }
    static Index number(MirrorCode code) { return code >> MirrorPlanes<D>::shift; }

    // By the code; 1 between calls.
    std::array<std::vector<Real>, std::size_t(1) << (2 * D)> factors_;
  };

 private:
  // Gives each particle room for a list that grows.
  void make_room(const Wanted& wanted, Index count) {
    constexpr std::size_t beyond = 16;  // entries that a load may read past the end
    for (Index i = 0; i < count; ++i) {
      const Index now = wanted(i);
      begin_[i + 1] = begin_[i] + now + now / 8;
    }
    for (auto* numbers : {&correction_, &length_ratio_})
      numbers->resize(begin_[count] + beyond, Real(1));
  }

  std::vector<End> ends_;  // per particle, scratch
  std::vector<std::uint8_t>
      graded_;                // per particle: 1 where its neighbours may have other spacings
  std::vector<Index> begin_;  // of each particle, its numbers below
  // Per pair in the order of the list, those of the same fluid and then the images; lists that move
  // in memory leave them as they are.
  std::vector<Real> correction_, length_ratio_;
};

}  // namespace kerf
