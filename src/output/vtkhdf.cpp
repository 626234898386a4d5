// SPDX-License-Identifier: Apache-2.0
#include "output/vtkhdf.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "core/error.hpp"
#include "output/files.hpp"
#include "output/frame_extras.hpp"
#include "output/hdf5.hpp"
#include "output/paraview_macro.hpp"
#include "output/read_frame.hpp"
#include "output/seal.hpp"

namespace kerf {
namespace {

using hdf5::Block;
using hdf5::Handle;

constexpr std::uint8_t vtk_vertex = 1;  // VTK's cell type of a single point

template <class T>
Block vectors(const std::vector<std::array<T, 3>>& values) {
  return {values.data(), hdf5::type_of<T>(), values.size(), 3};
}

void write_cells(const Handle& root, std::int64_t particles) {
  const std::vector<std::int64_t> count{particles};
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    hdf5::write(root, name, hdf5::block(count));
  // Cell i is the point i: offsets 0 .. n, connectivity 0 .. n - 1.
  std::vector<std::int64_t> offsets(static_cast<std::size_t>(particles) + 1);
  std::iota(offsets.begin(), offsets.end(), 0);
  hdf5::write(root, "Offsets", hdf5::block(offsets), hdf5::Packing::deflate);
  offsets.pop_back();
  hdf5::write(root, "Connectivity", hdf5::block(offsets), hdf5::Packing::deflate);
  const std::vector<std::uint8_t> types(offsets.size(), vtk_vertex);
  hdf5::write(root, "Types", hdf5::block(types), hdf5::Packing::deflate);
}

Handle write_field(const Handle& group, const std::string& name, const Block& values,
                   const std::string& unit, std::vector<std::string>& units) {
  Handle dataset = hdf5::write(group, name, values, hdf5::Packing::deflate);
  hdf5::write_text_attribute(dataset, "unit", unit);
  if (values.components == 6) hdf5::write_text_attribute(dataset, "components", tensor_components);
  units.push_back(name + " / " + unit);
  return dataset;
}

// Converts a column: numbers unchanged, velocities in single precision, categories by their codes.
template <class T>
const std::vector<T>& stored(const std::vector<T>& values) {
  return values;
}
std::vector<std::array<float, 3>> stored(const std::vector<std::array<double, 3>>& values) {
  std::vector<std::array<float, 3>> rows(values.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) rows[i][k] = static_cast<float>(values[i][k]);
  return rows;
}
std::vector<std::uint8_t> stored(const std::vector<Category>& values) {
  std::vector<std::uint8_t> codes(values.size());
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<std::uint8_t>(values[i]);
  return codes;
}
template <class T>
Block block_of(const std::vector<T>& values) {
  return hdf5::block(values);
}
Block block_of(const std::vector<std::array<float, 3>>& values) {
  return vectors(values);
}

// Returns the name and the unit of every array, "velocity / m/s".
std::vector<std::string> write_fields(const Handle& group, const Frame& frame) {
  std::vector<std::string> units;
  for_each_column(frame, [&](const char* name, const char* unit, const auto& column) {
    const auto& values = stored(column);
    write_field(group, name, block_of(values), unit, units);
  });
  for_each_piece_column(frame, [&](const char* name, const char* unit, const auto& values) {
    if (!values.empty()) write_field(group, name, block_of(values), unit, units);
  });
  for (const Column& column : frame.columns) {
    const auto components = static_cast<std::size_t>(column.components);
    require(column.values.size() == components * frame.position.size(), "a column's length");
    const Handle dataset = write_field(
        group, column.name,
        {column.values.data(), hdf5::type_of<float>(), frame.position.size(), components},
        column.unit, units);
    if (!column.label.empty()) hdf5::write_text_attribute(dataset, "label", column.label);
  }
  return units;
}

// Writes what users of ParaView expect and what follows from the frame and its legend.
void write_extras(const Handle& group, const Frame& frame, const FrameLegend& legend,
                  std::vector<std::string>& units) {
  if (!legend.material.empty())
    write_field(group, "material", hdf5::block(materials_of(frame, legend)), "1", units);
  if (const auto stress = full_stress(frame); !stress.empty())
    write_field(group, "stress", {stress.data(), hdf5::type_of<float>(), stress.size() / 6, 6},
                "Pa", units);
  if (legend.start.empty()) return;
  const FrameMotion motion = motion_of(frame, legend);
  write_field(group, "reference_position", vectors(motion.reference), "m", units);
  write_field(group, "displacement", vectors(motion.displacement), "m", units);
}

void write_field_data(const Handle& root, const Frame& frame, const FrameLegend& legend,
                      const std::vector<std::string>& units) {
  const Handle fields = hdf5::create_group(root, "FieldData");
  const std::vector<double> time{frame.time};
  const std::vector<std::uint64_t> step{frame.step};
  hdf5::write(fields, "TimeValue", hdf5::block(time));
  hdf5::write(fields, "step", hdf5::block(step));
  hdf5::write_texts(fields, "units", units);
  if (!legend.bodies.empty()) hdf5::write_texts(fields, "body_names", legend.bodies);
  if (!legend.materials.empty()) hdf5::write_texts(fields, "material_names", legend.materials);
}

}  // namespace

std::string vtkhdf_bytes(const Frame& frame, const FrameLegend& legend) {
  const Handle file = hdf5::create();
  {
    const Handle root = hdf5::create_group(file, "VTKHDF");
    hdf5::write_attribute(root, "Version", {1, 0});
    hdf5::write_text_attribute(root, "Type", "UnstructuredGrid");
    write_cells(root, static_cast<std::int64_t>(frame.position.size()));
    hdf5::write(root, "Points", vectors(frame.position), hdf5::Packing::deflate);
    const Handle points = hdf5::create_group(root, "PointData");
    // The arrays that ParaView shows first; readers before VTK 9.3 pass over these attributes.
    hdf5::write_text_attribute(points, "Scalars", "category");
    hdf5::write_text_attribute(points, "Vectors", "velocity");
    std::vector<std::string> units = write_fields(points, frame);
    write_extras(points, frame, legend, units);
    write_field_data(root, frame, legend, units);
  }
  return sealed(hdf5::bytes_of(file), frame_kind, frame_version);
}

// The first frame tells where particles were; a resumed run reads it back.
void FrameWriter::know_start(const Frame& frame) {
  if (knows_start_) return;
  knows_start_ = true;
  const auto learn = [&](const Frame& first) {
    for (std::size_t i = 0; i < first.id.size(); ++i)
      if (first.category[i] != Category::water) legend_.start[first.id[i]] = first.position[i];
  };
  const auto first = folder_ / fmt::format("frames/{}_{:05}.vtkhdf", name_, 0);
  if (times_.empty())
    learn(frame);
  else if (std::filesystem::exists(first))
    learn(read_frame(first, frame.dimension));
}

void FrameWriter::write(const Frame& frame) {
  make_inner_folder(folder_ / "frames");
  const std::string file = fmt::format("frames/{}_{:05}.vtkhdf", name_, times_.size());
  know_start(frame);
  write_file(folder_ / file, vtkhdf_bytes(frame, legend_));
  times_.push_back(frame.time);
  write_series();
}

void FrameWriter::write_series() const {
  nlohmann::ordered_json series;
  series["file-series-version"] = "1.0";
  series["files"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < times_.size(); ++i)
    series["files"].push_back(
        {{"name", fmt::format("frames/{}_{:05}.vtkhdf", name_, i)}, {"time", times_[i]}});
  write_file(folder_ / (name_ + ".vtkhdf.series"), series.dump(2) + "\n");
  if (times_.size() == 1) write_file(folder_ / (name_ + ".paraview.py"), paraview_macro(name_));
}

}  // namespace kerf
