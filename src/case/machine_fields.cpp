// SPDX-License-Identifier: Apache-2.0
#include "case/machine_fields.hpp"

#include "case/schema.hpp"
#include "materials/laws.hpp"

namespace kerf {

namespace {

constexpr MachineField all_fields[] = {
    {"pressure", &Machine::pressure},
    {"orifice_diameter", &Machine::orifice_diameter},
    {"orifice_length", &Machine::orifice_length},
    {"cone_angle", &Machine::cone_angle},
    {"fan_angle", &Machine::fan_angle},
    {"velocity_coefficient", &Machine::velocity_coefficient},
    {"discharge_coefficient", &Machine::discharge_coefficient},
    {"standoff", &Machine::standoff},
    {"coherent_length", &Machine::coherent_length},
    {"lead_angle", &Machine::lead_angle},
    {"tilt_angle", &Machine::tilt_angle},
    {"traverse_speed", &Machine::traverse_speed},
    {"dwell", &Machine::dwell},
    {"pulse_frequency", &Machine::pulse_frequency},
    {"duty", &Machine::duty},
    {"spacing", &Machine::spacing},
};

}  // namespace

std::set<std::string> machine_conditions(OrificeType type, int dimension) {
  return {std::string(word_of(type, orifice_words)), dimension == 2 ? "2D" : "3D"};
}

std::vector<MachineField> machine_fields(const Machine& machine, int dimension) {
  const auto conditions = machine_conditions(machine.orifice_type, dimension);
  std::vector<MachineField> fields;
  for (const MachineField& field : all_fields)
    if (find_key("machine", field.key, conditions)->applies_under(conditions))
      fields.push_back(field);
  return fields;
}

}  // namespace kerf
