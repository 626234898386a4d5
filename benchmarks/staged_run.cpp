// SPDX-License-Identifier: Apache-2.0
#include "staged_run.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "model/case.hpp"
#include "simulation/run_settings.hpp"
#include "standard/standard.hpp"

namespace kerf {
namespace {

// Opens cracks across the first axis by a spacing, far beyond what a bond of gel bears.
template <int D, class P>
struct PullApart {
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    const double spacing = particles.medium(i).spacing;
    particles.position[i][0] += spacing * std::floor(particles.position[i][0] / (8.0 * spacing));
  }
};

template <int D, class P>
class StagesOf final : public StagedRun, private Standard<D, P> {
  using Run = Standard<D, P>;
  static constexpr int warm_up_steps = 3;
  static constexpr double instant = 1e-12;  // s

 public:
  explicit StagesOf(const Case& description) : Run(run_settings(description)) {
    for (int step = 0; step < warm_up_steps; ++step) Run::advance();
    Run::rebuild_list();
    Run::save(as_made_);
  }

  Simulation& simulation() override { return *this; }

  void find_neighbours() override { Run::list_.build(Run::particles_); }
  void reorder() override {
    sort_particles(Run::particles_, Run::list_.cell_numbers(Run::particles_));
  }
  void compute_pair_forces() override { Run::compute_pair_forces(); }
  void sum_over_bonds() override {
    Run::deform(step_length());
    Run::compute_bond_forces();
  }
  void break_bonds() override { Run::break_bonds(); }
  void integrate() override {
    Run::drift_half(instant);
    Run::finalize_step(instant);
  }

  void scatter() override {
    std::vector<Index> order(Run::particles_.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    Array<Index> order_on_device;
    to_device(order, order_on_device);
    gather_particles(Run::particles_, order_on_device);
  }
  void pull_apart() override {
    Run::restore(as_made_);
    for_each_index(Run::particles_.size(), PullApart<D, P>{Run::particles_.view()});
    Run::deform(step_length());
  }
  void settle() override {
    Run::restore(as_made_);
    Run::deform(step_length());
    Run::evaluate();
  }

 private:
  double step_length() const { return Run::last_step().dt; }

  Archive as_made_;
};

}  // namespace

std::unique_ptr<StagedRun> make_staged_run(const Case& description) {
  if (description.dimension == 2) return std::make_unique<StagesOf<2, Mixed>>(description);
  return std::make_unique<StagesOf<3, Mixed>>(description);
}

}  // namespace kerf
