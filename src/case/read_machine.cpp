// SPDX-License-Identifier: Apache-2.0
// [machine], and the numerics that follow from a jet where a case leaves them out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/draft.hpp"
#include "case/machine_fields.hpp"
#include "machine/machine_jet.hpp"
#include "machine/standoff.hpp"
#include "particles/shapes.hpp"

namespace kerf {

namespace {

// Horizontal and of length 1; in 2D along x.
Point read_direction(Section& section) {
  const Point written = section.vector("traverse_direction", Point{1.0, 0.0, 0.0});
  const double length = std::hypot(written[0], written[2]);
  if (written[1] == 0.0 && length > 0.0) return unit_vector(written);
  section.refuse("traverse_direction",
                 written[1] != 0.0 ? "the direction is not horizontal" : "the direction is zero",
                 "Correct the vector: y is the vertical", "a horizontal vector that is not 0");
  return {1.0, 0.0, 0.0};
}

void read_coefficients(Section& section, Machine& machine) {
  machine.velocity_coefficient = section.number("velocity_coefficient");
  machine.discharge_coefficient = section.number(
      "discharge_coefficient", machine.velocity_coefficient * standard_contraction(machine));
  if (machine.discharge_coefficient > machine.velocity_coefficient)
    section.refuse(
        "discharge_coefficient", "the jet would be wider than its orifice",
        "Lower it, or correct the velocity_coefficient",
        fmt::format("at most the velocity_coefficient, {:g}", machine.velocity_coefficient));
}

void read_motion(Section& section, Machine& machine) {
  machine.position = section.vector("position");
  machine.lead_angle = section.number("lead_angle");
  machine.tilt_angle = section.reading().dimension == 3 ? section.number("tilt_angle") : 0.0;
  machine.traverse_speed = section.number("traverse_speed");
  machine.traverse_direction = read_direction(section);
  machine.dwell = section.number("dwell");
  read_pulses(section, machine.pulse_frequency, machine.duty);
}

Machine read_keys(Section& section, OrificeType type) {
  Machine machine;
  machine.orifice_type = type;
  const auto read = [&](std::string_view key, double& member) {
    const auto conditions = machine_conditions(type, section.reading().dimension);
    if (find_key("machine", key, conditions)->applies_under(conditions))
      member = section.number(key);
  };
  read("pressure", machine.pressure);
  read("orifice_diameter", machine.orifice_diameter);
  read("orifice_length", machine.orifice_length);
  read("cone_angle", machine.cone_angle);
  read("fan_angle", machine.fan_angle);
  read_coefficients(section, machine);
  machine.standoff = section.number("standoff");
  read_motion(section, machine);
  return machine;
}

}  // namespace

int particles_across(Quality quality, int dimension) {
  static constexpr int in_plane[] = {8, 12, 20}, in_space[] = {6, 8, 12};
  const auto level = static_cast<std::size_t>(quality);
  return dimension == 2 ? in_plane[level] : in_space[level];
}

void read_machine(Draft& draft, Section& top) {
  const toml::table* written = top.table("machine");
  if (!written) return;
  Section section(draft.reading, *written, "machine", "machine");
  const auto type = law_of<OrificeType>(section.text("orifice_type"), orifice_words);
  section.assume(std::string(word_of(type, orifice_words)));
  JetDraft entry;
  entry.path = "machine";
  entry.material = section.text("material");
  const MaterialDraft* water = use_water(draft, section, entry.material);
  Machine machine = read_keys(section, type);
  if (!water || draft.reading.problems.any()) {
    section.refuse_unknown();
    return;
  }
  const int dimension = draft.reading.dimension;
  machine.coherent_length = section.number(
      "coherent_length",
      coherent_diameters * machine_numbers(machine, water->material, dimension).diameter);
  const double arriving =
      machine_numbers(machine, water->material, dimension).diameter_at_workpiece;
  machine.spacing =
      section.number("spacing", arriving / particles_across(draft.quality, dimension));
  section.refuse_unknown();
  entry.jet = machine_jet(machine, water->material, dimension);
  draft.result.machine = machine;
  draft.jets.push_back(std::move(entry));
}

double finest_jet_spacing(const Draft& draft) {
  double finest = 0.0;
  for (const JetDraft& entry : draft.jets)
    finest = finest > 0.0 ? std::min(finest, entry.jet.spacing) : entry.jet.spacing;
  return finest;
}

// Without strength a jet sinks at half its speed; a workpiece that resists is given twice as
// long, and a nozzle that moves the time for four jet widths.
double standard_end(const Draft& draft) {
  if (!draft.result.machine) return 0.0;
  const Jet& jet = draft.jets.back().jet;
  double low = jet.position[1], high = low;
  for (const BodyDraft& entry : draft.bodies) {
    if (entry.body.role != Role::elastic) continue;
    const Box around = bounding_box(entry.body.shape, draft.reading.dimension);
    low = std::min(low, around.minimum[1]);
    high = std::max(high, around.maximum[1]);
  }
  const double through =
      (jet.standoff + 4.0 * (high - low) / std::cos(jet.angle)) / (jet.speed * jet.duty);
  const double speed = std::hypot(jet.traverse[0], jet.traverse[2]);
  const double along = speed > 0.0 ? jet.dwell + 4.0 * jet.width / speed : 0.0;
  return std::max(through, along);
}

}  // namespace kerf
