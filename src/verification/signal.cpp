// SPDX-License-Identifier: Apache-2.0
#include "verification/signal.hpp"

#include <fmt/format.h>

#include "analysis/exposure.hpp"
#include "model/case.hpp"
#include "output/balance_metrics.hpp"

namespace kerf {

namespace {

std::size_t probe_index(const Case& description, const Parameters& parameters) {
  const std::string name = parameters.text("probe");
  for (std::size_t i = 0; i < description.probes.size(); ++i)
    if (description.probes[i].name == name) return i;
  parameters.fail(fmt::format("there is no probe \"{}\"", name));
}

// Returns the index of the first value of a probe among those of all probes.
std::size_t first_value(const Case& description, std::size_t probe) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < probe; ++i) first += !description.probes[i].is_plane() ? 4 : 3;
  return first;
}

// Returns how to read a number of a record by the name of its metric; a component of a vector has
// its axis at the end of the name, as in the columns of series.csv. Returns an empty function where
// there is no such metric.
template <class Record>
std::function<double(const Record&)> find_number(const MetricList<Record>& metrics,
                                                 const std::string& name) {
  for (const Metric<Record>& metric : metrics) {
    if (metric.kind != MetricKind::numbers && metric.name == name)
      return [read = metric.value](const Record& record) { return number_of(read(record)); };
    for (std::size_t k = 0; k < 3; ++k)
      if (metric.kind == MetricKind::numbers && fmt::format("{}_{}", metric.name, "xyz"[k]) == name)
        return [k, read = metric.value](const Record& record) {
          return std::get<std::vector<double>>(read(record)).at(k);
        };
  }
  return {};
}

[[noreturn]] void refuse_field(const Parameters& parameters) {
  parameters.fail(fmt::format("there is no field \"{}\"", parameters.text("field")));
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
  const bool is_point = !beginning.description.probes[probe].is_plane();
  const auto& components = is_point ? of_point : of_plane;
  const auto component = components.find(parameters.text("component"));
  if (component == components.end()) parameters.fail("the probe has no such component");
  const std::size_t value = first_value(beginning.description, probe) + component->second;
  return [value](Moment& moment) { return moment.probe_values()[value]; };
}

Signal balance_signal(const Parameters& parameters, const Beginning&) {
  const std::string name = parameters.text("field");
  std::function<double(const Balance&)> read;
  // The elastic energy of the solids of all formulations.
  if (name == "elastic")
    read = [](const Balance& b) {
      return b.elastic_deviatoric + b.stored_solid + b.elastic_strain;
    };
  for (const MetricList<Balance>* metrics : {&balance_terms(), &balance_errors()})
    if (!read) read = find_number(*metrics, name);
  if (!read) refuse_field(parameters);
  return [read](Moment& moment) { return read(moment.balance()); };
}

Signal cut_signal(const Parameters& parameters, const Beginning& beginning) {
  const std::string name = parameters.text("field");
  const double scale = parameters.text("per", "") == "jet width"
                           ? 1.0 / beginning.description.jets.at(0).width
                           : 1.0;
  if (const auto read = find_number(CutState::metrics(), name))
    return [read, scale](Moment& moment) { return scale * read(moment.cut()); };
  const auto read = find_number(CutSummary::metrics(), name);
  if (!read) refuse_field(parameters);
  return [read](Moment& moment) { return read(moment.cut_summary()); };
}

Signal exposure_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto read = find_number(Exposure::metrics(), parameters.text("field"));
  if (!read) refuse_field(parameters);
  return [read, &description = beginning.description](Moment& moment) {
    const auto exposure = exposure_of(description, moment.cut_history(), moment.cut_summary());
    return exposure ? read(*exposure) : Exposure::none;
  };
}

const std::map<std::string, SignalMaker>& signal_makers() {
  static const std::map<std::string, SignalMaker> makers{
      {"probe", probe_signal},
      {"balance", balance_signal},
      {"cut", cut_signal},
      {"exposure", exposure_signal},
      {"body_mean", body_mean_signal},
      {"kinetic_centroid", kinetic_centroid_signal},
      {"profile_error", profile_error_signal},
      {"extent", extent_signal},
      {"jet_tip", jet_tip_signal},
      {"deepest_water", deepest_water_signal},
      {"forward_share", forward_share_signal},
      {"region_volume", region_volume_signal},
      {"region_velocity", region_velocity_signal},
      {"reach", reach_signal},
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
