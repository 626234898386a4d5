// SPDX-License-Identifier: Apache-2.0
// A solid that flows and breaks, in the total Lagrangian description: deformation and forces are
// sums over bonds of the reference configuration, found once (docs/theory/total_lagrangian.md).
// Particles keep the order of set-up; neighbours in memory should be neighbours in space. After
// set-up nothing allocates.
//
// A step:  deform(positions, dt);  fracture();  accelerate(velocities);  keep_flow().
#pragma once

#include <utility>

#include "core/error.hpp"
#include "solid/bond_force.hpp"
#include "solid/break_bonds.hpp"
#include "solid/correct.hpp"
#include "solid/deform.hpp"
#include "solid/keep_flow.hpp"
#include "solid/stored_energy.hpp"
#include "solid/stretch_limit.hpp"

namespace kerf {

struct FractureBook {
  std::uint64_t bonds = 0;  // broken, each counted once
  Index loosened = 0;       // particles that came loose
  double released = 0.0;    // J (2D: J/m): stored energy before less after, hourglass part included
  double power_gain = 0.0;  // W (2D: W/m): power of the bonds on the moving particles, after less
                            // before
};

// What a solid remembers beside positions and velocities, which are the caller's: its bonds, and
// the acceleration, because the kick of a step may come before accelerate().
template <int D, class P>
struct SolidState {
  std::vector<typename P::Real> weight;
  std::vector<Vector<D, typename P::Real>> acceleration;
  std::vector<PlasticState<D, typename P::Real>> flow;  // empty where nothing flows
};

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
    for_each_index(size(), SetWholeWeights<D, P>{view()});
    if (fields_.any_flows) for_each_index(size(), StartUnflown<D, P>{view()});
    correct_all();
    count();  // makes room for sums
  }

  // Deformation and stress at these positions, `dt` after the last keep_flow(). dt counts where
  // strength depends on the rate of strain; 0 = so slow that it does not.
  void deform(const Positions& position, double dt = 0.0) {
    require(position.size() == size(), "positions of every particle of the solid");
    dt_ = dt;
    for_each_index(size(), Displace<D, P>{view(), pointer(position)});
    respond();
  }

  // Ends a step: the next one starts from the plastic state of the deformation in force. The energy
  // dissipated by flow, J.
  double keep_flow() {
    if (!fields_.any_flows) return 0.0;
    for_each_index(size(), KeepFlow<D, P>{view()});
    return power_sum_(size(), FlowLossTerm<D, P>{view()}).value[0];
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
      accelerate_with(BondViscosity<D, P>{pointer(velocity)}, filter);
    } else {
      accelerate_with(NoViscosity<D, P>{}, filter);
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
  std::size_t bytes() const { return fields_.bytes(); }

  SolidState<D, P> save() const {
    return {to_host(fields_.weight), to_host(fields_.acceleration), to_host(fields_.flow_start)};
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
    correct_all();
  }

 private:
  void take_media(const SolidLayout<D>& layout) {
    std::vector<SolidMedium<Real>> media;
    for (const auto& medium : layout.media) {
      media.push_back(SolidMedium<Real>::from(medium));
      is_viscous_ |= medium.artificial_linear > 0.0 || medium.artificial_quadratic > 0.0;
      can_break_ |= medium.can_break();
    }
    std::vector<PlasticParameters<Real>> plastic;
    for (const auto& parameters : layout.plastic) {
      plastic.push_back(PlasticParameters<Real>::from(parameters));
      fields_.any_flows |= parameters.flows();
      is_viscous_ |= parameters.flows();
      can_break_ |= parameters.flows() && parameters.damage.is_on();
    }
    require(plastic.empty() || plastic.size() == media.size(), "laws of flow for every medium");
    to_device(media, fields_.media);
    to_device(plastic, fields_.plastic);
  }

  void respond() {
    if (fields_.any_flows) {
      using Response = FlowingResponse<D, P>;
      for_each_index(size(), Deform<D, P, Response>{view(), {static_cast<Real>(dt_)}});
    } else {
      for_each_index(size(), Deform<D, P, ElasticResponse<D, P>>{view(), {}});
    }
  }

  template <class Viscosity, class Filter>
  void accelerate_with(const Viscosity& viscosity, const Filter& filter) {
    for_each_index(size(), BondForce<D, P, Viscosity, Filter>{view(), viscosity, filter});
  }

  // Breaks bonds by `breaker`, deforms what is left anew and says what that made of the solid.
  template <class Breaker>
  FractureBook book(const Breaker& breaker, const Velocities& velocity) {
    const double held = energy().total() + flow_work(), power = elastic_power(velocity);
    const auto [bonds, loose] = count();
    for_each_index(size(), breaker);
    do {
      settle();
      respond();
      if (can_break_) for_each_index(size(), Crush<D, P>{view()});
    } while (any_changed());
    const auto [bonds_left, loose_now] = count();
    return {bonds - bonds_left, loose_now - loose, held - energy().total() - flow_work(),
            elastic_power(velocity) - power};
  }

  // Power of the bonds on particles that move like this, without viscosity, W.
  double elastic_power(const Velocities& velocity) {
    if (velocity.empty()) return 0.0;
    accelerate_with(NoViscosity<D, P>{}, EveryBond{});
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
  OrderedSum<2> sum_;
  OrderedSum<1> power_sum_;
  double dt_ = 0.0;
  bool is_viscous_ = false;
  bool can_break_ = false;
};

}  // namespace kerf
