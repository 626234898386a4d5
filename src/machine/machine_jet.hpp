// SPDX-License-Identifier: Apache-2.0
// The jet of a machine, at its orifice and at the workpiece.
#pragma once

namespace kerf {

struct Jet;
struct Machine;
struct Material;

// The properties of a jet that follow from the machine settings without a simulation.
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

// Returns the default coefficients of a machine.
double standard_contraction(const Machine& machine);
inline constexpr double standard_velocity_coefficient = 0.98;

MachineNumbers machine_numbers(const Machine& machine, const Material& water, int dimension);

// Returns the flight (m, of the axis) of a jet whose lower edge has a diameter of flight before it:
// the edge of a jet that leans meets the face before the axis does.
double least_flight(const Jet& jet);

// Name of the jet that a machine makes.
inline constexpr const char* machine_jet_name = "machine";
// Returns the simulated jet: it starts close above the workpiece, with the breakup by the air.
Jet machine_jet(const Machine& machine, const Material& water, int dimension);

}  // namespace kerf
