// SPDX-License-Identifier: Apache-2.0
// TotalLagrangian is a solid with plastic flow and fracture in the total Lagrangian description:
// deformation and forces are sums over bonds of the reference configuration, found once
// (docs/theory/total_lagrangian.md). Particles keep the order of set-up; neighbours in memory
// should be neighbours in space. Nothing is allocated after set-up.
// A step:  take(motion);  deform(dt);  fracture();  accelerate();  then keep_flow(),
// keep_loading(), keep_softening(), keep_damage().
#pragma once

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "parallel/fused_kernel.hpp"
#include "solid/bond_force.hpp"
#include "solid/bonds_through_solid.hpp"
#include "solid/break_bonds.hpp"
#include "solid/deformation_gradient.hpp"
#include "solid/divided_solid.hpp"
#include "solid/gradient_correction_levels.hpp"
#include "solid/hold_clamped.hpp"
#include "solid/limit_break_energy.hpp"
#include "solid/set_media.hpp"
#include "solid/set_motion.hpp"
#include "solid/simd/bond_sums.hpp"
#include "solid/solid_state.hpp"
#include "solid/stored_energy.hpp"
#include "solid/update_corrections.hpp"
#include "solid/update_damage.hpp"
#include "solid/update_plasticity.hpp"
#include "solid/update_softening.hpp"
#include "solid/wave_time_limit.hpp"

namespace kerf {

template <int D, class P>
class TotalLagrangian : public DividedSolid<D, P> {
  using Divided = DividedSolid<D, P>;

 public:
  using Real = typename P::Real;
  using Positions = Array<Vector<D, double>>;
  using Velocities = Array<Vector<D, Real>>;

  explicit TotalLagrangian(const SolidLayout<D>& layout) {
    const std::size_t n = layout.reference.size();
    require(n > 0 && layout.medium_index.size() == n, "a solid has one medium per particle");
    traits_ = take_media(layout, fields_);
    const BondLists lists = bonds_of(layout);
    const BondFit fit = LevelFit<D>(layout, lists).solve();
    const StoredBonds bonds = ListSharing<D>(layout, lists, fit.fitted).store();
    fitted_ = fit.fitted;
    fields_.mirrors = layout.mirrors;
    to_device(layout.medium_index, fields_.medium_index);
    to_device(layout.reference, fields_.reference);
    to_device(bonds.begin, fields_.bond_begin);
    to_device(bonds.count, fields_.bond_count);
    to_device(bonds.entry, fields_.bond_entry);
    to_device(bonds.in_order<Real>(fit.of_bond), fields_.bond_correction);
    to_device(bonds.in_order<Real>(fit.of_pair), fields_.pair_correction);
    entries_ = lists.neighbour.size();
    fields_.make_room(*std::max_element(bonds.count.begin(), bonds.count.end()));
    to_device(bonds.multi_material, fields_.multi_material);
    to_device(bonds.several_bodies, fields_.several_bodies);
    to_device(bonds.unlike_media, fields_.unlike_media);
    for_each_index(size(), HoldClamped<D, P>{view()});
    if (fields_.any_softens) for_each_index(size(), StartSoftening<D, P>{view()});
    if (fields_.any_flows) for_each_index(size(), StartPlasticity<D, P>{view()});
    if (fields_.any_flaws) for_each_index(size(), StartFlaws<D, P>{view()});
    simd_.set_up(layout, bonds, view(), traits_.can_break);
    correct_all();
    count();  // makes room for sums
    if (!traits_.can_break) return;
    break_records_.resize(size());
    break_sum_(size(), BreakTerms<D, P>{view(), records()});
  }

  // Sets positions and velocities: motion.take(view, i) per particle (solid/set_motion.hpp).
  template <class Motion>
  void take(const Motion& motion) {
    for_each_index(size(), TakeMotion<D, P, Motion>{view(), motion});
  }

  // Computes deformation and stress at the current positions, `dt` after the last keep_flow(), s.
  // dt matters where strength depends on the strain rate; 0: quasi-static.
  void deform(double dt = 0.0) {
    dt_ = dt;
    respond([&](const auto& loop) { simd_.sum_gradients(view(), loop); });
    Divided::update_ghosts(fields_.ends);
  }
  void deform(const Positions& position, double dt = 0.0) {
    require(position.size() == size(), "positions of every particle of the solid");
    take(MotionInOrder<D, P>{pointer(position), nullptr});
    deform(dt);
  }

