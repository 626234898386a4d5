// SPDX-License-Identifier: Apache-2.0
// A solid that flows and breaks, in the total Lagrangian description: deformation and forces are
// sums over bonds of the reference configuration, found once (docs/theory/total_lagrangian.md).
// Particles keep the order of set-up; neighbours in memory should be neighbours in space. After
// set-up nothing allocates.
//
// A step:  take(motion);  deform(dt);  fracture();  accelerate();  keep_flow();  keep_softening().
#pragma once

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "exec/in_turn.hpp"
#include "solid/bond_force.hpp"
#include "solid/bond_lanes.hpp"
#include "solid/break_bonds.hpp"
#include "solid/correct.hpp"
#include "solid/deform.hpp"
#include "solid/fit_levels.hpp"
#include "solid/keep_damage.hpp"
#include "solid/keep_flow.hpp"
#include "solid/keep_softening.hpp"
#include "solid/solid_state.hpp"
#include "solid/stored_energy.hpp"
#include "solid/stretch_limit.hpp"
#include "solid/take_media.hpp"
#include "solid/take_motion.hpp"

namespace kerf {

template <int D, class P>
class TotalLagrangian {
 public:
  using Real = typename P::Real;
  using Positions = Array<Vector<D, double>>;
  using Velocities = Array<Vector<D, Real>>;

  explicit TotalLagrangian(const SolidLayout<D>& layout) {
    const std::size_t n = layout.reference.size();
    require(n > 0 && layout.medium_index.size() == n, "a solid has one medium per particle");
    traits_ = take_media(layout, fields_);
    const BondLists lists = BondFinder<D>(layout).find();
    const BondFit fit = LevelFit<D>(layout, lists).solve();
    const StoredBonds bonds = ListSharing<D>(layout, lists, fit.fitted).store();
    fitted_ = fit.fitted;
    fields_.mirrors = layout.mirrors;
    to_device(layout.medium_index, fields_.medium_index);
    to_device(layout.reference, fields_.reference);
    to_device(bonds.begin, fields_.bond_begin);
    to_device(bonds.count, fields_.bond_count);
    to_device(bonds.entry, fields_.bond_entry);
    to_device(bonds.in_order<Real>(fit.of_bond), fields_.bond_fit);
    to_device(bonds.in_order<Real>(fit.of_pair), fields_.pair_fit);
    const Index most = *std::max_element(bonds.count.begin(), bonds.count.end());
    fields_.words = (most + bonds_per_word - 1) / bonds_per_word;
    entries_ = lists.neighbour.size();
    fields_.make_room();
    thrust::fill(fields_.whole.begin(), fields_.whole.end(), ~std::uint32_t(0));
    to_device(bonds.mixed, fields_.mixed);
    if (fields_.any_softens) for_each_index(size(), StartWhole<D, P>{view()});
    if (fields_.any_flows) for_each_index(size(), StartUnflown<D, P>{view()});
    if (fields_.any_flaws) for_each_index(size(), StartFlaws<D, P>{view()});
    lanes_.set_up(layout, bonds, view(), traits_.can_break);
    correct_all();
    count();  // makes room for sums
    if (!traits_.can_break) return;
    accounts_.resize(size());
    break_sum_(size(), BreakTerms<D, P>{view(), accounts()});
  }

  // Where the particles are and how fast they move: motion.take(view, i) for each of them
  // (take_motion.hpp).
  template <class Motion>
  void take(const Motion& motion) {
    for_each_index(size(), TakeMotion<D, P, Motion>{view(), motion});
  }

  // Deformation and stress where the particles are, `dt` after the last keep_flow(). dt counts
  // where strength depends on the rate of strain; 0 = so slow that it does not.
  void deform(double dt = 0.0) {
    dt_ = dt;
    respond([&](const auto& loop) { lanes_.gather(view(), loop); });
  }
  void deform(const Positions& position, double dt = 0.0) {
    require(position.size() == size(), "positions of every particle of the solid");
    take(MotionInOrder<D, P>{pointer(position), nullptr});
    deform(dt);
  }

