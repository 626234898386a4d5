// SPDX-License-Identifier: Apache-2.0
#include "output/ledger_table.hpp"

namespace kerf {
namespace {

LedgerTerm number(const char* name, const char* unit, double Ledger::*place, const char* meaning) {
  return {name, unit, meaning, place, nullptr};
}

LedgerTerm vector(const char* name, const char* unit, std::array<double, 3> Ledger::*place,
                  const char* meaning) {
  return {name, unit, meaning, nullptr, place};
}

std::vector<LedgerTerm> mass_terms() {
  return {
      number("mass_initial", "kg", &Ledger::mass_initial, "at the start"),
      number("mass_in", "kg", &Ledger::mass_in, "made at the nozzles"),
      number("mass_out", "kg", &Ledger::mass_out, "left the domain"),
      number("mass_erased", "kg", &Ledger::mass_erased, "taken by the back-flow eraser"),
      number("mass_now", "kg", &Ledger::mass_now, "there now"),
      number("mass_fractured", "kg", &Ledger::mass_fractured, "fractured solid there now"),
      number("jet_mass_due", "kg", &Ledger::jet_mass_due, "ρVA since the start"),
      number("jet_mass_carried", "kg", &Ledger::jet_mass_carried, "of it not yet a whole layer"),
  };
}

std::vector<LedgerTerm> momentum_terms() {
  return {
      vector("momentum_initial", "N s", &Ledger::momentum_initial, "at the start"),
      vector("momentum_now", "N s", &Ledger::momentum_now, "of the particles now"),
      vector("momentum_in", "N s", &Ledger::momentum_in, "came with the jets"),
      vector("momentum_out", "N s", &Ledger::momentum_out, "left with leavers and erased water"),
      vector("impulse_gravity", "N s", &Ledger::impulse_gravity, "of gravity"),
      vector("impulse_plate", "N s", &Ledger::impulse_plate, "of rigid bodies on the particles"),
      vector("impulse_constraint", "N s", &Ledger::impulse_constraint,
             "of nozzles, clamps, prescribed motion and symmetry planes"),
      vector("impulse_water", "N s", &Ledger::impulse_water,
             "of the water on solids that are not rigid, debris too"),
      vector("force_plate", "N", &Ledger::force_plate, "of the particles on rigid bodies"),
      vector("force_water", "N", &Ledger::force_water, "of the water on solids"),
      number("momentum_scale", "N s", &Ledger::momentum_scale, "sum of m |v| now"),
  };
}

std::vector<LedgerTerm> energy_terms() {
  return {
      number("energy_initial", "J", &Ledger::energy_initial, "kinetic and stored at the start"),
      number("energy_in", "J", &Ledger::energy_in, "came with the jets"),
      number("energy_out", "J", &Ledger::energy_out, "left with leavers and erased water"),
      number("work_gravity", "J", &Ledger::work_gravity, "of gravity"),
      number("work_constraint", "J", &Ledger::work_constraint,
             "of nozzles, clamps and prescribed motion"),
      number("kinetic", "J", &Ledger::kinetic, "kinetic, now"),
      number("pressure_work", "J", &Ledger::pressure_work, "done against pressure so far"),
      number("elastic_deviatoric", "J", &Ledger::elastic_deviatoric,
             "stored in solids by change of shape, now"),
      number("elastic_strain", "J", &Ledger::elastic_strain,
             "stored in total Lagrangian solids, now"),
      number("hourglass", "J", &Ledger::hourglass, "stored in their hourglass control, now"),
      number("plate_potential", "J", &Ledger::plate_potential, "stored in the repulsion, now"),
      number("dissipated_artificial", "J", &Ledger::dissipated_artificial,
             "by artificial viscosity"),
      number("dissipated_viscous", "J", &Ledger::dissipated_viscous, "by the water's viscosity"),
      number("dissipated_fracture", "J", &Ledger::dissipated_fracture, "by fracture"),
      number("dissipated_plastic", "J", &Ledger::dissipated_plastic, "by plastic flow"),
      number("stored_water", "J", &Ledger::stored_water,
             "of the pressure work, what the water's densities can give back"),
      number("stored_solid", "J", &Ledger::stored_solid,
             "of the pressure work, what the solids' densities can give back"),
  };
}

}  // namespace

const std::vector<LedgerTerm>& ledger_terms() {
  static const std::vector<LedgerTerm> terms = [] {
    std::vector<LedgerTerm> all = mass_terms();
    for (const auto& part : {momentum_terms(), energy_terms()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return terms;
}

std::string extensive_unit(const std::string& unit, int dimension) {
  return dimension == 2 ? unit + "/m" : unit;
}

}  // namespace kerf
