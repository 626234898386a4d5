// SPDX-License-Identifier: Apache-2.0
// KineticDamping settles solids under a static load by dynamic relaxation (Cundall 1976; Barnes,
// Int. J. Space Struct. 14 (1999) 89): whenever their kinetic energy has passed a peak, where the
// motion passes a minimum of the potential energy, all velocities are set to 0. The motion starts
// anew from there with the energy that is left, until it is at rest in equilibrium.
// docs/theory/relaxation.md
#pragma once

#include <array>
#include <vector>

#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
KERF_FUNCTION bool is_settled(const ParticleView<D, P>& particles, Index i) {
  return particles.medium(i).phase == Phase::solid && !particles.is_constrained(i);
}

// Kinetic energy and momentum of the solids that are settled.
template <int D, class P>
struct SolidMotionSum {
  enum Slot { energy = 0, momentum = 1, slots = 1 + D };
  ParticleView<D, P> particles;

  KERF_FUNCTION void add(Index i, Terms<slots>& sum) const {
    if (!is_settled(particles, i)) return;
    const double m = double(particles.medium(i).mass);
    const auto v = Vector<D, double>::from(particles.velocity[i]);
    sum.value[energy] += 0.5 * m * dot(v, v);
    for (int a = 0; a < D; ++a) sum.value[momentum + a] += m * v[a];
  }
};

template <int D, class P>
struct StopSolid {
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    if (is_settled(particles, i)) particles.velocity[i] = Vector<D, typename P::Real>::zero();
  }
};

template <int D, class P>
class KineticDamping {
 public:
  // At the end of a step: sets the velocities of solids to 0 if their kinetic energy has passed its
  // peak.
  void end_step(Particles<D, P>& particles) {
    using Sum = SolidMotionSum<D, P>;
    const auto sum = sum_(particles.sum_groups.view(), particles.owned(), Sum{particles.view()});
    const double energy = sum.value[Sum::energy];
    if (energy >= last_) {
      last_ = energy;
      return;
    }
    for_each_index(particles.size(), StopSolid<D, P>{particles.view()});
    peak_ = last_;
    last_ = 0.0;
    dissipated_ += energy;
    for (int a = 0; a < D; ++a)
      impulse_[static_cast<std::size_t>(a)] -= sum.value[Sum::momentum + a];
  }

  double peak() const { return peak_; }                              // J (2D: J/m), the last one
  double dissipated() const { return dissipated_; }                  // J (2D: J/m), since the start
  const std::array<double, 3>& impulse() const { return impulse_; }  // N s (2D: N s/m)

  std::vector<double> save() const {
    return {last_, peak_, dissipated_, impulse_[0], impulse_[1], impulse_[2]};
  }
  void restore(const std::vector<double>& saved) {
    last_ = saved.at(0);
    peak_ = saved.at(1);
    dissipated_ = saved.at(2);
    impulse_ = {saved.at(3), saved.at(4), saved.at(5)};
  }

 private:
  double last_ = 0.0;  // J, at the end of the last step
  double peak_ = 0.0, dissipated_ = 0.0;
  std::array<double, 3> impulse_{};
  GroupSum<Terms<SolidMotionSum<D, P>::slots>> sum_;
};

}  // namespace kerf