  // Ends a step: the next one starts from the plastic state of the deformation in force. The energy
  // dissipated by flow, J.
  double keep_flow() {
    if (!fields_.any_flows) return 0.0;
    for_each_index(size(), KeepFlow<D, P>{view()});
    return power_sum_(size(), FlowLossTerm<D, P>{view()}).value[0];
  }
  // Ends a step likewise of what softens. The energy dissipated by its hourglass control, J.
  double keep_softening() {
    if (!fields_.any_softens) return 0.0;
    for_each_index(size(), KeepSoftening<D, P>{view()});
    return power_sum_(size(), SofteningLossTerm<D, P>{view()}).value[0];
  }
  // What softening took since the start, J.
  double softening_work() {
    return fields_.any_softens ? power_sum_(size(), SofteningTerm<D, P>{view()}).value[0] : 0.0;
  }
  // Ends a step: flaws grow for its time at the deformation in force. What that sets free, J.
  double keep_damage(double dt) {
    if (!fields_.any_flaws) return 0.0;
    for_each_index(size(), KeepDamage<D, P>{view(), static_cast<Real>(dt)});
    return power_sum_(size(), DamageLossTerm<D, P>{view()}).value[0];
  }
  // Plastic work from the last keep_flow() to the deformation in force, J.
  double flow_work() {
    return fields_.any_flows ? power_sum_(size(), FlowWorkTerm<D, P>{view()}).value[0] : 0.0;
  }

