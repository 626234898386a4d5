// SPDX-License-Identifier: Apache-2.0
#include "output/kerf_result.hpp"

#include "case/machine_fields.hpp"
#include "machine/machine_jet.hpp"
#include "materials/laws.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

// What is no number leaves as null by itself.
Json level_json(const KerfLevel& level) {
  return {{"below", level.below}, {"width", level.width}};
}

Json fragments_json(const FragmentSizes& sizes) {
  return {{"count", sizes.count}, {"total_mass", sizes.total_mass}, {"largest", sizes.largest_mass},
          {"mass", sizes.mass},   {"diameter", sizes.diameter},     {"speed", sizes.speed}};
}

}  // namespace

Json shape_json(const KerfShape& shape) {
  Json json{{"thickness", shape.thickness},
            {"depth", shape.depth},
            {"through", shape.through},
            {"through_share", shape.through_share},
            {"top", level_json(shape.top)},
            {"middle", level_json(shape.middle)},
            {"bottom", level_json(shape.bottom)},
            {"taper", shape.taper},
            {"lag", shape.lag}};
  Json positions = Json::array(), depths = Json::array();
  for (const ProfilePoint& point : shape.profile) {
    positions.push_back(point.position);
    depths.push_back(point.depth);
  }
  json["profile"] = {{"position", std::move(positions)}, {"depth", std::move(depths)}};
  return json;
}

Json kerf_json(const Kerf& kerf, const Case& description) {
  Json json = shape_json(kerf.shape);
  json["damaged_zone"] = kerf.damaged_zone;
  json["removed_volume"] = kerf.removal.volume;
  json["removal_rate"] = kerf.removal.rate;
  json["specific_energy"] = kerf.removal.specific_energy;
  json["margin"] = kerf.margin;
  json["splash"] = {
      {"mass", kerf.splash.mass}, {"angle", kerf.splash.angle}, {"spread", kerf.splash.spread}};
  json["leaked_mass"] = kerf.leak.mass;
  json["small_fragments"] = fragments_json(kerf.fragments);
  json["layers"] = Json::array();
  for (const KerfLayer& layer : kerf.layers) {
    const Body& body = description.bodies.at(static_cast<std::size_t>(layer.body));
    Json entry{{"name", body.name}, {"top", layer.top}};
    entry.update(shape_json(layer.shape));
    entry["volume"] = layer.volume;
    entry["removed_volume"] = layer.removed_volume;
    entry["removed_fraction"] = layer.volume > 0.0 ? layer.removed_volume / layer.volume : 0.0;
    json["layers"].push_back(std::move(entry));
  }
  return json;
}

Json machine_json(const Machine& machine, const Case& description) {
  const auto& water = description.materials.at(static_cast<std::size_t>(machine.material));
  const MachineNumbers numbers = machine_numbers(machine, water, description.dimension);
  Json json{{"orifice_type", word_of(machine.orifice_type, orifice_words)}};
  for (const MachineField& field : machine_fields(machine, description.dimension))
    json[std::string(field.key)] = machine.*field.member;
  json["jet_speed"] = numbers.speed;
  json["contraction"] = numbers.contraction;
  json["jet_width"] = numbers.diameter;
  json["flow_rate"] = numbers.flow_rate;
  json["power"] = numbers.power;
  json["stagnation_pressure"] = numbers.stagnation_pressure;
  json["hammer_pressure"] = numbers.hammer_pressure;
  json["width_at_workpiece"] = numbers.diameter_at_workpiece;
  json["water_share_at_workpiece"] = numbers.water_share_at_workpiece;
  return json;
}

}  // namespace kerf
