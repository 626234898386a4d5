// SPDX-License-Identifier: Apache-2.0
// Subcycling: separate steps for the fluid and for solids (multiple time stepping; Tuckerman, Berne
// and Martyna, J. Chem. Phys. 97, 1990 (1992)). Water and contact take steps as short as the waves
// in water require; the bonds of a soft solid allow longer ones. So n steps (substeps) make one
// step of the solid, of length T. The bond forces are evaluated once, at the positions that the
// solid is predicted to have in the middle of T, and act equally in all n substeps:
//   a = a(x + T/2 v),   then n times  x' = x + dt/2 v,  v = v + dt (a + fast),  x = x' + dt/2 v.
// Without other forces that is position Verlet (time/verlet.hpp) with the step T, to the last term:
//   x + T v + T^2/2 a,  v + T a.
// The forces between water and solid are evaluated in each substep for both, so that their momentum
// is conserved. docs/theory/subcycling.md
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "time/time_step.hpp"

namespace kerf {

class Subcycling {
 public:
  // A step of the solid has at most `most` substeps.
  explicit Subcycling(int most) : most_(most) {}

  // Whether the current, or else the next, substep is the first of a step of the solid.
  bool is_first_substep() const { return taken_ == 0; }
  // Whether the substep that has ended was the first.
  bool was_first_substep() const { return taken_ == (steps_ > 1 ? 1 : 0); }

  // The limit of solids for the next substep; their own waves allow `of_waves`.
  StepLimit limit(const StepLimit& of_waves) const {
    if (is_first_substep()) return of_waves;
    return {(longest_ - elapsed_) / (steps_ - taken_), of_waves.limit, of_waves.particle};
  }

  // Plans the substeps, of which the first has the length `dt`; the step of the solid may have the
  // length `longest`.
  void begin(double dt, double longest) {
    constexpr double rounding = 1.0 - 1e-6;
    const double fit = std::min(rounding * longest / dt, double(most_));
    steps_ = std::max(1, static_cast<int>(fit));
    longest_ = longest;
    elapsed_ = 0.0;
    planned_ = steps_ * dt;
  }
  // Ends a substep of length `dt`. The difference between planned and actual time is the time debt
  // of the next step of the solid.
  void end_step(double dt) {
    elapsed_ += dt;
    if (++taken_ < steps_) return;
    time_debt_ += elapsed_ - planned_;
    taken_ = 0;
  }

  // The planned length of the step of the solid, s.
  double length() const { return planned_; }
  // Returns the length of the step of the solid plus the time debt, s, and sets the time debt to 0.
  double take_length() { return planned_ + std::exchange(time_debt_, 0.0); }
  // The prediction time, s: from the middle of the first substep, of length `dt`, to the middle of
  // the step of the solid.
  double prediction_time(double dt) const { return 0.5 * (planned_ - dt); }
  // From the middle of the step of the solid to the end of the last substep, s.
  double time_since_middle() const { return elapsed_ - 0.5 * planned_; }

  std::vector<double> save() const {
    return {double(taken_), double(steps_), longest_, elapsed_, planned_, time_debt_};
  }
  void restore(const std::vector<double>& saved) {
    taken_ = static_cast<int>(saved.at(0));
    steps_ = static_cast<int>(saved.at(1));
    longest_ = saved.at(2);
    elapsed_ = saved.at(3);
    planned_ = saved.at(4);
    time_debt_ = saved.at(5);
  }

 private:
  int most_;
  int taken_ = 0, steps_ = 1;
  double longest_ = 0.0;    // s, what the solid allows for all substeps together
  double elapsed_ = 0.0;    // s, of the substeps that were taken
  double planned_ = 0.0;    // s, of all substeps, as planned at the first
  double time_debt_ = 0.0;  // s, by which the last step of the solid took longer
};

}  // namespace kerf
