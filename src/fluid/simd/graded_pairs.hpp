// SPDX-License-Identifier: Apache-2.0
// GradedPairs holds what the SIMD pair kernel needs of the pairs of a nearly incompressible solid
// whose spacing jumps: per entry of the neighbour list the factor s_ij
// (solid/gradient_correction_levels.hpp) and the ratio of the smoothing lengths. A pair keeps both,
// so they are found once for each list.
#pragma once

#include <vector>

#include "fluid/simd/packed_fluid.hpp"
#include "neighbours/neighbour_list.hpp"
#include "solid/pair_correction.hpp"

namespace kerf {

template <int D, class P>
class GradedPairs {
 public:
  using Real = typename P::Real;

  // Takes the list of `entries` entries, of particles in their current order.
  void take(const ParticleView<D, P>& view, Index count, const NeighbourView& list, Index entries,
            const PairCorrection<D, P>& correction) {
    if (correction.factor == nullptr) return;
    constexpr std::size_t beyond = 16;  // entries that a load may read past the end
    graded_.resize(count);
    ends_.resize(count);
    for_each_index(count, PackEnds{view, correction, ends_.data()});
    if (correction_.size() < entries + beyond)
      for (auto* numbers : {&correction_, &length_ratio_})
        numbers->resize(entries + entries / 8 + beyond, Real(1));
    for_each_index(count, Fill{view, list, correction, ends_.data(), graded_.data(),
                               correction_.data(), length_ratio_.data()});
  }

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
      ends[i] = {
          particles.has(i, flag::fitted) ? of_pair.solid_index_of_id[particles.id[i]] : no_bond,
          particles.medium(i).smoothing_length};
    }
  };
  struct Fill {
    ParticleView<D, P> particles;
    NeighbourView list;
    PairCorrection<D, P> of_pair;
    const End* ends;
    std::uint8_t* graded;
    Real *correction, *length_ratio;

    KERF_FUNCTION void operator()(Index i) const {
      graded[i] = sums_over_levels(particles, i) ? 1 : 0;
      if (graded[i] == 0) return;
      const End own = ends[i];
      for (Index k = list.begin[i]; k < list.begin[i] + list.same_fluid[i]; ++k) {
        const End other = ends[list.neighbour[k]];
        correction[k] = of_pair.between(own.solid, other.solid);
        length_ratio[k] = other.length / own.length;
      }
    }
  };

 private:
  std::vector<End> ends_;                        // per particle, scratch
  std::vector<std::uint8_t> graded_;             // per particle
  std::vector<Real> correction_, length_ratio_;  // per entry of the list
};

}  // namespace kerf
