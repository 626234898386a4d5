// SPDX-License-Identifier: Apache-2.0
// Brittle rock fragments after Grady & Kipp, Int. J. Rock Mech. Min. Sci. 17 (1980) 147, with
// separate flaws in each particle (Benz & Asphaug, Icarus 107 (1994) 98; Comput. Phys.
// Commun. 87 (1995) 253). Per volume there are  n = k strain^m  flaws that are active at a strain
// or less (Weibull). Once active a flaw grows into a crack of radius a at the speed c_g, and
// relieves the ball around it of tension: in a particle of volume V = 4/3 pi R^3
//   D = sum over its active flaws of (a / R)^3, at most 1.
// One crack alone gives d(D^(1/3))/dt = c_g / R, as Benz & Asphaug have it; many at a constant rate
// of strain give Grady & Kipp's  D = 8 pi k c_g^3 rate^m t^(m+3) / [(m+1)(m+2)(m+3)]  in the mean.
//
// The flaws of a particle are the points of a Poisson process, like flaws scattered at random
// in a body: activation strains  (Gamma_j / (k V))^(1/m),  Gamma_j a sum of j exponential
// numbers. They follow from the seed and the number of the particle alone.
//
// A bond breaks when the damage of one of its ends is 1 and it is opening (bond_strain.hpp). Until
// then damage takes tension off the particle (materials/damaged.hpp).
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "core/random.hpp"
#include "fracture/bond_strain.hpp"
#include "fracture/breakable_solid.hpp"
#include "fracture/crack_band.hpp"
#include "materials/law_arguments.hpp"

namespace kerf {

// State of the flaws of a particle.
template <class T>
struct FlawState {
  T count;   // active flaws
  T next;    // strain at which one more becomes active
  T length;  // sum of a / R
  T area;    // sum of (a / R)^2
  T damage;  // D
};

// The parameters of a medium.
template <class T>
struct GradyKipp {
  // Largest number of separate flaws of a particle; beyond it, their number is its mean, k V
  // strain^m.
  static constexpr int most = 256;

  T unit_strain = 0;       // (k V)^(-1/m), at which one flaw per particle is active; 0 = no flaws
  T exponent = 1;          // m
  T growth = 0;            // c_g / R, 1/s
  std::uint64_t seed = 0;  // of the flaws
  // Parameters of the case, from which the above follow: k strain^m flaws per volume.
  T weibull_k = 0;               // 1/m^3
  T weibull_m = 0;               // 1
  T crack_speed_share = T(0.4);  // 1, of the longitudinal wave's speed
  T flaw_depth = T(1);           // m, of a 2D slice

  static constexpr std::string_view sentence =
      "Damage by cracks that grow from flaws (Grady & Kipp) is complete";
  static constexpr CriterionKeys keys{StrainOrEnergy::neither, true, "flaws"};
  static constexpr bool has_own_rate = true;  // strength_rate.hpp does not apply
  static std::vector<Key> rows() {
    using Law = GradyKipp<double>;
    return {{"weibull_k",
             ValueKind::quantity,
             "m-3",
             "",
             key_range::positive,
             {},
             "",
             "k of the number k strain^m of flaws per volume that are active at a strain",
             stored_in<&Law::weibull_k>},
            {"weibull_m",
             ValueKind::number,
             "",
             "",
             {1.0, 100.0},
             {},
             "",
             "m of the number k strain^m of flaws per volume",
             stored_in<&Law::weibull_m>},
            {"crack_speed_share",
             ValueKind::number,
             "",
             "0.4",
             key_range::up_to(1.0),
             {},
             "",
             "Speed at which cracks grow from flaws over that of longitudinal waves",
             stored_in<&Law::crack_speed_share>},
            {"flaw_depth",
             ValueKind::quantity,
             "m",
             "1 m",
             key_range::up_to(1e6),
             {},
             "",
             "Depth of a 2D slice whose flaws count; without a meaning in 3D",
             stored_in<&Law::flaw_depth>}};
  }
  static FractureLimits limits(const FractureInput&) { return {}; }
  static constexpr AcrossJoint across_joint = AcrossJoint::end;
  KERF_FUNCTION bool can_break(bool) const { return true; }
  void derive(const BodyNumbers& body) {
    const double depth = body.dimension == 2 ? flaw_depth : 1.0;
    const GradyKipp law = of({weibull_k, weibull_m, crack_speed_share * body.longitudinal_speed},
                             body.particle_volume * depth, body.seed);
    unit_strain = law.unit_strain;
    exponent = law.exponent;
    growth = law.growth;
    seed = law.seed;
  }

  // The damage of one end suffices for the mean of both to be 1.
  template <class Particle>
  KERF_FUNCTION T prepare(const Particle& particle) const {
    return particle.damage < T(1) ? T(0) : T(2);
  }
  KERF_FUNCTION bool passes(T prepared, const BreakableSolid<T>&) const {
    return !(prepared < T(1));
  }
  KERF_FUNCTION bool breaks(const BondStrain<T>& bond, const BreakableSolid<T>& solid) const {
    return passes(bond.prepared, solid) && bond.is_opening();
  }

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
    law.unit_strain =
        static_cast<T>(std::exp(-(std::log(flaws.per_volume) + std::log(volume)) / flaws.exponent));
    law.exponent = static_cast<T>(flaws.exponent);
    law.growth = static_cast<T>(flaws.crack_speed / radius);
    law.seed = seed;
    return law;
  }
  template <class Other>
  KERF_FUNCTION static GradyKipp from(const GradyKipp<Other>& other) {
    // k alone may be more than single precision holds.
    return {static_cast<T>(other.unit_strain), static_cast<T>(other.exponent),
            static_cast<T>(other.growth), other.seed};
  }
  bool operator==(const GradyKipp&) const = default;

  KERF_FUNCTION FlawState<T> start(std::uint64_t particle) const {
    return {T(0), strain_after(T(0), particle, 0), T(0), T(0), T(0)};
  }

  // The state of the flaws of a particle after a time step at this strain. Cracks grow while the
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
  // Lets every crack grow by `more`, in units of R.
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
