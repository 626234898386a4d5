// SPDX-License-Identifier: Apache-2.0
// The metrics of a case that are known before it runs.
#include "analysis/derived.hpp"

namespace kerf {

const MetricList<DerivedNumbers>& DerivedNumbers::metrics() {
  using D = DerivedNumbers;
  static const MetricList<D> list{
      {"V_over_cR", "1", "V / c_R", "Speed of the jet over the Rayleigh wave speed of the solid.",
       &D::speed_over_rayleigh},
      {"V_over_cp", "1", "V / c_p", "Speed of the jet over the pressure wave speed of the solid.",
       &D::speed_over_longitudinal},
      {"cauchy_number", "1", "Cauchy number, ρV²/E",
       "Density of the water times the square of the jet's speed over the solid's Young's modulus.",
       &D::cauchy_number},
      {"regime", "1", "regime",
       "Regime of the cut that the pressure of the jet, the resistance of the solid and the speeds "
       "of waves suggest: `no jet`, `nothing to cut`, `elastic dimple`, `crack-led`, `erosion` or "
       "`hydrodynamic`.",
       &D::regime},
      {"jet_speed", "m/s", "speed of the jet, V",
       "Speed of the fastest water of a jet, on the axis of one with a profile, or, without a jet, "
       "of the fastest body at the start.",
       &D::jet_speed},
      {"jet_resolution", "1", "particles across the jet",
       "Width of the jet over the spacing of its particles, for the coarsest jet.",
       &D::jet_resolution},
      {"mach", "1", "Mach number in the water", "Speed of the jet over the water's sound speed.",
       &D::mach},
      {"solid_to_water_spacing", "1", "spacing of the solid over that of the water",
       "Largest spacing of the solids over the smallest spacing of the water.",
       &D::solid_to_water_spacing},
      {"rayleigh_speed", "m/s", "Rayleigh wave speed, c_R", "Speed of Rayleigh waves on the solid.",
       &D::rayleigh_speed},
      {"shear_speed", "m/s", "shear wave speed, c_s", "Speed of shear waves in the solid.",
       &D::shear_speed},
      {"longitudinal_speed", "m/s", "pressure wave speed, c_p",
       "Speed of pressure waves in the solid.", &D::longitudinal_speed},
      {"stagnation_pressure", "Pa", "stagnation pressure, ρV²/2",
       "Half the density of the water times the square of the jet's speed.",
       &D::stagnation_pressure},
      {"resistance", "Pa", "resistance of the solid",
       "Least stress at which the solid gives way: by its limits of strain, tension and flow, or "
       "5/2 of its shear modulus.",
       &D::resistance},
      {"hydrodynamic_front_speed", "m/s", "front speed of two streams, V / (1 + √(ρ_s/ρ_w))",
       "Speed of the front in a solid without strength.", &D::hydrodynamic_front_speed}};
  return list;
}

}  // namespace kerf
