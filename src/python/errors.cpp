// SPDX-License-Identifier: Apache-2.0
// The errors of Kerf as exceptions of Python, by their exit codes (core/error.hpp).
#include "core/error.hpp"

#include "python/bindings.hpp"

namespace py = pybind11;

namespace kerf::python {
namespace {

// The exceptions live as long as the interpreter.
PyObject *error = nullptr, *case_error = nullptr, *run_error = nullptr, *file_error = nullptr;

PyObject* exception_of(int exit_code) {
  switch (exit_code) {
    case exit_bad_input:
      return case_error;
    case exit_run_failed:
      return run_error;
    case exit_files:
      return file_error;
    default:
      return error;
  }
}

PyObject* add(py::module_& module, const char* name, const char* meaning, PyObject* base) {
  const std::string full = std::string("kerf.") + name;
  PyObject* type = PyErr_NewExceptionWithDoc(full.c_str(), meaning, base, nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.add_object(name, type);
  return type;
}

}  // namespace

void bind_errors(py::module_& module) {
  error = add(module, "KerfError", "An error that the user can correct.", PyExc_RuntimeError);
  case_error =
      add(module, "CaseError",
          "The case is wrong; the message names key, value, allowed range and remedy.", error);
  run_error =
      add(module, "RunError", "The run broke down; the message says from where to go on.", error);
  file_error = add(module, "FileError", "A file or folder cannot be used.", error);
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const UserError& user_error) {
      PyErr_SetString(exception_of(user_error.exit_code()), user_error.what());
    }
  });
}

}  // namespace kerf::python
