// SPDX-License-Identifier: Apache-2.0
#include "case/write_used.hpp"

#include <fmt/format.h>

#include "case/machine_fields.hpp"
#include "case/material_library.hpp"
#include "case/toml_writer.hpp"
#include "case/units.hpp"

namespace kerf {

namespace {

void write_top(TomlWriter& writer, const Case& description) {
  writer.open("", "");
  writer.text("title", description.title);
  writer.raw("dimension", std::to_string(description.dimension));
  writer.text("formulation", formulation_name(description.formulation));
  writer.text("precision", description.precision == PrecisionKind::mixed ? "mixed" : "double");
  writer.number("smoothing_ratio", description.smoothing_ratio);
  writer.vector("gravity", description.gravity);
  writer.open("[time]", "time");
  writer.number("end", description.time.end);
  writer.number("courant", description.time.courant);
  writer.number("maximum_step", description.time.maximum_step);
  writer.open("[domain]", "domain");
  writer.vector("minimum", description.domain.minimum);
  writer.vector("maximum", description.domain.maximum);
  if (description.symmetry.any()) writer.faces("symmetry", description.symmetry);
}

void write_material(TomlWriter& writer, Formulation formulation, const Material& material) {
  writer.open(fmt::format("[materials.{}]", material.name), "materials");
  writer.text("kind", kind_name(material.kind));
  if (material.kind == MaterialKind::elastic && formulation == Formulation::standard) {
    writer.text("elasticity", word_of(material.elasticity, elastic_law_words));
    writer.text("plasticity", word_of(material.plasticity, plastic_law_words));
    writer.text("criterion", word_of(material.criterion, bond_criterion_words));
  }
  if (material.kind == MaterialKind::water && formulation == Formulation::standard)
    writer.text("equation_of_state", word_of(material.equation_of_state, equation_of_state_words));
  for (const MaterialField& field : material_fields(material_conditions(material, formulation)))
    writer.number(field.key, material.*field.member);
  if (material.kind == MaterialKind::water) writer.number("sound_speed", material.sound_speed);
  writer.text("source", material.source);
}

std::string grading_text(const Grading& grading, int dimension) {
  const std::string around =
      grading.around ? ", around = " + shape_text(*grading.around, dimension) : "";
  return fmt::format("{{ levels = {}, width = {}{} }}", grading.levels,
                     quoted(write_quantity(grading.width, "m")), around);
}

void write_body(TomlWriter& writer, const Case& description, const Body& body) {
  static constexpr const char* roles[] = {"elastic", "water", "rigid"};
  static constexpr const char* layers[] = {"top",   "bottom", "left", "right",
                                           "front", "back",   "all"};
  writer.open("[[body]]", "body");
  writer.text("name", body.name);
  writer.text("role", roles[static_cast<std::size_t>(body.role)]);
  if (body.role != Role::rigid)
    writer.text("material", description.materials[static_cast<std::size_t>(body.material)].name);
  writer.raw("shape", shape_text(body.shape, description.dimension));
  writer.number("spacing", body.spacing);
  writer.text("lattice", body.lattice == Lattice::square ? "square" : "hexagonal");
  writer.vector("offset", body.offset);
  if (body.grading.levels > 0)
    writer.raw("grading", grading_text(body.grading, description.dimension));
  if (body.role != Role::rigid) writer.expressions("velocity_expression", body.velocity);
  if (body.role == Role::water && description.formulation == Formulation::standard)
    writer.number("pressure", body.pressure);
  if (body.role != Role::water) writer.raw("fixed", body.fixed ? "true" : "false");
  if (!body.displacement[0].empty())
    writer.expressions("displacement_expression", body.displacement);
  if (body.absorbing.any()) writer.faces("absorbing", body.absorbing);
  if (!body.joined_to.empty()) writer.text("joined_to", body.joined_to);
  if (body.role != Role::rigid && description.formulation == Formulation::standard) {
    writer.number("jitter", body.jitter);
    writer.raw("seed", std::to_string(body.seed));
  }
  if (body.role != Role::rigid) return;
  writer.text("repelling_layer", layers[static_cast<std::size_t>(body.repelling_layer)]);
  writer.number("repulsion", body.repulsion);
  if (description.formulation == Formulation::standard) writer.number("friction", body.friction);
}

void write_jet(TomlWriter& writer, const Case& description, const Jet& jet) {
  writer.open("[[jet]]", "jet");
  writer.text("name", jet.name);
  writer.text("material", description.materials[static_cast<std::size_t>(jet.material)].name);
  writer.number("speed", jet.speed);
  const bool is_round = description.dimension == 3 && jet.length == 0.0;
  writer.number(is_round ? "diameter" : "width", jet.width);
  if (jet.length > 0.0) writer.number("length", jet.length);
  writer.vector("position", jet.position);
  writer.number("standoff", jet.standoff);
  writer.number("angle", jet.angle);
  if (description.dimension == 3) writer.number("azimuth", jet.azimuth);
  writer.number("spacing", jet.spacing);
  writer.number("start", jet.start);
  writer.number("stop", jet.stop);
  writer.vector("traverse", jet.traverse);
  writer.number("dwell", jet.dwell);
  writer.number("pulse_frequency", jet.pulse_frequency);
  writer.number("duty", jet.duty);
  writer.text("profile_expression", jet.profile);
}

void write_machine(TomlWriter& writer, const Case& description) {
  const Machine& machine = *description.machine;
  writer.open("[machine]", "machine");
  writer.text("material", description.materials[static_cast<std::size_t>(machine.material)].name);
  writer.text("orifice_type", word_of(machine.orifice_type, orifice_words));
  for (const MachineField& field : machine_fields(machine, description.dimension))
    writer.number(field.key, machine.*field.member);
  writer.vector("position", machine.position);
  writer.vector("traverse_direction", machine.traverse_direction);
}

void write_probe(TomlWriter& writer, const Probe& probe) {
  writer.open("[[probe]]", "probe");
  writer.text("name", probe.name);
  writer.text("kind", probe.kind == Probe::Kind::point ? "point" : "plane");
  writer.vector("position", probe.position);
  if (probe.kind == Probe::Kind::plane) writer.vector("normal", probe.normal);
}

void write_control(TomlWriter& writer, const Case& description) {
  if (description.eraser) {
    writer.open("[backflow_eraser]", "backflow_eraser");
    writer.number("speed_fraction", description.eraser->speed_fraction);
  }
  if (description.formulation == Formulation::shinohara2004) {
    writer.open("[artificial_stress]", "artificial_stress");
    writer.number("epsilon", description.artificial_stress.epsilon);
    writer.number("exponent", description.artificial_stress.exponent);
  }
  if (description.formulation == Formulation::standard) {
    writer.open("[numerics]", "numerics");
    writer.text("water", word_of(description.numerics.water, water_scheme_words));
    writer.raw("shifting", description.numerics.shifting ? "true" : "false");
    writer.raw("subcycles", std::to_string(description.numerics.subcycles));
  }
  writer.open("[output]", "output");
  writer.numbers("frame_times", description.output.frame_times);
  writer.numbers("picture_times", description.output.picture_times);
  writer.number("series_interval", description.output.series_interval);
  writer.number("checkpoint_interval", description.output.checkpoint_interval);
}

}  // namespace

std::string write_used(const Case& description) {
  TomlWriter writer(description.dimension);
  write_top(writer, description);
  for (const Material& material : description.materials)
    write_material(writer, description.formulation, material);
  for (const Body& body : description.bodies) write_body(writer, description, body);
  if (description.machine) write_machine(writer, description);
  for (const Jet& jet : description.jets)
    if (!description.machine || &jet != &description.jets.back())
      write_jet(writer, description, jet);
  for (const Probe& probe : description.probes) write_probe(writer, probe);
  write_control(writer, description);
  return writer.result();
}

}  // namespace kerf
