// SPDX-License-Identifier: Apache-2.0
// A strip with a notch that is stretched until it breaks.
#pragma once

#include "support/solid_blocks.hpp"

namespace kerf::test {

struct LeftNotch {
  KERF_FUNCTION bool operator()(const Vector<2, double>& a, const Vector<2, double>& b) const {
    return a[0] < 10e-3 && b[0] < 10e-3 && (a[1] < 10e-3) != (b[1] < 10e-3);
  }
};

template <class P>
SolidOnTrial<2, P> notched_strip(double spacing = 1e-3, double limit = 0.1) {
  auto medium = soft_solid(spacing, 2);
  medium.failure_strain = limit;
  medium.artificial_linear = 0.5;
  const int wide = static_cast<int>(std::lround(30e-3 / spacing));
  const int high = static_cast<int>(std::lround(20e-3 / spacing));
  SolidOnTrial<2, P> trial(block<2>({.cells = {wide, high, 1}, .spacing = spacing}, medium));
  trial.solid.cut(LeftNotch{});
  return trial;
}

template <class P>
double pulling_step(const SolidOnTrial<2, P>& trial) {  // s
  const auto& medium = trial.layout.media[0];
  return 0.2 * medium.spacing / medium.bond_wave_speed();
}

// Takes a step in which the two ends of a strip 20 mm high move apart; returns the broken bonds and
// the released energy.
template <class P>
FractureResult pull_once(SolidOnTrial<2, P>& trial, double speed, double dt) {
  trial.kick(0.5 * dt);
  for (std::size_t i = 0; i < trial.size(); ++i) {
    const double y = trial.layout.reference[i][1];
    if (y < 2e-3) trial.velocity[i] = {0, static_cast<typename P::Real>(-speed)};
    if (y > 18e-3) trial.velocity[i] = {0, static_cast<typename P::Real>(speed)};
    trial.position[i] += dt * Vector<2, double>::from(trial.velocity[i]);
  }
  trial.deform();
  const FractureResult book = trial.solid.fracture();
  trial.evaluate();
  trial.kick(0.5 * dt);
  return book;
}

// Moves the two ends apart for `time`, until the strip is broken; returns the released energy, J/m.
template <class P>
double pull(SolidOnTrial<2, P>& trial, double speed, double time) {
  const double dt = pulling_step(trial);
  double released = 0.0;
  trial.evaluate();
  for (double t = 0.0; t < time; t += dt) released += pull_once(trial, speed, dt).released;
  return released;
}

}  // namespace kerf::test
