// SPDX-License-Identifier: Apache-2.0
// What every formulation's run shares: it owns the particles, the neighbour list, the nozzles, the
// ledger and the clock. A formulation derives from it and says what a step is.
#pragma once

#include "core/timers.hpp"
#include "integrate/time_step.hpp"
#include "neighbours/neighbour_list.hpp"
#include "particles/leavers.hpp"
#include "particles/reorder.hpp"
#include "simulation/ledger_book.hpp"
#include "simulation/motion.hpp"
#include "simulation/populate.hpp"
#include "simulation/probes.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

// `Scheme` says how a pair of particles sees one another (neighbours/pair_range.hpp).
template <int D, class P, class Scheme>
class ParticleRun : public Simulation {
 public:
  bool finished() const override { return time_ >= case_.time.end; }
  double time() const override { return time_; }
  std::uint64_t step() const override { return step_; }
  std::size_t particles() const override { return particles_.size(); }
  StepInfo last_step() const override { return last_step_; }
  Frame frame() const override;
  Ledger ledger() const override;
  std::vector<double> probe_values() const override;
  double pair_interactions() const override { return pair_interactions_; }
  double neighbours_per_particle() const override;
  double bytes_per_particle() const override;
  std::vector<StageTime> stage_times() const override { return timers_.times(); }
  void save(Archive& archive) const override;
  void restore(const Archive& archive) override;

 protected:
  using Real = typename P::Real;
  using Place = Vector<D, double>;

  explicit ParticleRun(const Case& description);

  // Rates, stresses and forces from the state of the particles, for those who look at the run.
  virtual void evaluate_now() const = 0;
  // The accelerations by the pairs across a plane, into the particles.
  virtual void accelerate_across(const AcrossPlane<D>& across) const = 0;

  // Called when the particles have been put into another order.
  virtual void after_reorder() {}

  // The start of a run and the stages of a step, in their order.
  // `lay_out` is called once the list is there, before the first forces.
  template <class LayOut>
  void open(const LayOut& lay_out);
  void renew_neighbours();
  void renew_list();  // without what has left
  void rebuild_list();
  // `other`: a limit that particles do not know of.
  double choose_step(StepRates rates, const StepLimit& other = {1e300, Limit::end_of_run, 0});
  void load_drives(double now);
  // Books the step in one pass with what ends it, before(i), and what comes after, after(i).
  template <class Before, class After>
  void book_step(double dt, const Before& before, const After& after);
  MarkLeavers<D, P> mark_leavers();  // for each particle
  void tick(double dt);

  Case case_;
  std::vector<Nozzle> nozzles_;
  std::vector<Medium<double>> media_;
  Motion motion_;
  // Rates and stresses are a function of the state: looking at a run refreshes them.
  mutable Particles<D, P> particles_;
  mutable LedgerBook<D, P> book_;
  mutable Probes<D, P> probes_;
  mutable Timers timers_{wait_for_loops};
  mutable double pair_interactions_ = 0.0;
  NeighbourList<D, P, Scheme> list_;
  Array<Drive<D>> drives_;
  Place gravity_, minimum_, maximum_;
  double time_ = 0.0;

 private:
  bool any_has(std::uint8_t flags) const;
  void remove_marked();
  void close_planes();
  void let_water_in();
  void append(const std::vector<NewParticle>& newcomers);
  [[noreturn]] void fail(const StepLimit& cause) const;
  void refresh() const;

  mutable bool fresh_ = false;
  std::uint64_t step_ = 0;
  std::uint32_t next_id_ = 0;
  bool list_is_due_ = true;
  double shortest_step_ = 0.0;  // s, below which the run has broken down
  double runaway_speed_ = 0.0;  // m/s, likewise
  StepInfo last_step_;
};

}  // namespace kerf

#include "simulation/particle_run_set_up.hpp"
#include "simulation/particle_run_show.hpp"
#include "simulation/particle_run_step.hpp"