  // Acceleration and viscous power of the deformation in force, by the bonds that `filter` chooses,
  // e.g. those across a plane. then(i) comes after each particle.
  template <class Filter = EveryBond, class Then = Idle>
  void accelerate(const Filter& filter = {}, const Then& then = {}) {
    if (fields_.any_flows) {
      for_each_index(size(), RateTraction<D, P>{view()});
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

  // Calls look(), which may work out accelerations, and has those back that were there.
  template <class Look>
  void keeping_accelerations(const Look& look) {
    const Velocities kept = fields_.acceleration, mirrored = fields_.mirror_acceleration;
    look();
    fields_.acceleration = kept;
    fields_.mirror_acceleration = mirrored;
  }

  // Breaks the bonds that pass their limit at the deformation in force, and deforms what is left
  // anew. To be called between deform() and accelerate().
  FractureBook fracture() {
    if (!traits_.can_break) return {};
    for_each_index(size(), PrepareCriterion<D, P>{view()});
    for_each_index(size(), MarkBreaking<D, P>{{view()}});
    if (!any_changed()) return {};
    return book(BreakMarked<D, P>{{view()}, accounts()});
  }

  // Breaks bonds for good before the run: a notch. See CutBonds.
  template <class Separates>
  void cut(const Separates& separates) {
    for_each_index(size(), CutBonds<D, P, Separates>{view(), separates});
    settle({});
  }

  // Breaks all bonds of the particles that are `gone`.
  FractureBook let_go(const Array<std::uint8_t>& gone) {
    accounts_.resize(size());
    return book(DropBonds<D, P>{view(), pointer(gone), accounts()});
  }

  // The shortest time in which a wave crosses a kernel at the deformation in force.
  WaveTime wave_time() {
    using Shortest = StretchLimit<D, P>;
    return reduce_unordered(Shortest::blocks(size()), Shortest{view()}, WaveTime{1e300, 0},
                            ShorterWave{});
  }

  // Power that the viscosity of the bonds dissipates now, W.
  double viscous_power() {
    return traits_.is_viscous ? power_sum_(size(), PowerTerm<D, P>{view()}).value[0] : 0.0;
  }

  // What is stored at the deformation in force.
  SolidEnergy energy() {
    const Terms<2> sum = sum_(size(), EnergyTerms<D, P>{view()});
    return {sum.value[0], sum.value[1]};
  }

  Index size() const { return fields_.size(); }
  const SolidFields<D, P>& fields() const { return fields_; }
  SolidView<D, P> view() { return fields_.view(); }
  std::pair<std::uint64_t, Index> count() {  // intact bonds, loose particles
    const Terms<2> sum = sum_(size(), CountTerms<D, P>{view()});
    return {static_cast<std::uint64_t>(sum.value[0] / 2.0), static_cast<Index>(sum.value[1])};
  }
  // Bonds, each counted from both ends, whether they are broken or not.
  std::uint64_t entries() const { return entries_; }
  std::size_t bytes() const {
    return fields_.bytes() + lanes_.bytes() + accounts_.size() * sizeof(BreakAccount);
  }
  // Per particle: 1 where the factor of a pair may differ from 1; empty where all are 1.
  const std::vector<std::uint8_t>& fitted() const { return fitted_; }

  SolidState<D, P> save() const {
    return {to_host(fields_.whole),
            to_host(fields_.acceleration),
            to_host(fields_.mirror_acceleration),
            to_host(fields_.flow_start),
            to_host(fields_.strain_start),
            to_host(fields_.flaws)};
  }
  // Goes on from a state saved by a solid of the same layout. deform() comes next.
  void restore(const SolidState<D, P>& state) {
    require(state.whole.size() == fields_.whole.size() && state.acceleration.size() == size() &&
                state.mirror_acceleration.size() == fields_.mirror_acceleration.size(),
            "a saved solid has the particles, bonds and planes of symmetry of its layout");
    to_device(state.whole, fields_.whole);
    to_device(state.acceleration, fields_.acceleration);
    to_device(state.mirror_acceleration, fields_.mirror_acceleration);
    require(state.flow.size() == fields_.flow_start.size(), "a saved solid flows as its layout");
    to_device(state.flow, fields_.flow_start);
    fields_.flow_now = fields_.flow_start;
    require(state.strain.size() == fields_.strain_start.size(), "or softens as its layout");
    to_device(state.strain, fields_.strain_start);
    fields_.strain_now = fields_.strain_start;
    require(state.flaws.size() == fields_.flaws.size(), "a saved solid has flaws as its layout");
    to_device(state.flaws, fields_.flaws);
    correct_all();
  }

 private:
  // act(loop of deform.hpp).
  template <class Act>
  void respond(const Act& act) {
    if (fields_.any_flows)
      act(Deform<D, P, FlowingResponse<D, P>>{view(), {static_cast<Real>(dt_)}});
    else
      act(Deform<D, P, ElasticResponse<D, P>>{view(), {}});
  }

  // By way of lanes where no bond is left out and their viscosity is all.
  template <class Viscosity, class Filter, class Then>
  void accelerate_with(const Viscosity& viscosity, const Filter& filter, const Then& then) {
    const BondForce<D, P, Viscosity, Filter, Then> loop{view(), viscosity, filter, then};
    if constexpr (std::is_same_v<Filter, EveryBond> && Viscosity::in_lanes)
      lanes_.push(view(), loop, Viscosity::acts);
    else
      for_each_index(size(), loop);
  }

  // Breaks bonds by `breaker`, deforms those anew that lost some and says what that made of the
  // solid.
  template <class Breaker>
  FractureBook book(const Breaker& breaker) {
    for_each_index(size(), breaker);
    do {
      settle(accounts());
      respond([&]<class Loop>(const Loop& loop) {
        for_each_index(size(), DeformBroken<D, P, Loop>{loop, accounts()});
      });
      if (traits_.can_break) for_each_index(size(), Crush<D, P>{view(), accounts()});
    } while (any_changed());
    const Terms<4> sum = break_sum_(size(), BreakTerms<D, P>{view(), accounts()});
    return {static_cast<std::uint64_t>(sum.value[0] / 2.0), static_cast<Index>(sum.value[1]),
            sum.value[2], sum.value[3]};
  }
  BreakAccounts<D, P> accounts() { return {pointer(accounts_)}; }

  void correct_all() {
    thrust::fill(fields_.loose.begin(), fields_.loose.end(), std::uint8_t(0));
    thrust::fill(fields_.changed.begin(), fields_.changed.end(), std::uint8_t(1));
    for_each_index(size(), SetHourglassModulus<D, P>{view()});
    settle({});
  }

  // A particle that comes loose takes bonds from others, which may come loose in turn.
  void settle(const BreakAccounts<D, P>& accounts) {
    for_each_index(size(), Correct<D, P>{view()});
    while (any_changed()) {
      for_each_index(size(), DropBonds<D, P>{view(), pointer(fields_.loose), accounts});
      for_each_index(size(), Correct<D, P>{view()});
    }
  }

  bool any_changed() {
    return reduce_unordered(size(), IsSet{pointer(fields_.changed)}, false, Either{});
  }

  SolidFields<D, P> fields_;
  BondLanes<D, P> lanes_;
  std::vector<std::uint8_t> fitted_;
  std::uint64_t entries_ = 0;
  OrderedSum<2> sum_;
  OrderedSum<1> power_sum_;
  OrderedSum<4> break_sum_;
  Array<BreakAccount> accounts_;
  double dt_ = 0.0;
  SolidTraits traits_;
};

}  // namespace kerf
