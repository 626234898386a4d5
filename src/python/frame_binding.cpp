// SPDX-License-Identifier: Apache-2.0
// Frames in Python: the columns of the particles as NumPy arrays that share the frame's memory.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "output/read_frame.hpp"
#include "python/bindings.hpp"

namespace py = pybind11;

namespace kerf::python {
namespace {

template <class Number>
py::array array_over(const Number* data, std::size_t rows, std::size_t components,
                     const py::object& owner) {
  return read_only_array(py::dtype::of<Number>(), data, rows, components, owner);
}
template <class Number>
py::array array_of(const std::vector<Number>& values, const py::object& owner) {
  return array_over(values.data(), values.size(), 1, owner);
}
py::array array_of(const std::vector<std::array<double, 3>>& values, const py::object& owner) {
  return array_over(reinterpret_cast<const double*>(values.data()), values.size(), 3, owner);
}
py::array array_of(const std::vector<Category>& values, const py::object& owner) {
  return array_over(reinterpret_cast<const std::uint8_t*>(values.data()), values.size(), 1, owner);
}

// Calls visit(name, unit, make), where make(owner) returns the array, for every column.
template <class Visit>
void for_each_array(const Frame& frame, const Visit& visit) {
  const auto plain = [&](const char* name, const char* unit, const auto& values) {
    visit(name, unit, [&](const py::object& owner) { return array_of(values, owner); });
  };
  plain("position", "m", frame.position);
  for_each_column(frame, plain);
  if (!frame.piece.empty()) for_each_piece_column(frame, plain);
  for (const Column& column : frame.columns)
    visit(column.name, column.unit, [&](const py::object& owner) {
      const auto components = static_cast<std::size_t>(column.components);
      return array_over(column.values.data(), column.values.size() / components, components, owner);
    });
}

py::array column(const py::object& self, const std::string& name) {
  const auto& frame = self.cast<const Frame&>();
  py::object found = py::none();
  for_each_array(frame, [&](const std::string& column_name, const std::string&, const auto& make) {
    if (column_name == name) found = make(self);
  });
  if (found.is_none()) throw py::key_error("no column \"" + name + "\"; see Frame.units");
  return found;
}

py::dict units(const Frame& frame) {
  py::dict all;
  for_each_array(frame, [&](const std::string& name, const std::string& unit, const auto&) {
    all[py::str(name)] = unit;
  });
  return all;
}

py::list frames(const std::filesystem::path& folder) {
  py::list all;
  for (const FrameFile& file : frame_files(folder))
    all.append(py::make_tuple(file.path, file.time));
  return all;
}

}  // namespace

py::array read_only_array(const py::dtype& type, const void* data, std::size_t rows,
                          std::size_t components, const py::object& owner) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (components > 1) shape.push_back(static_cast<py::ssize_t>(components));
  py::array array(type, shape, {}, data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

void bind_frame(py::module_& module) {
  py::class_<Frame>(module, "Frame",
                    "The particles of a run at one instant, in SI units.\n\n"
                    "`frame[\"velocity\"]` is a NumPy array with a row per particle that shares "
                    "the memory of the frame. Vectors have three components also in 2D; tensors "
                    "are xx yy zz xy yz xz.")
      .def_readonly("dimension", &Frame::dimension, "2 or 3.")
      .def_readonly("time", &Frame::time, "Time, s.")
      .def_readonly("step", &Frame::step, "Number of steps before it.")
      .def("__len__", [](const Frame& self) { return self.position.size(); })
      .def("__getitem__", &column, py::arg("name"), "Return a column by its name.")
      .def("__contains__",
           [](const Frame& self, const std::string& name) {
             return units(self).contains(name.c_str());
           })
      .def(
          "keys", [](const Frame& self) { return py::list(units(self)); },
          "Return the names of the columns.")
      .def_property_readonly("units", &units, "The SI unit of each column by its name.");
  module.def("frame_files", &frames, py::arg("folder"),
             "Return path and time (s) of each frame that a run has written.");
  module.def("read_frame", &read_frame, py::arg("file"), py::arg("dimension"),
             "Read a frame file of a run in 2 or 3 dimensions.");
}

}  // namespace kerf::python
