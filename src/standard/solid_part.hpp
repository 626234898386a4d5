// SPDX-License-Identifier: Apache-2.0
// The solids of a run of the `standard` formulation: this class passes positions and velocities to
// the total Lagrangian solid (solid/) and its forces back, and keeps its share of the balance and
// of checkpoints.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "distributed/planned_messages.hpp"
#include "simulation/balance.hpp"
#include "simulation/media.hpp"
#include "simulation/run_settings.hpp"
#include "simulation/state_io.hpp"
#include "solid/pair_correction.hpp"
#include "solid/total_lagrangian.hpp"
#include "standard/open_damaged.hpp"
#include "standard/sleep.hpp"
#include "standard/solid_boundaries.hpp"
#include "standard/solid_exchange.hpp"
#include "standard/solid_link.hpp"
#include "standard/solid_losses.hpp"
#include "standard/solid_members.hpp"
#include "standard/solid_show.hpp"
#include "standard/turn_faces.hpp"
#include "time/subcycling.hpp"

namespace kerf {

template <int D, class P>
class SolidPart {
 public:
  using Real = typename P::Real;

  // `particles` are those of the start, in the order of their ids.
  SolidPart(const RunSettings& settings, const std::vector<Medium<double>>& media,
            Particles<D, P>& particles);

  // Makes the solid of these members, in its undeformed state.
  void build(const RunSettings& settings, const std::vector<Medium<double>>& media,
             Particles<D, P>& particles, SolidMembers<D> members);
  // Exchanges the solid for that of these members; what both have keeps its state. The members that
  // are no longer there must be removed before, and a new list must follow. Returns the losses that
  // the state of the earlier solid holds.
  SolidLosses exchange(const RunSettings& settings, const std::vector<Medium<double>>& media,
                       Particles<D, P>& particles, SolidMembers<D> members);
  // Lets all ranks share the work of a solid that each has built. No-op with one.
  void divide() {
    if (solid_ && is_divided()) solid_->divide();
  }
  // Moves the absorbing faces to those of the present window.
  void move_boundaries(const RunSettings& settings, const std::vector<Medium<double>>& media) {
    boundaries_.move(settings, media, members_.reference, members_.medium_index);
  }
  // After an exchange and a new list: takes the deformation of the new solid. What it held of the
  // losses `held` before and no longer holds remains lost.
  void settle(Particles<D, P>& particles, const SolidLosses& held);
  const SolidMembers<D>& members() const { return members_; }

  // Links the solid to its particles in their new order, for which there is a new list.
  void relink(Particles<D, P>& particles, const NeighbourView& list) {
    if (!solid_) return;
    find_particles(particles);
    thrust::fill(fully_bonded_.begin(), fully_bonded_.end(), std::uint8_t(0));
    mark_fully_bonded(particles, list, nullptr);
  }
  // Finds out which particles are fully bonded, of those that are listed anew (null: all).
  void mark_fully_bonded(Particles<D, P>& particles, const NeighbourView& list,
                         const std::uint8_t* listed_anew) {
    if (!solid_) return;
    fully_bonded_.resize(particles.size(), std::uint8_t(0));
    for_each_index(solid_->size(),
                   MarkFullyBonded<D, P>{particles.view(), link(), solid_->view(), list,
                                         listed_anew, pointer(fully_bonded_)});
  }
  // The list without the neighbours of fully bonded particles, for loops that skip the same body.
  NeighbourView without_fully_bonded(NeighbourView list) const {
    list.fully_bonded = solid_ ? pointer(fully_bonded_) : nullptr;
    return list;
  }

  // Lets solid at rest fall asleep, at the end of a step (standard/sleep.hpp).
  void fall_asleep(Particles<D, P>& particles, const NeighbourView& list) {
    if (!solid_) return;
    FallAsleep<D, P> fall{particles.view(), list, link(), solid_->view()};
    if (is_divided()) share_state_at_rest(fall);
    for_each_index(solid_->size(), fall);
  }
  // Applies an action that spreads from particles to the other ends of their bonds.
  template <template <int, class> class Action>
  void spread_to_bond_ends(const Action<D, P>& action) {
    if (!solid_) return;
    const SpreadToBondEnds<D, P, Action> spread{action, link(), solid_->view()};
    if (is_divided())
      for (const Index s : numbers_at_all_ranks(SpreadsFrom<D, P, Action>{spread})) spread.from(s);
    else
      for_each_index(solid_->size(), spread);
  }

