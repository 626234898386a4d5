// SPDX-License-Identifier: Apache-2.0
// The Python module `kerf._kerf`: cases, runs and frames. The package python/kerf adds what needs
// no C++.
#include <pybind11/pybind11.h>

#include "core/version.hpp"
#include "python/bindings.hpp"

PYBIND11_MODULE(_kerf, module) {
  module.doc() = "The compiled part of the package kerf.";
  module.attr("__version__") = kerf::program_version;
  kerf::python::bind_errors(module);
  kerf::python::bind_case(module);
  kerf::python::bind_frame(module);
  kerf::python::bind_run(module);
}
