// SPDX-License-Identifier: Apache-2.0
// The strength of rock and soil grows with pressure (Drucker & Prager, Q. Appl. Math. 10 (1952)
// 157), and tension has a cap. In q = sqrt(3/2 s : s) and the mean stress p, tension positive,
//   q + friction p <= strength,   p <= tension,
// with flow along q + dilation p on the cone and along p on the cap; both act where they meet,
// which is the apex if the cap lies there. The cone touches the pyramid of Mohr & Coulomb along
// the meridians of `ConeMatch` (de Souza Neto, Peric & Owen, Computational Methods for Plasticity
// (2008), 6.4.4); docs/theory/plasticity.md derives that of plane strain for any dilation.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "materials/law_arguments.hpp"
#include "materials/return_mapping.hpp"

namespace kerf {

enum class ConeMatch : std::uint8_t {
  compression,  // like a cylinder pressed along its axis: the outer cone
  extension,    // like a cylinder pressed from its side: the inner cone
  plane_strain  // collapse in plane strain, where the flow out of the plane is zero
};

template <class T>
struct DruckerPrager {
  T strength = 0;  // k, Pa
  T friction = 0;  // slopes of the cone and of its flow
  T dilation = 0;
  T tension = 0;  // Pa, no further out than the apex
  // The parameters of Mohr & Coulomb, from which those of the cone follow.
  T cohesion = 0;         // Pa
  T friction_angle = 0;   // rad
  T dilation_angle = 0;   // rad
  T tension_cut_off = 0;  // Pa; infinity = the apex of the cone

  static constexpr std::string_view sentence =
      "Rock and soil, whose strength grows with pressure: the cone of Drucker & Prager with a cap "
      "on tension";
  static constexpr bool is_metal = false;
  static constexpr bool depends_on_temperature = false;
  static std::vector<Key> rows() {
    using Law = DruckerPrager<double>;
    return {{"cohesion",
             ValueKind::quantity,
             "Pa",
             "",
             key_range::not_negative,
             {},
             "",
             "Cohesion of Mohr & Coulomb, which the cone is fitted to: in 2D at collapse in plane "
             "strain with the dilation_angle given, in 3D along the compressive meridian",
             stored_in<&Law::cohesion>},
            {"friction_angle",
             ValueKind::quantity,
             "rad",
             "",
             {0.0, 1.5, false, true},
             {},
             "",
             "Angle of internal friction",
             stored_in<&Law::friction_angle>},
            {"dilation_angle",
             ValueKind::quantity,
             "rad",
             "0 deg",
             {0.0, 1.5, false, true},
             {},
             "",
             "Angle of dilation",
             stored_in<&Law::dilation_angle>},
            {"tension_cut_off",
             ValueKind::quantity,
             "Pa",
             "none",
             key_range::not_negative,
             {},
             "",
             "Mean tension that it bears; none = the apex of the cone",
             stored_in<&Law::tension_cut_off>}};
  }
  void derive(const BodyNumbers& body) {
    const ConeMatch match = body.dimension == 2 ? ConeMatch::plane_strain : ConeMatch::compression;
    *this = of(cohesion, friction_angle, dilation_angle, tension_cut_off, match);
  }

  // Slope of the cone over the sine of the angle of friction. The flow decides by the sine of its
  // angle of dilation where the stress at collapse in plane strain lies. With both sines the same
  // it is the slope of the flow over the sine of the angle of dilation.
  KERF_FUNCTION static T steepness(T sine, T flow_sine, ConeMatch match) {
    switch (match) {
      case ConeMatch::compression:
        return T(6) / (T(3) - sine);
      case ConeMatch::extension:
        return T(6) / (T(3) + sine);
      case ConeMatch::plane_strain:
        return T(3) * std::sqrt(T(3) + flow_sine * flow_sine) / (T(3) + sine * flow_sine);
    }
    return T(0);
  }

  // The cone from cohesion and tension cut-off, Pa, and the angles of friction and dilation, rad,
  // below a right angle. A cut-off beyond the apex has no effect.
  KERF_FUNCTION static DruckerPrager of(T cohesion, T friction_angle, T dilation_angle, T cut_off,
                                        ConeMatch match) {
    DruckerPrager law{T(0), T(0), T(0), T(0), cohesion, friction_angle, dilation_angle, cut_off};
    const T sine = std::sin(friction_angle), flow_sine = std::sin(dilation_angle);
    const T slope = steepness(sine, flow_sine, match);
    law.friction = slope * sine;
    law.dilation = steepness(flow_sine, flow_sine, match) * flow_sine;
    law.strength = slope * cohesion * std::cos(friction_angle);
    law.tension = law.friction * cut_off < law.strength ? cut_off : law.strength / law.friction;
    return law;
  }

  KERF_FUNCTION T first_strength() const { return strength; }

  KERF_FUNCTION PlasticFlow<T> flow(const ElasticModuli<T>& solid,
                                    const MeridianStress<T>& trial) const {
    const T shear_modulus = T(3) * solid.shear_modulus, bulk_modulus = solid.bulk_modulus;
    const T excess = trial.equivalent + friction * trial.mean - strength;
    T shear = T(0), mean = trial.mean;
    if (excess > T(0)) {
      shear = excess / (shear_modulus + bulk_modulus * friction * dilation);
      mean -= bulk_modulus * dilation * shear;
    }
    if (!(mean > tension)) return {shear, dilation * shear};
    // The cap, and the cone too where what is left of q is too much at its edge.
    const T beyond = trial.equivalent - (strength - friction * tension);
    return {beyond > T(0) ? beyond / shear_modulus : T(0), (trial.mean - tension) / bulk_modulus};
  }

  template <class Other>
  KERF_FUNCTION static DruckerPrager from(const DruckerPrager<Other>& other) {
    return {static_cast<T>(other.strength), static_cast<T>(other.friction),
            static_cast<T>(other.dilation), static_cast<T>(other.tension)};
  }
  bool operator==(const DruckerPrager&) const = default;
};

}  // namespace kerf
