// SPDX-License-Identifier: Apache-2.0
#include "verify/signal.hpp"

#include <fmt/format.h>

namespace kerf {

namespace {

std::size_t probe_index(const Case& description, const Parameters& parameters) {
  const std::string name = parameters.text("probe");
  for (std::size_t i = 0; i < description.probes.size(); ++i)
    if (description.probes[i].name == name) return i;
  parameters.fail(fmt::format("there is no probe \"{}\"", name));
}

// Where the values of a probe begin among those of all.
std::size_t first_value(const Case& description, std::size_t probe) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < probe; ++i)
    first += description.probes[i].kind == Probe::Kind::point ? 4 : 3;
  return first;
}

template <class Of>
using Fields = std::map<std::string, std::function<double(const Of&)>>;

template <class Of>
std::function<double(const Of&)> field_of(const Fields<Of>& fields, const Parameters& parameters) {
  const auto found = fields.find(parameters.text("field"));
  if (found == fields.end())
    parameters.fail(fmt::format("there is no field \"{}\"", parameters.text("field")));
  return found->second;
}

}  // namespace

std::size_t named_body(const Parameters& parameters, const Beginning& beginning,
                       const std::string& key) {
  const std::string name = parameters.text(key);
  const auto& bodies = beginning.description.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].name == name) return b;
  parameters.fail(fmt::format("there is no body \"{}\"", name));
}

std::size_t named_axis(const Parameters& parameters) {
  const std::string axis = parameters.text("axis");
  if (axis != "x" && axis != "y" && axis != "z") parameters.fail("axis is x, y or z");
  return static_cast<std::size_t>(axis[0] - 'x');
}

Signal probe_signal(const Parameters& parameters, const Beginning& beginning) {
  static const std::map<std::string, std::size_t> of_point{{"pressure", 0}, {"x", 1}, {"y", 2}};
  static const std::map<std::string, std::size_t> of_plane{{"x", 0}, {"y", 1}, {"z", 2}};
  const std::size_t probe = probe_index(beginning.description, parameters);
  const bool is_point = beginning.description.probes[probe].kind == Probe::Kind::point;
  const auto& components = is_point ? of_point : of_plane;
  const auto component = components.find(parameters.text("component"));
  if (component == components.end()) parameters.fail("the probe has no such component");
  const std::size_t value = first_value(beginning.description, probe) + component->second;
  return [value](Moment& moment) { return moment.probe_values()[value]; };
}

Signal ledger_signal(const Parameters& parameters, const Beginning&) {
  static const Fields<Ledger> fields{
      {"mass_error", [](const Ledger& l) { return l.mass_error(); }},
      {"momentum_error", [](const Ledger& l) { return l.momentum_error(); }},
      {"energy_drift", [](const Ledger& l) { return l.energy_drift(); }},
      {"mass_out", [](const Ledger& l) { return l.mass_out; }},
      {"kinetic", [](const Ledger& l) { return l.kinetic; }},
      {"elastic",
       [](const Ledger& l) { return l.elastic_deviatoric + l.stored_solid + l.elastic_strain; }},
      {"elastic_strain", [](const Ledger& l) { return l.elastic_strain; }},
      {"hourglass", [](const Ledger& l) { return l.hourglass; }},
      {"plastic", [](const Ledger& l) { return l.dissipated_plastic; }},
      {"fracture", [](const Ledger& l) { return l.dissipated_fracture; }},
      {"dissipated", [](const Ledger& l) { return l.dissipated_artificial; }},
      {"plate_force", [](const Ledger& l) { return l.force_plate[1]; }},
      // Speed at which the whole comes back over that at which it came, along y.
      {"plate_impulse", [](const Ledger& l) { return l.impulse_plate[1]; }}};
  const auto field = field_of(fields, parameters);
  return [field](Moment& moment) { return field(moment.ledger()); };
}

Signal cut_signal(const Parameters& parameters, const Beginning& beginning) {
  static const Fields<CutState> fields{
      {"front_depth", [](const CutState& s) { return s.front_depth; }},
      {"pieces", [](const CutState& s) { return static_cast<double>(s.pieces); }},
      {"fractured_fraction", [](const CutState& s) { return s.fractured_fraction; }},
      {"fractured_width", [](const CutState& s) { return s.fractured_width; }},
      {"kerf_width", [](const CutState& s) { return s.kerf_width; }},
      {"cut_through", [](const CutState& s) { return s.cut_through ? 1.0 : 0.0; }}};
  const double scale = parameters.text("per", "") == "jet width"
                           ? 1.0 / beginning.description.jets.at(0).width
                           : 1.0;
  if (parameters.text("field") == "front_speed")
    return [](Moment& moment) { return moment.cut_summary().front_speed; };
  const auto field = field_of(fields, parameters);
  return [field, scale](Moment& moment) { return scale * field(moment.cut()); };
}

const std::map<std::string, SignalMaker>& signal_makers() {
  static const std::map<std::string, SignalMaker> makers{
      {"probe", probe_signal},
      {"ledger", ledger_signal},
      {"cut", cut_signal},
      {"body_mean", body_mean_signal},
      {"kinetic_centroid", kinetic_centroid_signal},
      {"profile_error", profile_error_signal},
      {"extent", extent_signal},
      {"jet_tip", jet_tip_signal},
      {"deepest_water", deepest_water_signal},
      {"forward_share", forward_share_signal},
      {"region_volume", region_volume_signal},
      {"region_velocity", region_velocity_signal},
      {"asymmetry", asymmetry_signal},
      {"jet_split", jet_split_signal},
      {"fractured_below_jet", fractured_below_jet_signal},
      {"largest_stretch", largest_stretch_signal},
      {"hourglass_share", hourglass_share_signal},
      {"largest_damage", largest_damage_signal},
      {"crack", crack_signal}};
  return makers;
}

Signal make_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto maker = signal_makers().find(parameters.text("signal"));
  if (maker == signal_makers().end())
    parameters.fail(fmt::format("there is no signal \"{}\"", parameters.text("signal")));
  return maker->second(parameters, beginning);
}

}  // namespace kerf
