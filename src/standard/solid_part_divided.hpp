// SPDX-License-Identifier: Apache-2.0
// What SolidPart does where several ranks divide the solid among them (docs/mpi.md).
#pragma once

#include "standard/planned_solid.hpp"
#include "standard/solid_part.hpp"

namespace kerf {

// Returns the numbers of the particles that any rank chooses.
template <int D, class P>
template <class Chosen>
std::vector<Index> SolidPart<D, P>::numbers_at_all_ranks(const Chosen& chosen) const {
  std::vector<Index> own;
  for (Index s = 0; s < solid_->size(); ++s)
    if (chosen(s)) own.push_back(s);
  return ranks::collected(own);
}

// Marks what any rank has marked.
template <int D, class P>
void SolidPart<D, P>::mark_at_all_ranks(Array<std::uint8_t>& marks) const {
  if constexpr (ranks::exist)
    for (const Index s : numbers_at_all_ranks(IsSet{pointer(marks)})) marks[s] = 1;
}

// The rank that computes the bonds of a particle knows whether it is undeformed; whether an end of
// its bonds is reached, the rank that has that particle.
template <int D, class P>
void SolidPart<D, P>::share_state_at_rest(FallAsleep<D, P>& fall) {
  if constexpr (ranks::exist) {
    const IndexShare share = solid_->share();
    std::vector<std::uint8_t> own(share.size());
    const IsUndeformed<D, P> is_undeformed{solid_->view()};
    for (Index k = 0; k < share.size(); ++k) own[k] = is_undeformed(share.first + k);
    undeformed_ = ranks::collected(own);
    reached_.assign(solid_->size(), 0);
    const auto is_reached = [&](Index s) {
      const Index i = particle_of_[s];
      return i != no_index && fall.particles.reached[i] != 0;
    };
    for (const Index s : numbers_at_all_ranks(is_reached)) reached_[s] = 1;
    fall.undeformed = undeformed_.data();
    fall.reached = reached_.data();
  }
}

template <int D, class P>
void SolidPart<D, P>::accelerate_divided(const AddSolidAcceleration<D, P>& add) {
  if constexpr (ranks::exist) {
    if (cycle_.is_first_substep()) solid_->accelerate(EveryBond{});
    exchange_.send_back(*solid_);
    for_each_index(solid_->size(), add);
  }
}

// By the bonds that `filter` selects by the present positions of their ends.
template <int D, class P>
template <class Filter>
void SolidPart<D, P>::accelerate_divided(Particles<D, P>& particles, const Filter& filter) {
  if constexpr (ranks::exist) {
    ParticleView<D, P> by_number = particles.view();
    by_number.position = pointer(exchange_.positions());
    solid_->accelerate(FilterByNumber<D, P, Filter>{by_number, filter});
    exchange_.send_back(*solid_);
    for_each_index(solid_->size(),
                   AddSolidAcceleration<D, P>{particles.view(), link(), solid_->view()});
  }
}

// Returns a value of the solid for the particles of this rank: value(s) of each, which its owner
// computes.
template <int D, class P>
template <class Value, class T>
const T* SolidPart<D, P>::given_back([[maybe_unused]] const Value& value, Array<T>& result) {
  if constexpr (ranks::exist) {
    const IndexShare share = solid_->share();
    result.resize(solid_->size());
    for (Index s = share.first; s < share.last; ++s) result[s] = value(s);
    exchange_.send_back(result);
  }
  return pointer(result);
}
template <int D, class P>
const typename P::Real* SolidPart<D, P>::mean_stress_divided() {
  return given_back(MeanStress<D, P>{solid_->view()}, given_back_);
}
template <int D, class P>
const typename P::Real* SolidPart<D, P>::damaged_divided() {
  return given_back(IsDamaged<D, P>{solid_->view()}, given_back_);
}
template <int D, class P>
const Matrix<D, typename P::Real>* SolidPart<D, P>::gradient_divided() {
  const auto solid = solid_->view();
  return given_back([&](Index s) { return solid.gradient[s]; }, gradient_given_back_);
}

// The sum over particles each of which is at one of the ranks, in the order and the blocks of a sum
// over the solid (parallel/ordered_sum.hpp).
template <int D, class P>
template <class Action>
double SolidPart<D, P>::sum_divided(const Action& action) const {
  struct Taken {
    Index number;
    double value;
  };
  std::vector<Taken> own;
  for (Index s = 0; s < solid_->size(); ++s) {
    auto taken = Terms<1>::zero();
    action.add(s, taken);
    if (taken.value[0] != 0.0) own.push_back({s, taken.value[0]});
  }
  std::vector<Taken> all = ranks::collected(own);
  std::sort(all.begin(), all.end(),
            [](const Taken& a, const Taken& b) { return a.number < b.number; });
  double total = 0.0, of_block = 0.0;
  Index block = 0;
  for (const Taken& taken : all) {
    if (taken.number / IndexShare::block != block) total += std::exchange(of_block, 0.0);
    block = taken.number / IndexShare::block;
    of_block += taken.value;
  }
  return total + of_block;
}

template <int D, class P>
void SolidPart<D, P>::plan(const std::vector<int>& rank, RankLoads& loads,
                           PlannedMessages& messages) const {
  if constexpr (ranks::exist) {
    if (!solid_) return;
    plan_solid(*solid_, link(), rank, loads.of, messages);
    loads.waits = loads.waits + solid_->waits();
    loads.solid = solid_->size();
    loads.solid_bytes = static_cast<double>(solid_->bytes());
  }
}

}  // namespace kerf