  // Whether the current step is the first substep of a step of the solid (time/subcycling.hpp).
  bool is_first_substep() const { return solid_ && cycle_.is_first_substep(); }

  // In the middle of the first substep, of length `dt`: deforms the solid to its prediction for the
  // middle of its step.
  void predict(Particles<D, P>& particles, double dt) {
    if (!is_first_substep()) return;
    cycle_.begin(dt, longest_step_);
    deform(particles, cycle_.length(), cycle_.prediction_time(dt));
    boundaries_.turn(solid_->fields());
  }
  // Deforms the solid to the current positions of the particles.
  void deform_to_current(Particles<D, P>& particles) {
    if (solid_) deform(particles, std::max(0.0, cycle_.time_since_middle()), 0.0);
  }

  // Breaks the bonds that meet their fracture criterion; the deformation must be that of predict().
  void break_bonds(Particles<D, P>& particles) {
    if (!is_first_substep()) return;
    take(solid_->fracture(0.5 * cycle_.length()), particles, true);
  }

  // Sets the time of the loads, s.
  void set_time(double time) { boundaries_.set_time(time); }

  // Adds the accelerations by all bonds, which in later substeps are those of the first one, and by
  // absorbing faces, at the given velocities of the particles, and loads.
  void accelerate_by_all(Particles<D, P>& particles, const Vector<D, Real>* velocity);
  // Adds the accelerations by the bonds that `filter` selects, at the current deformation.
  template <class Filter>
  void accelerate(Particles<D, P>& particles, const Filter& filter) {
    if (!solid_) return;
    solid_->keeping_accelerations([&] {
      if (is_divided()) return accelerate_divided(particles, filter);
      solid_->accelerate(BondFilter<D, P, Filter>{particles.view(), link(), filter},
                         AddSolidAcceleration<D, P>{particles.view(), link(), solid_->view()});
    });
  }

  // Adds the pressure of the solid at the current deformation to its particles, for output.
  void show_pressure(Particles<D, P>& particles) {
    if (!solid_) return;
    ShowPressure<D, P> show{particles.view(), link(), solid_->view()};
    if (is_divided()) show.mean_stress = mean_stress_divided();
    for_each_index(solid_->size(), show);
  }

  // Breaks the bonds of particles that are about to be removed, at the end of a step.
  void remove_outflow(Particles<D, P>& particles);

  // Whether particles were detached since the last take_detached(), at any rank.
  bool has_detached() const { return has_detached_; }
  // The same since the last call.
  bool take_detached() { return std::exchange(has_detached_, false); }

  IntactBonds<D, P> bonds() {
    if (!solid_) return {};
    return {link(), solid_->view()};
  }

  // The gradient correction where the spacing of a nearly incompressible body jumps.
  PairCorrection<D, P> pair_correction() {
    if (!has_pair_factors_) return {};
    const auto solid = solid_->view();
    return {solid.pair_correction, pointer(number_of_id_), solid.bonds};
  }

  void end_step(Particles<D, P>& particles, double dt) {
    if (!solid_) return;
    if (cycle_.is_first_substep()) finish_solid_step(particles);
    losses_.viscous += dt * viscous_power_;
    boundaries_.end_step(particles, link(), dt);
    cycle_.end_step(dt);
  }
  // The limit by the waves of the solid for the next step, from its deformation in the middle of
  // its last one. None of its steps is longer than `most`, s.
  StepLimit step_limit(double most);
  void record_losses(Balance& balance) {
    balance.dissipated_artificial += losses_.viscous;
    balance.dissipated_fracture += losses_.released;
    balance.dissipated_plastic += losses_.plastic;
    if (!solid_) return;
    boundaries_.record(balance);
    balance.dissipated_plastic += solid_->flow_work();
    balance.dissipated_fracture += solid_->softening_work();
    const SolidEnergy energy = solid_->energy();
    balance.elastic_strain = energy.elastic;
    balance.hourglass = energy.hourglass;
  }
  // Gives rank 0 the whole solid, for frames and checkpoints.
  void gather() {
    if (solid_) solid_->gather();
  }
  void add_columns(FrameContent content, Frame& frame) const {
    if (solid_ && ranks::number() == 0)
      show_solid(solid_->fields(), body_of_medium_, number_of_id_, content, frame);
  }

  // Adds what ranks would have of the solids (standard/planned_solid.hpp).
  void plan(const std::vector<int>& rank, RankLoads& loads, PlannedMessages& messages) const;

