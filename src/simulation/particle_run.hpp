// SPDX-License-Identifier: Apache-2.0
// The base of the runs of all formulations: it owns the particles, the neighbour list, the nozzles,
// the balance and the clock. A formulation derives from it and implements a step.
#pragma once

#include <functional>

#include "core/timers.hpp"
#include "distributed/domain_decomposition.hpp"
#include "distributed/planned_particles.hpp"
#include "neighbours/neighbour_list.hpp"
#include "particles/outflow.hpp"
#include "particles/reorder.hpp"
#include "simulation/balance_accumulator.hpp"
#include "simulation/exit_pressure.hpp"
#include "simulation/probes.hpp"
#include "simulation/run_settings.hpp"
#include "simulation/simulation.hpp"
#include "time/time_step.hpp"

namespace kerf {

// `Traits` are those of a formulation:
//   Pairs                               which particles interact (neighbours/pair_range.hpp)
//   field_groups(has_solids, smooth_walls, mirrored)  the groups of fields that its particles have
//   stored_by_solid(particles, i, m)    the energy that a solid particle stores
template <int D, class P, class Traits>
class ParticleRun : public Simulation {
 public:
  bool finished() const override { return time_ >= settings_.end_time; }
  double time() const override { return time_; }
  std::uint64_t step() const override { return step_; }
  std::uint64_t shifts() const override { return shifts_; }
  std::size_t particles() const override { return ranks::total(particles_.owned()); }
  StepInfo last_step() const override { return last_step_; }
  Frame frame() const override;
  Balance balance() const override;
  std::vector<FieldSpan> fields() const override;
  std::vector<double> probe_values() const override;
  double pair_interactions() const override {
    return ranks::combined(pair_interactions_, std::plus<double>());
  }
  double neighbours_per_particle() const override;
  double bytes_per_particle() const override;
  std::vector<StageTime> stage_times() const override { return timers_.times(); }
  void save(Archive& archive) const override;
  void restore(const Archive& archive) override;

 protected:
  using Real = typename P::Real;
  using Position = Vector<D, double>;

  explicit ParticleRun(RunSettings settings);

  // Evaluates rates, stresses and forces at the current state, for output.
  virtual void evaluate_current() const = 0;
  // Evaluates the accelerations by the pairs across a plane.
  virtual void accelerate_across(const AcrossPlane<D>& across) const = 0;

  // Called when particles have other indices than before. `listed_anew` has 1 for those whose list
  // of neighbours is new; null: all are.
  virtual void after_reorder([[maybe_unused]] const std::uint8_t* listed_anew) {}
  // Called when some lists of neighbours are new (NeighbourList::listed_anew), of particles in the
  // same order.
  virtual void after_refresh() {}

  // Returns what ranks would have of the particles. add_more(rank, loads, messages) adds what else
  // they have, where `rank` has that of each particle.
  template <class AddMore>
  RankLoads planned(int count, const AddMore& add_more) const;

  // The start of a run and the stages of a step, in their order.
  // `lay_out` is called after the first list is built, before the first forces.
  template <class LayOut>
  void open(const LayOut& lay_out);
  void inject_inflow();
  // Renews the list, where that is due, unless it will be valid once all particles have moved on
  // for `horizon` seconds.
  void renew_neighbours(double horizon);
  void renew_list();         // and removes outflow
  void refresh_fractured();  // renews the list around particles that have become fluid
  void rebuild_list();
  // Gives the ghosts that are in lists, of several ranks, the state that the particles have now.
  void update_listed_ghosts();
  void drop_ghosts() {
    if constexpr (ranks::exist) decomposition_.drop_ghosts(particles_);
  }
  // The same of all ghosts.
  void update_ghosts() const {
    if constexpr (ranks::exist)
      if (ranks::are_several()) decomposition_.update_ghosts(particles_);
  }
  // Gives them one field, or gives particles what merge(own, ghost) makes of those of their ghosts.
  template <class T>
  void update_ghosts([[maybe_unused]] Array<T>& field) const {
    if constexpr (ranks::exist)
      if (ranks::are_several()) decomposition_.update_ghosts(particles_, field);
  }
  template <class T, class Merge>
  void merge_ghosts([[maybe_unused]] Array<T>& field, [[maybe_unused]] const Merge& merge) const {
    if constexpr (ranks::exist)
      if (ranks::are_several()) decomposition_.merge_ghosts(particles_, field, merge);
  }
  // `other`: a limit besides those of the particles, of the same step at all ranks. A particle that
  // is not at this rank has an index beyond all.
  double choose_step(StepRates rates, const StepLimit& other = {1e300, Limit::end_of_run, 0});
  // Loads the motions of the step from its start until `now`; `end`: the end of the step.
  void load_prescribed_motions(double now, double end);
  // Moves the domain to its place after some shifts of a travelling frame. The list must be
  // rebuilt.
  void move_domain(std::uint64_t shifts);
  void remove_marked();
  // Adds particles at the end, with the next ids.
  void append(std::vector<NewParticle> newcomers);
  std::uint32_t next_id() const { return next_id_; }
  // Adds the step to the balance, in one pass with before(i), which ends it, and after(i).
  template <class Before, class After>
  void accumulate_step(double dt, const Before& before, const After& after);
  MarkOutflow<D, P> mark_outflow();  // for each particle
  // Lets the pumps that hold their pressure respond to the forces on the water in their nozzles, by
  // the accelerations of the step. It must be called after the motions of the step are loaded, and
  // before water is released.
  void respond_at_exits(double dt);
  void tick(double dt);

