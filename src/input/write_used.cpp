// SPDX-License-Identifier: Apache-2.0
#include "input/write_used.hpp"

#include "input/toml_writer.hpp"
#include "model/case.hpp"

namespace kerf {

std::string write_used(const Case& description) {
  TomlWriter writer(description);
  write_top(writer, description);
  for (const Material& material : description.materials) write_material(writer, material);
  if (description.workpiece) write_workpiece(writer, description);
  for (const Body& body : description.bodies)
    if (!description.workpiece || &body != &description.bodies.front())
      write_body(writer, description, body);
  for (const Load& load : description.loads) write_load(writer, load);
  if (description.machine) write_machine(writer, description);
  for (const Jet& jet : description.jets)
    if (!description.machine || &jet != &description.jets.back())
      write_jet(writer, description, jet);
  for (const Probe& probe : description.probes) write_probe(writer, probe);
  write_extras(writer, description);
  write_output(writer, description.output);
  return writer.result();
}

}  // namespace kerf
