// SPDX-License-Identifier: Apache-2.0
// PumpLimit is the share of its free speed at which the water of a column leaves a nozzle whose
// pump holds its pressure. In steady flow that is Bernoulli's equation from the pump, whose total
// head is rho V_0^2 / 2, to the exit:
//   p + rho V^2 / 2 = rho V_0^2 / 2,   V = V_0 sqrt(1 - 2 p / (rho V_0^2))
// The water inside the nozzle, of the length L, has inertia. With u = V / V_0 and the pressure P at
// the exit over the head its momentum is
//   du/dt = (1 - P - u^2) / (2 T),   T = L / V_0,
// so that noise of P averages out. The water does not flow back, and a pressure below that of the
// surroundings does not hasten it. See docs/theory/inflow_outflow.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace kerf {

class PumpLimit {
 public:
  // `head`: Pa, total head of the column; 0 where its free speed is 0. `delay`: s, T; infinite
  // there.
  PumpLimit(double head, double delay) : head_(head), delay_(delay) {}

  double speed_share() const { return std::min(1.0, momentum_); }  // 1, V / V_0
  // The pressure at the exit that goes with the speed, Pa.
  double pressure() const { return std::max(0.0, head_ * (1.0 - momentum_ * momentum_)); }

  // Returns the time in which the water would have come as far at its free speed, s, where it has
  // flowed for `open_time` s. Without any pressure that is `open_time` itself, to the last bit.
  double flow_time(double open_time) const {
    return open_time - lost_ - (1.0 - speed_share()) * (open_time - since_);
  }

  // Takes the pressure on the water in the nozzle over a step that is `dt` s long; at its end the
  // water has flowed for `open_time` s.
  void respond(double open_time, double dt, double pressure) {
    lost_ += (1.0 - speed_share()) * (open_time - since_);
    since_ = open_time;
    if (head_ == 0.0) return;
    const double excess = 1.0 - pressure / head_ - momentum_ * momentum_;
    momentum_ = std::clamp(momentum_ + 0.5 * dt / delay_ * excess, 0.0, most_momentum);
  }

  static constexpr std::size_t state_length = 3;
  std::vector<double> state() const { return {lost_, since_, momentum_}; }
  void restore(const std::vector<double>& state) {
    lost_ = state.at(0);
    since_ = state.at(1);
    momentum_ = state.at(2);
  }

 private:
  // The momentum may exceed that of the free speed, so that noise about no pressure averages out;
  // this is the steady one where the flow pulls with the head.
  static constexpr double most_momentum = 1.4142135623730951;
  double head_, delay_;
  double lost_ = 0.0;      // s, of flow at the free speed, until `since_`
  double since_ = 0.0;     // s, the open time at the end of the last step
  double momentum_ = 1.0;  // 1, u
};

}  // namespace kerf
