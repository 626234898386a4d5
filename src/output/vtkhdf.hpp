// SPDX-License-Identifier: Apache-2.0
// This file writes frames as VTKHDF files, UnstructuredGrid version 1.0 with one vertex cell per
// particle, which VTK 9.1 and ParaView 5.11 open. Format: https://docs.vtk.org, "VTKHDF file
// format".
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "simulation/frame.hpp"

namespace kerf {

struct Case;

// What the numbers in the frames of a run mean, and where particles were at first.
struct FrameLegend {
  std::vector<std::string> bodies;     // names of the sources
  std::vector<std::string> materials;  // the last one is that of rigid bodies
  std::vector<std::uint8_t> material;  // of each source
  std::unordered_map<std::uint32_t, std::array<double, 3>> start;  // m, of bodies, by id
};
// Returns the legend of a case, without a start.
FrameLegend legend_of(const Case& description);

// The arrays that follow from the others or from the case; read_frame() leaves them out.
inline constexpr std::array<std::string_view, 4> derived_arrays{
    "material", "stress", "reference_position", "displacement"};
// The order of the six numbers of a symmetric tensor, which is that of VTK.
inline constexpr const char* tensor_components = "xx yy zz xy yz xz";

// The kind and the version in the seal that ends a frame (output/seal.hpp).
inline constexpr const char* frame_kind = "frame";
inline constexpr int frame_version = 1;

// Returns the content of the file. Equal frames give equal bytes.
std::string vtkhdf_bytes(const Frame& frame, const FrameLegend& legend = {});

// Frames of a run: frames/<name>_NNNNN.vtkhdf, <name>.vtkhdf.series with their times, and
// <name>.paraview.py, which opens the series in ParaView, coloured and with a legend.
class FrameWriter {
 public:
  FrameWriter(std::filesystem::path folder, std::string name, FrameLegend legend = {})
      : folder_(std::move(folder)), name_(std::move(name)), legend_(std::move(legend)) {}

  // Writes the frame, then the series that names it. Throws UserError (exit_files).
  void write(const Frame& frame);
  // Times of the frames written so far, s; a resumed run begins with those of its checkpoint.
  const std::vector<double>& times() const { return times_; }
  void restore(std::vector<double> times) { times_ = std::move(times); }

 private:
  void write_series() const;
  void know_start(const Frame& frame);

  std::filesystem::path folder_;
  std::string name_;
  FrameLegend legend_;
  bool knows_start_ = false;
  std::vector<double> times_;
};

}  // namespace kerf
