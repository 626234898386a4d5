// SPDX-License-Identifier: Apache-2.0
// The formulation of Shinohara et al. (2004): one class owns the particles and the clock; `advance`
// is the order of a step.
#pragma once

#include "core/timers.hpp"
#include "fracture/break_particles.hpp"
#include "integrate/midpoint.hpp"
#include "integrate/time_step.hpp"
#include "neighbours/neighbour_list.hpp"
#include "particles/leavers.hpp"
#include "particles/reorder.hpp"
#include "rates/rates.hpp"
#include "simulation/ledger_book.hpp"
#include "simulation/motion.hpp"
#include "simulation/probes.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

template <int D, class P>
class Shinohara2004 final : public Simulation {
 public:
  explicit Shinohara2004(const Case& description);

  void advance() override {
    renew_neighbours();
    evaluate_rates();
    const double dt = choose_step();
    keep_start();
    advance_to(0.5 * dt);
    evaluate_rates();
    advance_to(dt);
    break_particles();
    book_step(dt);
    mark_leavers();
    tick(dt);
  }

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

 private:
  using Real = typename P::Real;
  using Point = Vector<D, double>;

  void renew_neighbours();
  void remove_marked();
  void let_water_in();
  void append(const std::vector<struct NewParticle>& newcomers);
  void rebuild_list();
  void evaluate_rates() const;
  double choose_step();
  [[noreturn]] void fail(const StepLimit& cause) const;
  void keep_start();
  void advance_to(double dt);
  void break_particles();
  void book_step(double dt);
  void mark_leavers();
  void tick(double dt);
  void refresh() const;
  void load_drives(double now);

  Case case_;
  std::vector<Nozzle> nozzles_;
  std::vector<Medium<double>> media_;
  Motion motion_;
  Rates<D, P> rates_;
  // Rates and stresses are a function of the state: looking at a run refreshes them.
  mutable Particles<D, P> particles_;
  mutable LedgerBook<D, P> book_;
  mutable Probes<D, P> probes_;
  mutable Timers timers_;
  mutable double pair_interactions_ = 0.0;
  mutable bool fresh_ = false;
  NeighbourList<D, P> list_;
  Array<Drive<D>> drives_;
  Point gravity_, minimum_, maximum_;

  double time_ = 0.0;
  std::uint64_t step_ = 0;
  std::uint32_t next_id_ = 0;
  bool list_is_due_ = true;
  double shortest_step_ = 0.0;  // s, below which the run has broken down
  double runaway_speed_ = 0.0;  // m/s, likewise
  StepInfo last_step_;
};

}  // namespace kerf

#include "simulation/shinohara2004_set_up.hpp"
#include "simulation/shinohara2004_show.hpp"
#include "simulation/shinohara2004_step.hpp"
