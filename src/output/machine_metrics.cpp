// SPDX-License-Identifier: Apache-2.0
#include "output/machine_metrics.hpp"

#include <fmt/format.h>

#include <set>
#include <string>

#include "core/error.hpp"
#include "input/schema.hpp"
#include "machine/machine_jet.hpp"
#include "materials/laws.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

using MachineList = MetricList<MachineRecord>;

// The settings that are numbers; their units and meanings are those of the keys of a case file.
constexpr std::pair<const char*, const char*> labels[] = {
    {"pressure", "pressure at the orifice"},
    {"orifice_diameter", "diameter of the orifice"},
    {"orifice_length", "length of the orifice"},
    {"cone_angle", "angle of the cone"},
    {"fan_angle", "angle of the fan"},
    {"velocity_coefficient", "velocity coefficient"},
    {"discharge_coefficient", "discharge coefficient"},
    {"standoff", "standoff"},
    {"coherent_length", "coherent length"},
    {"lead_angle", "lead angle"},
    {"tilt_angle", "tilt angle"},
    {"traverse_speed", "traverse speed"},
    {"dwell", "dwell"},
    {"pulse_frequency", "pulse frequency"},
    {"duty", "duty"},
    {"spacing", "spacing of the water"},
};

std::optional<double> setting_number(const MachineRecord& record, std::string_view key) {
  const Machine& machine = *record.description.machine;
  const std::set<std::string> conditions{record.description.dimension == 2 ? "2D" : "3D"};
  for (const NamedNumber& number : numbers_in("machine", machine, conditions))
    if (number.name == key) return number.value;
  return std::nullopt;
}

MachineNumbers numbers_of(const MachineRecord& record) {
  const Machine& machine = *record.description.machine;
  const auto& water = record.description.materials.at(static_cast<std::size_t>(machine.material));
  return machine_numbers(machine, water, record.description.dimension);
}

auto number(double MachineNumbers::*member) {
  return [member](const MachineRecord& record) { return numbers_of(record).*member; };
}

}  // namespace

const MachineList& MachineRecord::setting() {
  static const MachineList list = [] {
    MachineList all{{"orifice_type", "1", "type of the orifice",
                     "`sharp`, `conical`, `slit` or `fan`.", [](const MachineRecord& record) {
                       return word_of(record.description.machine->orifice_type, orifice_words);
                     }}};
    for (const auto& [name, label] : labels) {
      const Key* key = find_key("machine", name, {});
      require(key != nullptr, "a number of the machine is a key of the case");
      const std::string unit(key->unit.empty() ? "1" : key->unit);
      all.push_back(
          {name, unit.c_str(), label, fmt::format("{}.", key->sentence).c_str(),
           [key = name](const MachineRecord& record) { return setting_number(record, key); }});
    }
    return all;
  }();
  return list;
}

const MachineList& MachineRecord::jet() {
  using M = MachineNumbers;
  static const MachineList list{
      {"jet_speed", "m/s", "speed of the jet", "Speed of the jet behind the orifice.",
       number(&M::speed)},
      {"contraction", "1", "contraction, jet over orifice",
       "Cross-section of the jet over that of the orifice.", number(&M::contraction)},
      {"jet_width", "m", "width of the jet", "Diameter of the jet; of a flat jet, its thickness.",
       number(&M::diameter)},
      {"flow_rate", extensive("m3/s"), "flow rate",
       "Volume of water per time; of a pulsed jet while its water flows.", number(&M::flow_rate)},
      {"power", extensive("W"), "power of the jet",
       "Kinetic energy of the jet per time; of a pulsed jet while its water flows.",
       number(&M::power)},
      {"stagnation_pressure", "Pa", "stagnation pressure",
       "Half the density of the water times the square of the jet's speed.",
       number(&M::stagnation_pressure)},
      {"hammer_pressure", "Pa", "hammer pressure of real water",
       "Pressure of the first instant of contact, with the shock speed of real water.",
       number(&M::hammer_pressure)},
      {"width_at_workpiece", "m", "width at the workpiece",
       "Width of the jet at the workpiece, by a model of the air.",
       number(&M::diameter_at_workpiece)},
      {"water_share_at_workpiece", share(), "share of water at the workpiece",
       "Share of water in the jet at the workpiece, by a model of the air.",
       number(&M::water_share_at_workpiece)}};
  return list;
}

}  // namespace kerf
