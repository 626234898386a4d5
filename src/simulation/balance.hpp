// SPDX-License-Identifier: Apache-2.0
// The balance of mass, momentum and energy of a run, which measures its errors. All sums are in
// double precision and in a fixed order; the equations are in balance.cpp. In 2D every quantity is
// per metre of depth. The sums over particles are in simulation/balance_sums.hpp;
// balance_accumulator.hpp adds up the steps; the energy that solids store is in
// solid/stored_energy.hpp, their losses come from standard/solid_part.hpp. `rigid` in a name stands
// for the rigid bodies, and equations are those of Shinohara et al. (2004).
#pragma once

#include <array>

#include "core/public_symbol.hpp"

namespace kerf {

struct KERF_PUBLIC Balance {
  // Mass, kg.
  double mass_initial = 0.0;
  double mass_in = 0.0;      // created at the nozzles
  double mass_out = 0.0;     // left the domain
  double mass_erased = 0.0;  // removed by the back-flow removal
  double mass_fed = 0.0;     // of solid that entered ahead of a travelling frame
  double mass_left = 0.0;    // of solid that such a frame left behind
  double mass_now = 0.0;     // sum over the particles
  double mass_fractured = 0.0;
  double jet_mass_due = 0.0;        // integral of rho V A since the start
  double jet_mass_carried = 0.0;    // the part below a full layer: due = in + carried
  double jet_mass_held_back = 0.0;  // more would be due without pressure at the exits

  // Momentum, kg m/s.
  std::array<double, 3> momentum_initial{};
  std::array<double, 3> momentum_now{};
  std::array<double, 3> momentum_in{};
  std::array<double, 3> momentum_out{};   // with the outflow
  std::array<double, 3> momentum_left{};  // with the solid that a travelling frame left behind
  std::array<double, 3> impulse_gravity{};
  std::array<double, 3> impulse_rigid{};       // of rigid bodies on the particles
  std::array<double, 3> impulse_constraint{};  // of nozzles, clamps, motion and symmetry planes
  std::array<double, 3> impulse_load{};        // of given loads on the solids
  std::array<double, 3> impulse_water{};       // of the water on the solids
  std::array<double, 3> force_rigid{};         // N, of the particles on the rigid bodies, last step
  std::array<double, 3> force_water{};         // N, of the water on the solids, last step
  double momentum_scale = 0.0;    // kg m/s, sum of m |v| now: a scale where momenta cancel
  double load_scale = 0.0;        // kg m/s, impulse of the loads by their magnitudes, likewise
  double constraint_scale = 0.0;  // kg m/s, impulses of rigid bodies and constraints, likewise

  // Energy, J.
  double energy_initial = 0.0;  // kinetic + stored at t = 0
  double energy_in = 0.0;
  double energy_out = 0.0;
  double energy_left = 0.0;  // with the solid that a travelling frame left behind
  double work_gravity = 0.0;
  double work_constraint = 0.0;
  double work_load = 0.0;
  double kinetic = 0.0;        // now
  double pressure_work = 0.0;  // done against the pressure forces of eq. (26) so far
  double elastic_deviatoric = 0.0;
  double elastic_strain = 0.0;  // all of it in total Lagrangian solids, now
  double hourglass = 0.0;       // in their hourglass control, now
  double rigid_potential = 0.0;
  double dissipated_artificial = 0.0;  // integrated
  double dissipated_viscous = 0.0;
  double dissipated_fracture = 0.0;
  double dissipated_plastic = 0.0;  // by the flow of total Lagrangian solids
  // What densities do not store of the work against pressure: by the continuity equation, and by
  // density reinitialisation. `pressure_work` is without them.
  double dissipated_density = 0.0;
  double dissipated_reinitialisation = 0.0;
  double dissipated_damping = 0.0;  // by the relaxation of solids to rest
  double damping_peak = 0.0;        // the last peak of their kinetic energy in it
  // The energy that the equations of state store at the densities of eq. (22). Where densities
  // differ much (water beside fractured solid), eqs. (22) and (26) do not derive from the same
  // energy, and this departs from the pressure work: see docs/theory/balance.md.
  double stored_water = 0.0;
  double stored_solid = 0.0;

  double mass_error() const;       // relative to all mass that was ever there
  double momentum_error() const;   // relative to the largest term, also by magnitudes
  double energy_drift() const;     // relative to the energy supplied
  double energy_total() const;     // now, stored + dissipated
  double energy_supplied() const;  // at the start, with the inflow and by positive work
  double solid_energy() const;     // stored by total Lagrangian solids now, hourglass control too
  // Whether the energy can be that of the motion: what is stored and dissipated is a number and
  // differs from what was supplied by at most half of the larger one, or by no more than the energy
  // of all the mass at 1 mm/s, the noise of matter at rest. A run that breaks down gains many times
  // its energy before a value stops being a number.
  bool energy_is_sound() const;
  double energy_from_breaks() const;   // energy gained by fracture, likewise
  double density_loss() const;         // dissipated by density and reinitialisation, likewise
  double pressure_energy_gap() const;  // (stored - pressure work) / energy supplied
};

}  // namespace kerf