  // Ends a step: the next one starts from the current plastic state. Returns the plastic work, J.
  double keep_flow() {
    if (!fields_.any_flows) return 0.0;
    for_each_index(share(), UpdatePlasticity<D, P>{view()});
    return power_sum_(share(), FlowLossTerm<D, P>{view()}).value[0];
  }
  // Ends a step of media whose strength depends on the rate of strain; before keep_softening().
  void keep_loading() {
    thrust::copy(loop_policy(), fields_.loading_now.begin(), fields_.loading_now.end(),
                 fields_.loading_start.begin());
  }
  // Ends a step of media that soften. Returns the energy dissipated beside softening_work(), J.
  double keep_softening() {
    if (!fields_.any_softens) return 0.0;
    scratch_.resize(size());
    unchanged_.resize(size());
    for_each_index(share(), UpdateSoftening<D, P>{view(), pointer(unchanged_)});
    simd_.sum_misfits(view(), {view(), pointer(scratch_), pointer(unchanged_)});
    for_each_index(share(), SoftenHourglass<D, P>{view(), pointer(unchanged_), pointer(scratch_)});
    return power_sum_(share(), SofteningLossTerm<D, P>{view()}).value[0];
  }
  // Returns the energy dissipated by softening since the start, J.
  double softening_work() {
    return fields_.any_softens ? power_sum_(share(), SofteningTerm<D, P>{view()}).value[0] : 0.0;
  }
  // Ends a step: flaws grow for its time at the current deformation. Returns what is released, J.
  double keep_damage(double dt) {
    if (!fields_.any_flaws) return 0.0;
    for_each_index(share(), UpdateDamage<D, P>{view(), static_cast<Real>(dt)});
    return power_sum_(share(), DamageLossTerm<D, P>{view()}).value[0];
  }
  // Returns the plastic work from the last keep_flow() to the current deformation, J.
  double flow_work() {
    return fields_.any_flows ? power_sum_(share(), FlowWorkTerm<D, P>{view()}).value[0] : 0.0;
  }

  // Computes acceleration and viscous power of the current deformation by the bonds that `filter`
  // chooses. then(i) is called after each particle.
  template <class Filter = EveryBond, class Then = NoOp>
  void accelerate(const Filter& filter = {}, const Then& then = {}) {
    if (fields_.any_flows) {
      for_each_index(share(), RateTraction<D, P>{view()});
      Divided::update_ghosts(fields_.rate_traction, fields_.hourglass_viscosity);
      accelerate_with(FlowViscosity<D, P>{}, filter, then);
    } else if (traits_.is_viscous) {
      accelerate_with(BondViscosity<D, P>{}, filter, then);
    } else {
      accelerate_with(NoViscosity<D, P>{}, filter, then);
    }
  }
  void accelerate(const Velocities& velocity) {
    require(velocity.size() == size(), "velocities of every particle of the solid");
    take(MotionInOrder<D, P>{nullptr, pointer(velocity)});
    accelerate();
  }

  // Calls action(), which may compute accelerations, and restores the earlier ones.
  template <class Action>
  void keeping_accelerations(const Action& action) {
    const Velocities kept = fields_.acceleration, mirrored = fields_.mirror_acceleration;
    action();
    fields_.acceleration = kept;
    fields_.mirror_acceleration = mirrored;
  }

  // Breaks the bonds that exceed their limit at the current deformation, `half_step` after the
  // start of a step, s, and deforms the remaining ones. Between deform() and accelerate().
  FractureResult fracture(double half_step = 0.0) {
    if (!traits_.can_break) return {};
    half_step_ = half_step;
    scratch_.resize(size());
    for_each_index(share(), PrepareCriterion<D, P>{view(), pointer(scratch_)});
    if (!Divided::prepare_break_test(scratch_)) return {};
    const BondTest<D, P> test{view(), pointer(scratch_)};
    for_each_index(share(), MarkBreaking<D, P>{test});
    Divided::flags_to_owners(fields_.changed);
    if (!any_changed()) return {};
    return apply_breaks(BreakMarked<D, P>{test, records()});
  }

  // Breaks bonds before the run: a notch. See CutBonds.
  template <class Separates>
  void cut(const Separates& separates) {
    for_each_index(share(), CutBonds<D, P, Separates>{view(), separates});
    update_corrections({});
  }

  // Breaks all bonds of the chosen particles. `chosen`: 1 per chosen particle, else 0.
  FractureResult break_all_bonds_of(const Array<std::uint8_t>& chosen) {
    break_records_.resize(size());
    half_step_ = 0.0;
    return apply_breaks(BreakAllBonds<D, P>{view(), pointer(chosen), records()});
  }

  // Returns the time of which `courant` times is the longest step (solid/wave_time_limit.hpp).
  WaveTime wave_time(double courant) {
    using Shortest = WaveTimeLimit<D, P>;
    const Shortest shortest{view(), courant};
    Divided::update_ghosts_of_joints();
    const auto own =
        reduce_unordered(shortest.blocks(), shortest, WaveTime{1e300, 0}, ShorterWave{});
    return share().is_part ? ranks::combined(own, ShorterWave{}) : own;
  }

