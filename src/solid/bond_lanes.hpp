// SPDX-License-Identifier: Apache-2.0
// The sums over bonds by way of lanes/, for all particles whose bonds are within one medium and to
// no mirror image: packs what the ends of bonds ask of one another and walks over the bonds several
// at a time. The same formulas as in deform.hpp and bond_force.hpp, which do the others, and on a
// GPU all.
#pragma once

#include <algorithm>
#include <vector>

#include "lanes/walk_in_blocks.hpp"
#include "lanes/walks.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

template <int D, class P>
class BondLanes {
 public:
  using Real = typename P::Real;

  void set_up(const std::vector<SolidMedium<double>>& media, const SolidView<D, P>& solid) {
    if constexpr (!lanes_exist) return;
    walks_ = walks().template get<D, Real>();
    double longest = 0.0;  // m, of bonds
    for (const auto& medium : media) {
      laws_.push_back(law_of(medium));
      longest = std::max(longest, 2.0 * medium.smoothing_length);
    }
    unit_ = PlaceUnit<Real>::of_spacing(longest / 16.0);  // differences up to eight bonds
    ends_.resize(solid.count);
    gradients_.resize(solid.count);
    pushes_.resize(solid.count);
    for_each_index(solid.count, PackReferences{solid, unit_, ends_.data()});
  }

  // At the displacements in force; null where others are to do it all.
  const BondGradient<D, Real>* gather(const SolidView<D, P>& solid) {
    if constexpr (!lanes_exist) return nullptr;
    for_each_index(solid.count, PackDisplacements{solid, ends_.data()});
    return gather_again(solid);
  }
  // With other weights, at the same places.
  const BondGradient<D, Real>* gather_again(const SolidView<D, P>& solid) {
    if constexpr (!lanes_exist) return nullptr;
    run(solid, walks_.gather_bonds, nullptr);
    return gradients_.data();
  }
  // Forces of the deformation in force. Without velocities there is no viscosity.
  const BondPush<D, Real>* push(const SolidView<D, P>& solid, const Vector<D, Real>* velocity) {
    if constexpr (!lanes_exist) return nullptr;
    for_each_index(solid.count, PackStresses{solid, velocity, ends_.data()});
    run(solid, walks_.push_bonds, velocity != nullptr ? laws_.data() : nullptr);
    return pushes_.data();
  }

  std::size_t bytes() const {
    return ends_.size() * sizeof(ends_[0]) + gradients_.size() * sizeof(gradients_[0]) +
           pushes_.size() * sizeof(pushes_[0]);
  }

 private:
  static BondLaw<Real> law_of(const SolidMedium<double>& medium) {
    return {static_cast<Real>(medium.density), static_cast<Real>(medium.smoothing_length),
            static_cast<Real>(medium.artificial_linear * medium.longitudinal_speed()),
            static_cast<Real>(medium.artificial_quadratic)};
  }

 public:  // nvcc has no loop bodies that are private
  struct PackReferences {
    SolidView<D, P> solid;
    PlaceUnit<Real> unit;
    PackedBondEnd<D, Real>* ends;

    KERF_FUNCTION void operator()(Index i) const {
      for (int a = 0; a < D; ++a) ends[i].reference[a] = unit.pack(solid.reference[i][a]);
    }
  };
  struct PackDisplacements {
    SolidView<D, P> solid;
    PackedBondEnd<D, Real>* ends;

    KERF_FUNCTION void operator()(Index i) const {
      for (int a = 0; a < D; ++a) {
        const double u = solid.displacement[i][a];
        Real rounded = static_cast<Real>(u);
#if defined(__GNUC__) && !defined(__CUDA_ARCH__)
        asm("" : "+m"(rounded));  // g++ 12 with -O3 takes the remainder for zero otherwise
#endif
        ends[i].displacement[a] = rounded;
        ends[i].remainder[a] = static_cast<Real>(u - static_cast<double>(rounded));
      }
    }
  };
  struct PackStresses {
    SolidView<D, P> solid;
    const Vector<D, Real>* velocity;
    PackedBondEnd<D, Real>* ends;

    KERF_FUNCTION void operator()(Index i) const {
      for (int n = 0; n < D * D; ++n) ends[i].traction[n] = solid.traction[i].component[n];
      ends[i].hourglass = solid.hourglass[i];
      if (velocity == nullptr) return;
      for (int a = 0; a < D; ++a) ends[i].velocity[a] = velocity[i][a];
    }
  };

 private:
  void run(const SolidView<D, P>& solid, BondWalk<D, Real> walk, const BondLaw<Real>* laws) {
    BondWalkTask<D, Real> task;
    task.ends = ends_.data();
    task.begin = solid.bond_begin;
    task.neighbour = solid.neighbour;
    task.weight = solid.weight;
    task.mixed = solid.mixed;
    task.loose = solid.loose;
    task.medium = solid.medium_index;
    task.laws = laws;
    task.gradient = gradients_.data();
    task.push = pushes_.data();
    task.unit = static_cast<Real>(unit_.unit);
    walk_in_blocks(task, walk, solid.count);
  }

  WalksOf<D, Real> walks_{};
  PlaceUnit<Real> unit_{};
  // Not Array: records lie on their own alignment.
  std::vector<PackedBondEnd<D, Real>> ends_;
  std::vector<BondGradient<D, Real>> gradients_;
  std::vector<BondPush<D, Real>> pushes_;
  std::vector<BondLaw<Real>> laws_;
};

}  // namespace kerf