  RunSettings settings_;  // nozzles, media and particles are moved to the members below
  std::vector<Nozzle> nozzles_;
  std::vector<Medium<double>> media_;
  // Rates and stresses are functions of the state: output evaluates them again.
  mutable Particles<D, P> particles_;
  mutable BalanceAccumulator<D, P, Traits> balance_;
  mutable Probes<D, P> probes_;
  mutable Timers timers_{wait_for_loops};
  mutable double pair_interactions_ = 0.0;
  NeighbourList<D, P, typename Traits::Pairs> list_;
  Array<PrescribedMotion<D>> prescribed_motions_;
  Position gravity_, minimum_, maximum_;
  double time_ = 0.0;

 private:
  bool any_has(std::uint8_t flags) const;
  bool refresh_list(double horizon);  // false: it cannot be refreshed
  bool refresh_with_ghosts(double horizon, bool have_moved);
  // Fetches the ghosts, of several ranks, and finds all lists, of particles in their order.
  void list_particles();
  void fetch_ghosts() {
    if constexpr (ranks::exist)
      if (ranks::are_several()) decomposition_.fetch_ghosts(particles_, list_.grids());
  }
  void note_listed();
  void note_listed_ghosts();
  // Gives every rank its part of the particles.
  void distribute() {
    if constexpr (ranks::exist) decomposition_.distribute(particles_, list_.grids());
  }
  // Calls use(particles) with the particles of all ranks at rank 0, with none at others.
  template <class Use>
  auto with_all_particles(const Use& use) const {
    if constexpr (ranks::exist)
      if (ranks::are_several()) return use(decomposition_.gathered(particles_));
    return use(particles_);
  }
  void restore_particles(const Archive& archive);
  void note_order(const std::uint8_t* listed_anew);  // when particles have other indices
  void close_planes();
  std::size_t first_jet() const { return settings_.source_names.size() - nozzles_.size(); }
  struct ParticleStep;
  ParticleStep step_of(const StepLimit& limit) const;
  ParticleStep step_at_any_rank(const StepLimit& limit) const;
  [[noreturn]] void fail(const ParticleStep& cause) const;
  void refresh() const;

  mutable DomainDecomposition<D, P> decomposition_;
  ExitPressure<D, P> exit_pressure_;
  Array<ColumnFlow> column_flows_;  // of all nozzles, one after the other
  mutable bool fresh_ = false;
  std::uint64_t step_ = 0, shifts_ = 0;  // shifts of a travelling frame
  std::uint32_t next_id_ = 0;
  std::uint32_t next_listed_ = 0;  // next_id_ when the particles were listed
  bool list_is_due_ = true;
  double shortest_step_ = 0.0;  // s, below which the run has broken down
  double runaway_speed_ = 0.0;  // m/s, likewise
  StepInfo last_step_;
};

}  // namespace kerf

#include "simulation/particle_run_checkpoint.hpp"
#include "simulation/particle_run_set_up.hpp"
#include "simulation/particle_run_show.hpp"
#include "simulation/particle_run_step.hpp"
