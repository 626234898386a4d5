// SPDX-License-Identifier: Apache-2.0
// Fragmentation of brittle rock after Grady & Kipp, Int. J. Rock Mech. Min. Sci. 17 (1980) 147,
// with the flaws of each particle told apart (Benz & Asphaug, Icarus 107 (1994) 98; Comput. Phys.
// Commun. 87 (1995) 253). Per volume there are  n = k strain^m  flaws that are active at a strain
// or less (Weibull). Once active a flaw grows into a crack of radius a at the speed c_g, and
// relieves the ball around it of tension: in a particle of volume V = 4/3 pi R^3
//   D = sum over its active flaws of (a / R)^3, at most 1.
// One crack alone gives d(D^(1/3))/dt = c_g / R, as Benz & Asphaug have it; many at a constant rate
// of strain give Grady & Kipp's  D = 8 pi k c_g^3 rate^m t^(m+3) / [(m+1)(m+2)(m+3)]  in the mean.
//
// The flaws of a particle are the points of a Poisson process, which is what flaws thrown at random
// into a body are: activation strains  (Gamma_j / (k V))^(1/m),  Gamma_j a sum of j exponential
// numbers. They follow from the seed and the number of the particle alone.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/random.hpp"

namespace kerf {

// The active flaws of a particle.
template <class T>
struct FlawState {
  T count;   // of them
  T next;    // strain at which one more becomes active
  T length;  // sum of a / R
  T area;    // sum of (a / R)^2
  T damage;  // D
};

// Per medium.
template <class T>
struct GradyKipp {
  // Flaws of a particle that are told apart; of more, the number is its mean, k V strain^m.
  static constexpr int most = 256;

  T unit_strain = 0;       // (k V)^(-1/m), at which one flaw per particle is active; 0 = no flaws
  T exponent = 1;          // m
  T growth = 0;            // c_g / R, 1/s
  std::uint64_t seed = 0;  // of the flaws

  KERF_FUNCTION bool is_on() const { return unit_strain > T(0); }

  struct Flaws {
    double per_volume;   // k, 1/m^3
    double exponent;     // m
    double crack_speed;  // c_g, m/s
  };
  // `volume`: of a particle, m^3.
  static GradyKipp of(const Flaws& flaws, double volume, std::uint64_t seed) {
    const double radius = std::cbrt(0.75 * volume / 3.14159265358979323846);
    GradyKipp law;
    // k alone may be more than single precision holds.
    law.unit_strain =
        static_cast<T>(std::exp(-(std::log(flaws.per_volume) + std::log(volume)) / flaws.exponent));
    law.exponent = static_cast<T>(flaws.exponent);
    law.growth = static_cast<T>(flaws.crack_speed / radius);
    law.seed = seed;
    return law;
  }
  template <class Other>
  static GradyKipp from(const GradyKipp<Other>& other) {
    return {static_cast<T>(other.unit_strain), static_cast<T>(other.exponent),
            static_cast<T>(other.growth), other.seed};
  }

  KERF_FUNCTION FlawState<T> start(std::uint64_t particle) const {
    return {T(0), strain_after(T(0), particle, 0), T(0), T(0), T(0)};
  }

  // What becomes of the flaws of a particle in a time step at this strain. Cracks grow while the
  // strain would make the weakest flaw active, since a crack is weaker than the flaw it came from.
  KERF_FUNCTION FlawState<T> advance(FlawState<T> state, std::uint64_t particle, T strain,
                                     T dt) const {
    if (!(state.damage < T(1))) return state;
    if (state.count > T(0) && strain > strain_after(T(0), particle, 0)) grow(state, growth * dt);
    while (strain > state.next && state.count < T(most)) {
      state.count += T(1);
      state.next = strain_after(state.next, particle, static_cast<std::uint64_t>(state.count));
    }
    if (!(state.count < T(most))) {
      const double mean = std::pow(double(strain) / double(unit_strain), double(exponent));
      if (mean > double(state.count)) state.count = T(mean < 1e30 ? mean : 1e30);
    }
    return state;
  }

 private:
  // Activation strain of the flaw `number`, whose predecessor has this one.
  KERF_FUNCTION T strain_after(T predecessor, std::uint64_t particle, std::uint64_t number) const {
    const double apart = -std::log(random_number(seed, particle * (most + 1) + number));
    const double before = std::pow(double(predecessor) / double(unit_strain), double(exponent));
    return static_cast<T>(double(unit_strain) * std::pow(before + apart, 1.0 / double(exponent)));
  }
  // Every crack grows by this, in R.
  KERF_FUNCTION static void grow(FlawState<T>& state, T more) {
    const T square = more * more;
    const T damage = state.damage + T(3) * (more * state.area + square * state.length) +
                     square * more * state.count;
    state.damage = damage < T(1) ? damage : T(1);
    state.area += T(2) * more * state.length + square * state.count;
    state.length += more * state.count;
  }
};

}  // namespace kerf
