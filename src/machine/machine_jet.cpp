// SPDX-License-Identifier: Apache-2.0
#include "machine/machine_jet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/jet_direction.hpp"
#include "geometry/point_vectors.hpp"
#include "machine/characteristic_speed.hpp"
#include "machine/contraction.hpp"
#include "machine/jet_breakup.hpp"
#include "machine/jet_speed.hpp"
#include "model/jet.hpp"
#include "model/machine.hpp"
#include "model/material.hpp"

namespace kerf {

namespace {

// The simulated flight has this many diameters, because the jet is uniform further upstream, or
// what a grazing jet needs.
constexpr double simulated_flight = 2.0;

bool is_flat(const Machine& machine) {
  return machine.orifice_type == OrificeType::slit || machine.orifice_type == OrificeType::fan;
}

double contraction_of(const Machine& machine) {
  return machine.discharge_coefficient / machine.velocity_coefficient;
}

// Returns the length of the sheet at the workpiece, m: that of the orifice and the spread of a fan.
double sheet_length(const Machine& machine) {
  const double opening = machine.orifice_type == OrificeType::fan
                             ? 2.0 * machine.standoff * std::tan(0.5 * machine.fan_angle)
                             : 0.0;
  return machine.orifice_length + opening;
}

// Returns the direction of the jet: downwards, inclined by the angles along the traverse and to its
// right. In 2D the sign of the angle determines the side.
void aim(const Machine& machine, int dimension, Jet& jet) {
  const Point& forward = machine.traverse_direction;
  const double ahead = std::tan(machine.lead_angle), aside = std::tan(machine.tilt_angle);
  // Right of the traverse, seen from above: forward x up.
  const double x = ahead * forward[0] - aside * forward[2];
  const double z = ahead * forward[2] + aside * forward[0];
  if (dimension == 2) {
    jet.angle = std::atan(x);
    return;
  }
  jet.angle = std::atan(std::hypot(x, z));
  jet.azimuth = jet.angle > 0.0 ? std::atan2(z, x) : 0.0;
}

// Lays the long side of a sheet at right angles to the traverse and to the jet.
void lay_sheet(const Machine& machine, Jet& jet) {
  jet.length = sheet_length(machine);
  const Point aside = cross(jet_direction(jet), machine.traverse_direction);
  const double sine = std::sqrt(dot(aside, aside));
  for (std::size_t a = 0; a < 3; ++a) jet.slot[a] = aside[a] / sine;
}

// Returns the flight that is simulated, m; the lower end of a sheet that is tilted has as much of
// it as the middle of an upright one.
double flight_of(const Machine& machine, const Jet& jet) {
  const double lowered = 0.5 * jet.length * std::abs(jet.slot[1]) / std::cos(jet.angle);
  const double flight = std::max(simulated_flight * jet.width, least_flight(jet));
  return std::min(machine.standoff, flight + lowered);
}

JetAtWorkpiece arriving_jet(const Machine& machine, const MachineNumbers& numbers, int dimension) {
  return jet_after({numbers.diameter, numbers.speed, dimension == 2}, machine.standoff,
                   machine.coherent_length);
}

void pulse(const Machine& machine, const JetAtWorkpiece& arriving, Jet& jet) {
  jet.duty = machine.duty * arriving.water_share;
  jet.pulse_frequency =
      machine.pulse_frequency > 0.0 ? machine.pulse_frequency : arriving.pulse_frequency;
  if (jet.duty == 1.0) jet.pulse_frequency = 0.0;
}

}  // namespace

double standard_contraction(const Machine& machine) {
  return contraction(machine.orifice_type == OrificeType::conical ? machine.cone_angle
                                                                  : 0.5 * std::numbers::pi);
}

MachineNumbers machine_numbers(const Machine& machine, const Material& water, int dimension) {
  const double hugoniot_slope = real_water_hugoniot_slope;
  MachineNumbers numbers;
  numbers.speed = machine.velocity_coefficient * jet_speed(machine.pressure, water.density);
  numbers.contraction = contraction_of(machine);
  const bool flat = dimension == 2 || is_flat(machine);
  const double width = machine.orifice_diameter;
  numbers.diameter = width * (flat ? numbers.contraction : std::sqrt(numbers.contraction));
  const double section = flat ? numbers.diameter * (dimension == 2 ? 1.0 : machine.orifice_length)
                              : std::numbers::pi / 4.0 * numbers.diameter * numbers.diameter;
  numbers.flow_rate = section * numbers.speed;
  numbers.stagnation_pressure = 0.5 * water.density * numbers.speed * numbers.speed;
  numbers.power = numbers.stagnation_pressure * numbers.flow_rate;
  numbers.hammer_pressure =
      water.density * (real_water_sound_speed + hugoniot_slope * numbers.speed) * numbers.speed;
  const JetAtWorkpiece arriving = arriving_jet(machine, numbers, dimension);
  numbers.diameter_at_workpiece = arriving.diameter;
  numbers.water_share_at_workpiece = arriving.water_share;
  if (flat && dimension == 3)  // the thickness of a sheet decreases as its length increases
    numbers.diameter_at_workpiece *= machine.orifice_length / sheet_length(machine);
  return numbers;
}

double least_flight(const Jet& jet) {
  constexpr double clear = 1.0;  // diameters of flight of the lower edge
  return (0.5 * std::abs(std::tan(jet.angle)) + clear) * jet.width;
}

Jet machine_jet(const Machine& machine, const Material& water, int dimension) {
  const MachineNumbers numbers = machine_numbers(machine, water, dimension);
  Jet jet;
  jet.name = machine_jet_name;
  jet.material = machine.material;
  jet.speed = numbers.speed;
  jet.width = numbers.diameter_at_workpiece;
  jet.position = machine.position;
  aim(machine, dimension, jet);
  if (dimension == 3 && is_flat(machine)) lay_sheet(machine, jet);
  jet.standoff = flight_of(machine, jet);
  jet.spacing = machine.spacing;
  jet.stop = std::numeric_limits<double>::infinity();
  if (machine.motion != NozzleMotion::standing)
    for (std::size_t a = 0; a < 3; ++a)
      jet.traverse[a] = machine.traverse_speed * machine.traverse_direction[a];
  jet.dwell = machine.dwell;
  pulse(machine, arriving_jet(machine, numbers, dimension), jet);
  return jet;
}

}  // namespace kerf
