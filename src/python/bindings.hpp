// SPDX-License-Identifier: Apache-2.0
// The parts of the Python module `kerf._kerf`, one function each. python/kerf/_kerf.pyi states the
// types.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string>

#include "model/case.hpp"
#include "simulation/frame.hpp"

namespace kerf::python {

// A case with the text that it was read from.
struct CaseText {
  std::string text;
  std::string file;  // names it in messages; meshes are found from its folder
  Case description;
};

void bind_errors(pybind11::module_& module);
void bind_case(pybind11::module_& module);
void bind_frame(pybind11::module_& module);
void bind_run(pybind11::module_& module);

// Returns a table of Python (dict, list, numbers, texts) as the text of a case file. Throws
// TypeError where a value is none of these.
std::string toml_of(const pybind11::dict& table);
// Returns JSON as dict, list, numbers and texts of Python.
pybind11::object to_python(const nlohmann::ordered_json& value);

// Returns a read-only array over numbers that `owner` keeps; one component has no axis of its own.
pybind11::array read_only_array(const pybind11::dtype& type, const void* data, std::size_t rows,
                                std::size_t components, const pybind11::object& owner);

}  // namespace kerf::python