  // W, the current power that the viscosity of the bonds dissipates.
  double viscous_power() {
    return traits_.is_viscous ? power_sum_(share(), PowerTerm<D, P>{view()}).value[0] : 0.0;
  }
  // Returns the stored energy at the current deformation.
  SolidEnergy energy() {
    scratch_.resize(size());
    simd_.sum_misfits(view(), KeepMisfit<D, P>{view(), pointer(scratch_)});
    return SolidEnergy::of(sum_(share(), EnergyTerms<D, P>{view(), pointer(scratch_)}));
  }

  // What particles held before the last break.
  BreakRecords<D, P> records() { return {pointer(break_records_), half_step_}; }
  Index size() const { return fields_.size(); }
  using Divided::share;
  const SolidFields<D, P>& fields() const { return fields_; }
  SolidView<D, P> view() { return fields_.view(); }
  std::pair<std::uint64_t, Index> count() {  // intact bonds, detached particles
    const Terms<2> sum = sum_(share(), CountTerms<D, P>{view()});
    return {static_cast<std::uint64_t>(sum.value[0] / 2.0), static_cast<Index>(sum.value[1])};
  }
  std::size_t bytes() const {
    return fields_.bytes() + simd_.bytes() + correct_.bytes() +
           break_records_.size() * sizeof(BondBreakRecord);
  }
  // Per particle: 1 where the factor of a pair may differ from 1; empty where all are 1.
  const std::vector<std::uint8_t>& fitted() const { return fitted_; }

  SolidState<D, P> save() const { return state_of(fields_); }
  // Restores a state saved by a solid of the same layout. deform() must follow.
  void restore(const SolidState<D, P>& state) {
    restore_state(state, fields_);
    const IndexShare own = std::exchange(fields_.share, IndexShare::whole(size()));
    correct_all();
    fields_.share = own;
  }

 private:
  // Calls act with the Deform loop of these media.
  template <class Act>
  void respond(const Act& act) {
    if (fields_.any_flows)
      act(Deform<D, P, FlowingResponse<D, P>>{view(), {static_cast<Real>(dt_)}});
    else
      act(Deform<D, P, ElasticResponse<D, P>>{view(), {static_cast<Real>(dt_)}});
  }

  // Runs the SIMD kernel where no bond is left out and the bonds have no other viscosity.
  template <class Viscosity, class Filter, class Then>
  void accelerate_with(const Viscosity& viscosity, const Filter& filter, const Then& then) {
    const BondForce<D, P, Viscosity, Filter, Then> loop{view(), viscosity, filter, then};
    if constexpr (std::is_same_v<Filter, EveryBond> && Viscosity::in_simd)
      simd_.sum_forces(view(), loop, Viscosity::acts);
    else
      for_each_index(share(), loop);
  }

  // Breaks bonds by `breaker` and computes the deformation of the particles that lost some.
  template <class Breaker>
  FractureResult apply_breaks(const Breaker& breaker) {
    for_each_index(share(), breaker);
    do {
      update_corrections(records());
      respond([&]<class Loop>(const Loop& loop) {
        for_each_index(share(), LimitBreakEnergy<D, P, Loop>{loop, records()});
      });
    } while (any_changed());
    const auto broken = Divided::recorded();
    const Terms<3> sum = break_sum_(share(), BreakTerms<D, P>{view(), records()});
    Divided::publish(broken);
    const auto [bonds, detached, energy] = sum.value;
    return {static_cast<std::uint64_t>(bonds / 2.0), static_cast<Index>(detached), energy};
  }

  void correct_all() {
    thrust::fill(fields_.detached.begin(), fields_.detached.end(), std::uint8_t(0));
    thrust::fill(fields_.changed.begin(), fields_.changed.end(), std::uint8_t(1));
    for_each_index(share(), SetHourglassModulus<D, P>{view()});
    update_corrections({});
  }

  void update_corrections(const BreakRecords<D, P>& records) {
    correct_(fields_, Divided::halo(), records, simd_);
  }
  bool any_changed() { return correct_.any_changed(view()); }
  using Divided::fields_, Divided::break_records_, Divided::entries_;

  SimdBondSums<D, P> simd_;
  std::vector<std::uint8_t> fitted_;
  OrderedSum<2> sum_;
  OrderedSum<1> power_sum_;
  OrderedSum<3> break_sum_;
  Array<Real> scratch_;  // as `unchanged_`, of one call
  Array<std::uint8_t> unchanged_;
  CorrectionUpdate<D, P> correct_;
  double dt_ = 0.0, half_step_ = 0.0;
  SolidTraits traits_;
};

}  // namespace kerf
