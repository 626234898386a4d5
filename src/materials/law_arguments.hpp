// SPDX-License-Identifier: Apache-2.0
// These are the numbers besides their own parameters that laws depend on: the state at rest of an
// equation of state, and the body from which a law derives parameters before a run.
#pragma once

#include <cstdint>

namespace kerf {

// The state without pressure.
template <class T>
struct RestState {
  T density = 0;      // rho_0, kg/m^3
  T sound_speed = 0;  // c_0, m/s
};

struct BodyNumbers {
  int dimension = 3;
  double density = 0.0;             // kg/m^3, reference
  double sound_speed = 0.0;         // m/s, at rest
  double longitudinal_speed = 0.0;  // m/s, of the fastest elastic wave
  double particle_volume = 0.0;     // m^3 (2D: m^2)
  std::uint64_t seed = 0;           // of what is random in the body
};

// Calls `derive` of the laws that have it.
struct DeriveParameters {
  const BodyNumbers& body;
  template <class Law>
  void operator()(Law& law) const {
    if constexpr (requires { law.derive(body); }) law.derive(body);
  }
};

}  // namespace kerf
