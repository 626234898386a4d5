// SPDX-License-Identifier: Apache-2.0
// Cases in Python: read from a file, a text or a table, with the checks and messages of `kerf
// check`.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "analysis/derived.hpp"
#include "app/check_json.hpp"
#include "app/embedded.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "output/metric_json.hpp"
#include "python/bindings.hpp"

namespace py = pybind11;

namespace kerf::python {
namespace {

CaseText read_text(std::string text, const std::string& file) {
  Case description = parse_case(text, file);
  return {std::move(text), file, std::move(description)};
}

// Tables of Python have no lines: an error names only the case.
CaseText read_tables(const py::dict& tables, const std::string& file) {
  try {
    return read_text(toml_of(tables), file);
  } catch (const UserError& error) {
    std::string message = error.what();
    const std::string before = file + ":";
    for (std::size_t at = message.find(before); at != std::string::npos;
         at = message.find(before, at + 1)) {
      const std::size_t line = at + before.size();
      const std::size_t end = message.find_first_not_of("0123456789", line);
      if (end != std::string::npos && end > line && message[end] == ':')
        message.erase(line, end + 1 - line);
    }
    throw UserError(message, error.exit_code());
  }
}

py::object derived_of(const CaseText& self) {
  return to_python(object_of(DerivedNumbers::metrics(), derive(self.description)));
}

py::object cost_of(const CaseText& self, int threads) {
  return to_python(cost_object(derive(self.description), typical_pace(self.description, threads)));
}

py::dict templates() {
  py::dict all;
  for (const EmbeddedText& text : case_templates())
    all[py::str(std::string(text.name))] = py::str(std::string(text.text));
  return all;
}

}  // namespace

void bind_case(py::module_& module) {
  py::class_<CaseText>(module, "Case",
                       "A case: what is cut, by which jet, and how it is computed.\n\n"
                       "Parameters\n----------\n"
                       "source : str or dict\n"
                       "    The text of a case file (TOML), or its tables; see docs/keys.md. A\n"
                       "    quantity is a text with its unit, such as \"5 m/s\".\n"
                       "file : str\n"
                       "    Names the case in messages and results; meshes are found from its\n"
                       "    folder.\n\n"
                       "Raises\n------\n"
                       "CaseError\n"
                       "    With the message of `kerf check`: key, value, allowed range, remedy.")
      .def(py::init(&read_text), py::arg("source"), py::arg("file") = "case.toml")
      .def(py::init(&read_tables), py::arg("source"), py::arg("file") = "case.toml")
      .def_static(
          "read",
          [](const std::filesystem::path& file) {
            return read_text(case_text(file), file.string());
          },
          py::arg("file"), "Read a case file.")
      .def_readonly("text", &CaseText::text, "The text of the case (TOML).")
      .def_readonly("file", &CaseText::file, "The name of the case in messages.")
      .def_property_readonly(
          "used", [](const CaseText& self) { return write_used(self.description); },
          "The complete case with all defaults, in SI units, as case.used.toml.")
      .def_property_readonly(
          "title", [](const CaseText& self) { return self.description.title; },
          "The title of the case.")
      .def_property_readonly(
          "dimension", [](const CaseText& self) { return self.description.dimension; },
          "2 (plane strain) or 3.")
      .def_property_readonly(
          "end", [](const CaseText& self) { return self.description.time.end; }, "The end time, s.")
      .def_property_readonly(
          "names",
          [](const CaseText& self) {
            std::vector<std::string> names;
            for (const Body& body : self.description.bodies) names.push_back(body.name);
            for (const Jet& jet : self.description.jets) names.push_back(jet.name);
            return names;
          },
          "The names of the bodies and then of the jets; `source` of a particle is an index of "
          "this "
          "list.")
      .def_property_readonly(
          "derived", &derived_of,
          "Numbers that follow from the case, in SI units, such as wave speeds, loads and "
          "dimensionless groups (docs/metrics.md).")
      .def("cost", &cost_of, py::arg("threads") = 1,
           "Return an estimate of what a run costs, as `kerf check --json --no-timing`:\n"
           "particles, time step and simulated time (s), steps, memory (bytes), run time (s).");
  module.def("templates", &templates, "The cases of `kerf new`: their texts by name.");
}

}  // namespace kerf::python
