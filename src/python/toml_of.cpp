// SPDX-License-Identifier: Apache-2.0
// Tables of Python become TOML, and JSON becomes tables of Python.
#include <toml++/toml.h>

#include <sstream>

#include "python/bindings.hpp"

namespace py = pybind11;

namespace kerf::python {
namespace {

toml::table table_of(const py::dict& table);
toml::array array_of(const py::handle& list);

[[noreturn]] void refuse(const py::handle& value) {
  throw py::type_error("a case cannot hold " + std::string(py::repr(value)) +
                       ". Allowed: texts, numbers, flags, lists and tables (dict) of them.");
}

// Calls use(value) with the value as TOML has it; numbers of NumPy count as numbers.
template <class Use>
void with_toml(const py::handle& value, const Use& use) {
  if (py::isinstance<py::bool_>(value)) return use(value.cast<bool>());
  if (py::isinstance<py::str>(value)) return use(value.cast<std::string>());
  if (py::isinstance<py::dict>(value)) return use(table_of(value.cast<py::dict>()));
  if (py::hasattr(value, "tolist")) return with_toml(value.attr("tolist")(), use);
  if (py::isinstance<py::float_>(value)) return use(value.cast<double>());
  if (PyIndex_Check(value.ptr()) != 0)
    return use(py::int_(value.cast<py::object>()).cast<std::int64_t>());
  if (py::isinstance<py::sequence>(value)) return use(array_of(value));
  if (py::hasattr(value, "__float__"))
    return use(py::float_(value.cast<py::object>()).cast<double>());
  refuse(value);
}

toml::array array_of(const py::handle& list) {
  toml::array array;
  for (const py::handle& entry : list)
    with_toml(entry, [&](auto&& item) { array.push_back(std::forward<decltype(item)>(item)); });
  return array;
}

toml::table table_of(const py::dict& table) {
  toml::table result;
  for (const auto& [key, value] : table) {
    if (!py::isinstance<py::str>(key)) refuse(key);
    const auto name = key.cast<std::string>();
    with_toml(value,
              [&](auto&& entry) { result.insert(name, std::forward<decltype(entry)>(entry)); });
  }
  return result;
}

}  // namespace

std::string toml_of(const py::dict& table) {
  std::ostringstream text;
  text << table_of(table) << '\n';
  return text.str();
}

py::object to_python(const nlohmann::ordered_json& value) {
  return py::module_::import("json").attr("loads")(value.dump());
}

}  // namespace kerf::python