  std::uint64_t bond_entries() const { return solid_ ? solid_->entries() : 0; }
  std::size_t bytes() const {
    const std::size_t links = (number_of_id_.size() + particle_of_.size()) * sizeof(Index);
    return links + members_.bytes() + outflow_.size() + fully_bonded_.size() + boundaries_.bytes() +
           (solid_ ? solid_->bytes() : 0);
  }

  void save(Archive& archive) const;
  void restore(const Archive& archive);

 private:
  // Marks the particles whose pairs have factors: those of nearly incompressible solids.
  void mark_fitted(const std::vector<Medium<double>>& media, Particles<D, P>& particles);
  // Records the losses of the first substep and applies plastic flow, softening and damage for the
  // step of the solid.
  void finish_solid_step(Particles<D, P>& particles);

  // `dt` after the last finish_solid_step().
  void deform(Particles<D, P>& particles, double dt, double prediction_time) {
    const MotionOfParticles<D, P> motion{particles.view(), link(), prediction_time};
    if (is_divided())
      exchange_.send(motion, *solid_);
    else
      solid_->take(motion);
    solid_->deform(dt);
  }
  // Takes over what breaks have changed, in the middle of a step or at its end.
  void take(const FractureResult& result, Particles<D, P>& particles, bool in_step);
  SolidIndexView link() const {
    return {pointer(number_of_id_), static_cast<Index>(number_of_id_.size()),
            const_cast<Index*>(pointer(particle_of_))};
  }
  void find_particles(Particles<D, P>& particles) {
    thrust::fill(particle_of_.begin(), particle_of_.end(), no_index);
    for_each_index(particles.size(), LinkSolids<D, P>{particles.view(), link()});
    if (is_divided()) exchange_.relink(link(), *solid_);
    mark_detached(particles, false);
    open_damaged(particles);
  }
  // Lets the damaged particles open (standard/open_damaged.hpp).
  void open_damaged(Particles<D, P>& particles);
  // Turns the faces of the solid to its deformation (standard/turn_faces.hpp).
  void turn_faces(Particles<D, P>& particles);
  void mark_detached(Particles<D, P>& particles, bool in_step);

  // Whether several ranks divide the solid among them; what they do then
  // (standard/solid_part_divided.hpp).
  static bool is_divided() { return ranks::are_several(); }
  template <class Chosen>
  std::vector<Index> numbers_at_all_ranks(const Chosen& chosen) const;
  void mark_at_all_ranks(Array<std::uint8_t>& marks) const;
  void share_state_at_rest(FallAsleep<D, P>& fall);
  void accelerate_divided(const AddSolidAcceleration<D, P>& add);
  template <class Filter>
  void accelerate_divided(Particles<D, P>& particles, const Filter& filter);
  const Real* mean_stress_divided();
  const Real* damaged_divided();
  const Matrix<D, Real>* gradient_divided();
  template <class Value, class T>
  const T* given_back(const Value& value, Array<T>& result);
  // Applies an action to each particle of the solid; returns what it sums.
  template <class Action>
  double sum_of(const Action& action) {
    return is_divided() ? sum_divided(action) : detached_sum_(solid_->size(), action).value[0];
  }
  template <class Action>
  double sum_divided(const Action& action) const;

  SolidExchange<D, P> exchange_;
  // Of all particles, where they are divided.
  std::vector<std::uint8_t> undeformed_, reached_;
  Array<Real> given_back_;
  Array<Matrix<D, Real>> gradient_given_back_;
  std::unique_ptr<TotalLagrangian<D, P>> solid_;
  SolidMembers<D> members_;
  std::vector<std::uint16_t> body_of_medium_;
  Array<Index> number_of_id_, particle_of_;
  Array<std::uint8_t> outflow_, fully_bonded_;
  OrderedSum<1> detached_sum_;
  SolidBoundaries<D, P> boundaries_;
  SolidLosses losses_;
  Subcycling cycle_;
  double courant_;              // 1, factor of the acoustic limit
  double longest_step_ = 0.0;   // s, of a step of the solid
  double viscous_power_ = 0.0;  // W, of the bonds in the current step of the solid
  static constexpr WaveTime unknown_wave{1e300, 0};
  WaveTime wave_ = unknown_wave;
  bool has_detached_ = false;
  bool bears_tension_ = false;     // some of the solid, by its density
  bool has_pair_factors_ = false;  // where the spacing of a nearly incompressible solid jumps
};

}  // namespace kerf

#include "standard/solid_part_divided.hpp"
#include "standard/solid_part_set_up.hpp"
#include "standard/solid_part_stages.hpp"
