// SPDX-License-Identifier: Apache-2.0
// Separate steps for what moves fast and for solids (multiple time stepping; Tuckerman, Berne and
// Martyna, J. Chem. Phys. 97, 1990 (1992)). Water and contact take steps as short as a wave in the
// water asks for; the bonds of a soft solid would do with longer ones. So n steps are one of the
// solid, of length T. Its bonds are looked at once, where the solid will be in the middle of T if
// it goes on as it does, and their force acts alike in all n steps:
//   a = a(x + T/2 v),   then n times  x' = x + dt/2 v,  v = v + dt (a + fast),  x = x' + dt/2 v.
// Where nothing else acts that is position Verlet (integrate/verlet.hpp) with the step T, to the
// last term:  x + T v + T^2/2 a,  v + T a.  What acts between water and solid is worked out in each
// step, for both, so that what one loses the other takes up.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "integrate/time_step.hpp"

namespace kerf {

class SolidCycle {
 public:
  // `most` steps are one of the solid, at most.
  explicit SolidCycle(int most) : most_(most) {}

  // Is the step in hand, or to come, the first of a step of the solid?
  bool begins() const { return taken_ == 0; }
  // Was the step that has just ended?
  bool has_just_begun() const { return taken_ == (steps_ > 1 ? 1 : 0); }

  // What solids allow for the step to come, of which their own waves allow `of_waves`.
  StepLimit limit(const StepLimit& of_waves) const {
    if (begins()) return of_waves;
    return {(longest_ - elapsed_) / (steps_ - taken_), of_waves.limit, of_waves.particle};
  }

  // Sets out with a first step of `dt`; all may take `longest`.
  void begin(double dt, double longest) {
    constexpr double rounding = 1.0 - 1e-6;
    const double fit = std::min(rounding * longest / dt, double(most_));
    steps_ = std::max(1, static_cast<int>(fit));
    longest_ = longest;
    elapsed_ = 0.0;
    planned_ = steps_ * dt;
  }
  // Of a step of `dt` that was taken. Lengths that were planned add up to the time that goes by.
  void end_step(double dt) {
    elapsed_ += dt;
    if (++taken_ < steps_) return;
    owed_ += elapsed_ - planned_;
    taken_ = 0;
  }

  // The length of the solid's step as planned, s.
  double length() const { return planned_; }
  // The time that it stands for, s: what the last one took longer, or shorter, than planned counts.
  double length_to_book() { return planned_ + std::exchange(owed_, 0.0); }
  // From the middle of the first step, of `dt`, to the middle of the solid's, s.
  double ahead(double dt) const { return 0.5 * (planned_ - dt); }
  // From the middle of the solid's step to where the last step ended, s.
  double since_middle() const { return elapsed_ - 0.5 * planned_; }

  std::vector<double> save() const {
    return {double(taken_), double(steps_), longest_, elapsed_, planned_, owed_};
  }
  void restore(const std::vector<double>& saved) {
    taken_ = static_cast<int>(saved.at(0));
    steps_ = static_cast<int>(saved.at(1));
    longest_ = saved.at(2);
    elapsed_ = saved.at(3);
    planned_ = saved.at(4);
    owed_ = saved.at(5);
  }

 private:
  int most_;
  int taken_ = 0, steps_ = 1;
  double longest_ = 0.0;  // s, what the solid allows for all steps together
  double elapsed_ = 0.0;  // s, of the steps that were taken
  double planned_ = 0.0;  // s, of all of them as it seemed at the first
  double owed_ = 0.0;     // s, by which the last cycle took longer than that
};

}  // namespace kerf
