// SPDX-License-Identifier: Apache-2.0
#include "output/balance_metrics.hpp"

namespace kerf {
namespace {

using B = Balance;
using BalanceList = MetricList<Balance>;

const MetricUnit mass = extensive("kg"), momentum = extensive("N s"), force = extensive("N"),
                 energy = extensive("J");

BalanceList mass_terms() {
  return {
      {"mass_initial", mass, "mass at the start", "Mass of all particles at the start.",
       &B::mass_initial},
      {"mass_in", mass, "mass from the nozzles", "Mass that entered at the nozzles.", &B::mass_in},
      {"mass_out", mass, "mass that left", "Mass that left the domain.", &B::mass_out},
      {"mass_erased", mass, "mass taken by the back-flow removal",
       "Mass that the back-flow removal took.", &B::mass_erased},
      {"mass_fed", mass, "mass fed in ahead of the nozzle",
       "Mass of the solid that entered ahead of a travelling frame.", &B::mass_fed},
      {"mass_left", mass, "mass left behind the nozzle",
       "Mass of the solid that a travelling frame left behind.", &B::mass_left},
      {"mass_now", mass, "present mass", "Mass of the particles present.", &B::mass_now},
      {"mass_fractured", mass, "present fractured mass", "Mass of the fractured solid present.",
       &B::mass_fractured},
      {"jet_mass_due", mass, "mass due from the jets", "Integral of ρVA over time since the start.",
       &B::jet_mass_due},
      {"jet_mass_carried", mass, "mass not yet a layer",
       "Part of the mass due that does not yet fill a layer of particles.", &B::jet_mass_carried},
      {"jet_mass_held_back", mass, "mass held back by pressure at the nozzles",
       "Mass that would be due besides if no pressure at the exits slowed the jets.",
       &B::jet_mass_held_back},
  };
}

BalanceList momentum_terms() {
  return {
      {"momentum_initial", momentum, "momentum at the start",
       "Momentum of all particles at the start.", &B::momentum_initial},
      {"momentum_now", momentum, "momentum of the particles", "Momentum of the particles present.",
       &B::momentum_now},
      {"momentum_in", momentum, "momentum from the jets", "Momentum that entered with the jets.",
       &B::momentum_in},
      {"momentum_out", momentum, "momentum that left",
       "Momentum of the outflow particles and of the water that the back-flow removal took.",
       &B::momentum_out},
      {"momentum_left", momentum, "momentum left behind the nozzle",
       "Momentum of the solid that a travelling frame left behind.", &B::momentum_left},
      {"impulse_gravity", momentum, "impulse of gravity", "Impulse of gravity on the particles.",
       &B::impulse_gravity},
      {"impulse_rigid", momentum, "impulse of rigid bodies",
       "Impulse of the rigid bodies on the particles.", &B::impulse_rigid},
      {"impulse_constraint", momentum, "impulse of nozzles and clamps",
       "Impulse of nozzles, clamps, prescribed motion and symmetry planes on the particles.",
       &B::impulse_constraint},
      {"impulse_load", momentum, "impulse of the loads", "Impulse of given loads on the solids.",
       &B::impulse_load},
      {"impulse_water", momentum, "impulse of the water",
       "Impulse of the water on the solids that are not rigid, debris included.",
       &B::impulse_water},
      {"force_rigid", force, "force on rigid bodies",
       "Force of the particles on the rigid bodies in the last step.", &B::force_rigid},
      {"force_water", force, "force of the water",
       "Force of the water on the solids that are not rigid in the last step, debris included.",
       &B::force_water},
      {"momentum_scale", momentum, "scale of the momentum",
       "Sum of the magnitudes of the particles' momenta.", &B::momentum_scale},
  };
}

BalanceList flow_of_energy() {
  return {
      {"energy_initial", energy, "energy at the start", "Kinetic and stored energy at the start.",
       &B::energy_initial},
      {"energy_in", energy, "energy from the jets", "Energy that entered with the jets.",
       &B::energy_in},
      {"energy_out", energy, "energy that left",
       "Energy of the outflow particles and of the water that the back-flow removal took.",
       &B::energy_out},
      {"energy_left", energy, "energy left behind the nozzle",
       "Energy of the solid that a travelling frame left behind, with what its neighbours lost.",
       &B::energy_left},
      {"work_gravity", energy, "work of gravity", "Work of gravity on the particles.",
       &B::work_gravity},
      {"work_constraint", energy, "work of nozzles and clamps",
       "Work of nozzles, clamps and prescribed motion.", &B::work_constraint},
      {"work_load", energy, "work of the loads", "Work of given loads on the solids.",
       &B::work_load},
  };
}

BalanceList kinds_of_energy() {
  return {
      {"kinetic", energy, "kinetic energy", "Kinetic energy of the particles.", &B::kinetic},
      {"pressure_work", energy, "work against pressure",
       "Work done against the pressure forces since the start; in the standard formulation without "
       "what the densities do not store of it.",
       &B::pressure_work},
      {"elastic_deviatoric", energy, "elastic energy of shape",
       "Energy stored in the solids by change of shape.", &B::elastic_deviatoric},
      {"elastic_strain", energy, "elastic energy, total Lagrangian",
       "Energy stored in the total Lagrangian solids.", &B::elastic_strain},
      {"hourglass", energy, "energy of the hourglass control",
       "Energy stored by the hourglass control of the total Lagrangian solids.", &B::hourglass},
      {"rigid_potential", energy, "energy of the plate repulsion",
       "Energy stored in the repulsion of rigid bodies.", &B::rigid_potential},
      {"dissipated_artificial", energy, "lost to artificial viscosity",
       "Energy that the artificial viscosity dissipated.", &B::dissipated_artificial},
      {"dissipated_viscous", energy, "lost to the water's viscosity",
       "Energy that the viscosity of the water dissipated.", &B::dissipated_viscous},
      {"dissipated_fracture", energy, "lost to fracture", "Energy that fracture dissipated.",
       &B::dissipated_fracture},
      {"dissipated_plastic", energy, "lost to plastic flow", "Energy that plastic flow dissipated.",
       &B::dissipated_plastic},
      {"dissipated_density", energy, "lost by the continuity equation",
       "Work against pressure that the densities do not store, because the continuity equation "
       "smooths them.",
       &B::dissipated_density},
      {"dissipated_reinitialisation", energy, "lost to density reinitialisation",
       "Energy that density reinitialisation takes out of the densities.",
       &B::dissipated_reinitialisation},
      {"dissipated_damping", energy, "lost to relaxation",
       "Kinetic energy of solids that relaxation took.", &B::dissipated_damping},
      {"damping_peak", energy, "last peak of relaxation",
       "Kinetic energy of solids at its last peak in the relaxation.", &B::damping_peak},
      {"stored_water", energy, "energy stored in the water",
       "Part of the pressure work that the densities of the water can give back.",
       &B::stored_water},
      {"stored_solid", energy, "energy stored in the solids' volume",
       "Part of the pressure work that the densities of the solids can give back.",
       &B::stored_solid},
  };
}

}  // namespace

const BalanceList& balance_terms() {
  static const BalanceList terms = [] {
    BalanceList all = mass_terms();
    for (const BalanceList& part : {momentum_terms(), flow_of_energy(), kinds_of_energy()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return terms;
}

const BalanceList& balance_errors() {
  static const BalanceList errors{
      {"mass_error", share(), "mass unaccounted for",
       "Mass that the balance misses over all mass that was ever there.", &B::mass_error},
      {"momentum_error", share(), "momentum unaccounted for",
       "Momentum that the balance misses over its largest term.", &B::momentum_error},
      {"pressure_energy_gap", share(), "gap between stored energy and pressure work",
       "Energy stored by the equations of state less the pressure work, over all energy that came "
       "in.",
       &B::pressure_energy_gap},
      {"energy_drift", share(), "energy unaccounted for",
       "Energy that the balance misses over all energy that ever came in.", &B::energy_drift}};
  return errors;
}

}  // namespace kerf
