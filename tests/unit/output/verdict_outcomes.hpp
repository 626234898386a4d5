// SPDX-License-Identifier: Apache-2.0
// Outcomes of runs of which verdicts are made.
#pragma once

#include "output/result.hpp"

namespace kerf {

// The outcome of a run in which the water has come to the solids.
inline RunOutcome touched_outcome() {
  RunOutcome outcome;
  outcome.balance.momentum_in = {0.0, -1.0, 0.0};
  outcome.balance.impulse_water = {0.0, -0.5, 0.0};
  return outcome;
}

inline Jet arriving_jet() {
  Jet jet;
  jet.speed = 5.0;
  jet.standoff = 0.01;
  jet.start = 0.001;
  return jet;
}

// The outcome of a run that breaks nothing, whose water has come 30 mm deep; the workpiece has
// moved along the jet.
inline RunOutcome whole_outcome(double dent, double motion) {
  RunOutcome outcome = touched_outcome();
  outcome.description.jets.push_back(arriving_jet());
  outcome.description.bodies.emplace_back();
  outcome.description.bodies.front().spacing = 2e-3;
  outcome.time = 0.06;
  outcome.cut.last.front_depth = 0.03;
  outcome.kerf.emplace();
  outcome.kerf->shape.thickness = 8e-3;
  outcome.kerf->of<CutMargin>().unbroken = 8e-3;
  outcome.kerf->of<Dent>() = {dent, motion, motion};
  return outcome;
}

}  // namespace kerf
