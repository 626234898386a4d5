// SPDX-License-Identifier: Apache-2.0
// A solid that flows and breaks, in the total Lagrangian description: deformation and forces are
// sums over bonds of the reference configuration, found once (docs/theory/total_lagrangian.md).
// Particles keep the order of set-up; neighbours in memory should be neighbours in space. After
// set-up nothing allocates.
//
// A step:  deform(positions, dt);  fracture();  accelerate(velocities);  keep_flow();
// keep_softening().
#pragma once

#include <utility>

#include "core/error.hpp"
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
    take_media(layout);
    const BondLists bonds = BondFinder<D>(layout).find();
    fields_.mirrors = layout.mirrors;
    to_device(layout.medium_index, fields_.medium_index);
    to_device(layout.reference, fields_.reference);
    to_device(bonds.begin, fields_.bond_begin);
    to_device(bonds.neighbour, fields_.neighbour);
    fields_.make_room();
    fit_levels(layout, bonds);
    for_each_index(size(), SetWholeWeights<D, P>{view()});
    for_each_index(size(), FindMixed<D, P>{view()});
    if (fields_.any_softens) for_each_index(size(), StartWhole<D, P>{view()});
    if (fields_.any_flows) for_each_index(size(), StartUnflown<D, P>{view()});
    if (fields_.any_flaws) for_each_index(size(), StartFlaws<D, P>{view()});
    lanes_.set_up(layout.media, view());
    correct_all();
    count();  // makes room for sums
  }

  // Deformation and stress at these positions, `dt` after the last keep_flow(). dt counts where
  // strength depends on the rate of strain; 0 = so slow that it does not.
  void deform(const Positions& position, double dt = 0.0) {
    require(position.size() == size(), "positions of every particle of the solid");
    dt_ = dt;
    for_each_index(size(), Displace<D, P>{view(), pointer(position)});
    respond(lanes_.gather(view()));
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

  // Acceleration and viscous power of the deformation in force.
  void accelerate(const Velocities& velocity) { accelerate(velocity, EveryBond{}); }
  // By the bonds that `filter` chooses, e.g. those across a plane.
  template <class Filter>
  void accelerate(const Velocities& velocity, const Filter& filter) {
    require(!is_viscous_ || velocity.size() == size(), "velocities of every particle");
    if (fields_.any_flows) {
      for_each_index(size(), RateTraction<D, P>{view(), pointer(velocity)});
      accelerate_with(FlowViscosity<D, P>{{pointer(velocity)}, {pointer(velocity)}}, filter);
    } else if (is_viscous_) {
      accelerate_with(BondViscosity<D, P>{pointer(velocity)}, filter,
                      push_all(filter, pointer(velocity)));
    } else {
      accelerate_with(NoViscosity<D, P>{}, filter, push_all(filter, nullptr));
    }
  }

  void evaluate(const Positions& position, const Velocities& velocity) {
    deform(position);
    accelerate(velocity);
  }

  // Breaks the bonds that pass their limit at the deformation in force, and deforms what is left
  // anew. To be called between deform() and accelerate(). Without velocities no power is worked
  // out.
  FractureBook fracture(const Velocities& velocity = {}) {
    if (!can_break_) return {};
    for_each_index(size(), PrepareCriterion<D, P>{view()});
    for_each_index(size(), MarkBreaking<D, P>{{view()}});
    if (!any_changed()) return {};
    return book(BreakMarked<D, P>{{view()}}, velocity);
  }

  // Breaks bonds for good before the run: a notch. See CutBonds.
  template <class Separates>
  void cut(const Separates& separates) {
    for_each_index(size(), CutBonds<D, P, Separates>{view(), separates});
    settle();
  }

  // Breaks all bonds of the particles that are `gone`.
  FractureBook let_go(const Array<std::uint8_t>& gone) {
    return book(DropBonds<D, P>{view(), pointer(gone)}, {});
  }

  // The shortest time in which a wave crosses a kernel at the deformation in force.
  WaveTime wave_time() {
    return reduce_unordered(size(), StretchLimit<D, P>{view()}, WaveTime{1e300, 0}, ShorterWave{});
  }

  // Power that the viscosity of the bonds dissipates now, W.
  double viscous_power() {
    return is_viscous_ ? power_sum_(size(), PowerTerm<D, P>{view()}).value[0] : 0.0;
  }

  // Works out the energies per particle at the deformation in force; their totals.
  SolidEnergy energy() {
    for_each_index(size(), StoreEnergy<D, P>{view()});
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
  std::size_t bytes() const { return fields_.bytes() + lanes_.bytes(); }
  // Per particle: 1 where the factor of a pair may differ from 1; empty where all are 1.
  const std::vector<std::uint8_t>& fitted() const { return fitted_; }

  SolidState<D, P> save() const {
    return {to_host(fields_.weight), to_host(fields_.acceleration), to_host(fields_.flow_start),
            to_host(fields_.strain_start), to_host(fields_.flaws)};
  }
  // Goes on from a state saved by a solid of the same layout. deform() comes next.
  void restore(const SolidState<D, P>& state) {
    require(state.weight.size() == fields_.weight.size() && state.acceleration.size() == size(),
            "a saved solid has the particles and bonds of its layout");
    to_device(state.weight, fields_.weight);
    to_device(state.acceleration, fields_.acceleration);
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
  void take_media(const SolidLayout<D>& layout) {
    std::vector<SolidMedium<Real>> media;
    for (const auto& medium : layout.media) {
      media.push_back(SolidMedium<Real>::from(medium));
      is_viscous_ |= medium.artificial_linear > 0.0 || medium.artificial_quadratic > 0.0;
      can_break_ |= medium.can_break();
      fields_.any_softens |= medium.softens();
    }
    std::vector<PlasticParameters<Real>> plastic;
    for (const auto& parameters : layout.plastic) {
      plastic.push_back(PlasticParameters<Real>::from(parameters));
      fields_.any_flows |= parameters.flows();
      is_viscous_ |= parameters.flows();
      can_break_ |= parameters.flows() && parameters.damage.is_on();
    }
    std::vector<GradyKipp<Real>> flaw_law;
    for (const auto& law : layout.flaws) {
      flaw_law.push_back(GradyKipp<Real>::from(law));
      fields_.any_flaws |= law.is_on();
    }
    require(flaw_law.empty() || flaw_law.size() == media.size(), "laws of flaws for every medium");
    to_device(flaw_law, fields_.flaw_law);
    require(plastic.empty() || plastic.size() == media.size(), "laws of flow for every medium");
    to_device(media, fields_.media);
    to_device(plastic, fields_.plastic);
  }

  void fit_levels(const SolidLayout<D>& layout, const BondLists& bonds) {
    const BondFit fit = LevelFit<D>(layout, bonds).solve();
    to_device(std::vector<Real>(fit.of_bond.begin(), fit.of_bond.end()), fields_.bond_fit);
    to_device(std::vector<Real>(fit.of_pair.begin(), fit.of_pair.end()), fields_.pair_fit);
    fitted_ = fit.fitted;
  }

  void respond(const BondGradient<D, Real>* gathered) {
    if (fields_.any_flows) {
      using Response = FlowingResponse<D, P>;
      for_each_index(size(), Deform<D, P, Response>{view(), {static_cast<Real>(dt_)}, gathered});
    } else {
      for_each_index(size(), Deform<D, P, ElasticResponse<D, P>>{view(), {}, gathered});
    }
  }

  template <class Viscosity, class Filter>
  void accelerate_with(const Viscosity& viscosity, const Filter& filter,
                       const BondPush<D, Real>* pushed = nullptr) {
    for_each_index(size(), BondForce<D, P, Viscosity, Filter>{view(), viscosity, filter, pushed});
  }
  // By all bonds at once, where no bond is left out.
  template <class Filter>
  const BondPush<D, Real>* push_all(const Filter&, const Vector<D, Real>* velocity) {
    if constexpr (!std::is_same_v<Filter, EveryBond>) return nullptr;
    return lanes_.push(view(), velocity);
  }

  // Breaks bonds by `breaker`, deforms what is left anew and says what that made of the solid.
  template <class Breaker>
  FractureBook book(const Breaker& breaker, const Velocities& velocity) {
    const double held = held_energy(), power = elastic_power(velocity);
    const auto [bonds, loose] = count();
    for_each_index(size(), breaker);
    do {
      settle();
      respond(lanes_.gather_again(view()));
      if (can_break_) for_each_index(size(), Crush<D, P>{view()});
    } while (any_changed());
    const auto [bonds_left, loose_now] = count();
    return {bonds - bonds_left, loose_now - loose, held - held_energy(),
            elastic_power(velocity) - power};
  }

  // What is stored, and what the step in hand took from it.
  double held_energy() { return energy().total() + flow_work() + softening_work(); }

  // Power of the bonds on particles that move like this, without viscosity, W.
  double elastic_power(const Velocities& velocity) {
    if (velocity.empty()) return 0.0;
    accelerate_with(NoViscosity<D, P>{}, EveryBond{}, push_all(EveryBond{}, nullptr));
    return power_sum_(size(), ElasticPowerTerm<D, P>{view(), pointer(velocity)}).value[0];
  }

  void correct_all() {
    thrust::fill(fields_.loose.begin(), fields_.loose.end(), std::uint8_t(0));
    thrust::fill(fields_.changed.begin(), fields_.changed.end(), std::uint8_t(1));
    for_each_index(size(), SetHourglassModulus<D, P>{view()});
    settle();
  }

  // A particle that comes loose takes bonds from others, which may come loose in turn.
  void settle() {
    do {
      for_each_index(size(), Correct<D, P>{view()});
      for_each_index(size(), DropBonds<D, P>{view(), pointer(fields_.loose)});
    } while (any_changed());
  }

  bool any_changed() {
    return reduce_unordered(size(), IsSet{pointer(fields_.changed)}, false, Either{});
  }

  SolidFields<D, P> fields_;
  BondLanes<D, P> lanes_;
  std::vector<std::uint8_t> fitted_;
  OrderedSum<2> sum_;
  OrderedSum<1> power_sum_;
  double dt_ = 0.0;
  bool is_viscous_ = false;
  bool can_break_ = false;
};

}  // namespace kerf
