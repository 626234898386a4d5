// SPDX-License-Identifier: Apache-2.0
// PumpLimit is the share of its free speed at which the water of a column leaves a nozzle whose
// pump holds its pressure. Bernoulli's equation from the pump, whose total head is rho V_0^2 / 2,
// to the exit,
//   p + rho V^2 / 2 = rho V_0^2 / 2,   V = V_0 sqrt(1 - 2 p / (rho V_0^2)),
// slows the water by the pressure p at the exit. p follows the force on the water in the nozzle
// with the delay T in which that water passes, which stands for its inertia:
//   T dp/dt = P - p,   P the force over the section, between minus and plus the head.
// A pressure below that of the surroundings does not hasten the water. See
// docs/theory/inflow_outflow.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace kerf {

class PumpLimit {
 public:
  // `head`: Pa, total head of the column; 0 where its free speed is 0. `delay`: s, T.
  PumpLimit(double head, double delay) : head_(head), delay_(delay) {}

  double speed_share() const { return share_; }                 // 1, V / V_0
  double pressure() const { return std::max(0.0, pressure_); }  // Pa, at the exit

  // Returns the time in which the water would have come as far at its free speed, s, where it has
  // flowed for `open_time` s. Without any pressure that is `open_time` itself, to the last bit.
  double flow_time(double open_time) const {
    return open_time - lost_ - (1.0 - share_) * (open_time - since_);
  }

  // Takes the pressure P on the water in the nozzle over a step that is `dt` s long; at its end the
  // water has flowed for `open_time` s.
  void respond(double open_time, double dt, double pressure) {
    lost_ += (1.0 - share_) * (open_time - since_);
    since_ = open_time;
    const double felt = std::clamp(pressure, -head_, head_);
    pressure_ += dt / (delay_ + dt) * (felt - pressure_);
    if (head_ > 0.0) share_ = std::sqrt(std::max(0.0, 1.0 - this->pressure() / head_));
  }

  static constexpr std::size_t state_length = 4;
  std::vector<double> state() const { return {lost_, since_, pressure_, share_}; }
  void restore(const std::vector<double>& state) {
    lost_ = state.at(0);
    since_ = state.at(1);
    pressure_ = state.at(2);
    share_ = state.at(3);
  }

 private:
  double head_, delay_;
  double lost_ = 0.0;      // s, of flow at the free speed, until `since_`
  double since_ = 0.0;     // s, the open time at the end of the last step
  double pressure_ = 0.0;  // Pa, p, negative where the flow pulls
  double share_ = 1.0;     // 1, V / V_0 from then on
};

}  // namespace kerf
