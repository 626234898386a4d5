// SPDX-License-Identifier: Apache-2.0
// The jet of a machine: what leaves its orifice, and what of it reaches the workpiece.
#pragma once

#include "model/case.hpp"

namespace kerf {

// What follows from a machine's setting before anything is simulated.
struct MachineNumbers {
  double speed = 0.0;                  // m/s, of the jet
  double contraction = 1.0;            // 1, area of the jet over that of the orifice
  double diameter = 0.0;               // m, of the jet behind the orifice; of a slit, its thickness
  double flow_rate = 0.0;              // m^3/s (2D: m^2/s)
  double power = 0.0;                  // W (2D: W/m), of the jet
  double stagnation_pressure = 0.0;    // Pa, rho V^2 / 2
  double hammer_pressure = 0.0;        // Pa, rho (c_0 + s V) V of real water
  double diameter_at_workpiece = 0.0;  // m
  double water_share_at_workpiece = 1.0;  // 1
};

// The coefficients that hold where the case gives none.
double standard_contraction(const Machine& machine);
inline constexpr double standard_velocity_coefficient = 0.98;

MachineNumbers machine_numbers(const Machine& machine, const Material& water, int dimension);

// Name of the jet that a machine makes.
inline constexpr const char* machine_jet_name = "machine";
// The jet as it is simulated: from close above the workpiece, as the air left it.
Jet machine_jet(const Machine& machine, const Material& water, int dimension);

}  // namespace kerf
