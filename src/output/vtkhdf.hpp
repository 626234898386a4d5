// SPDX-License-Identifier: Apache-2.0
// This file writes frames as VTKHDF files, UnstructuredGrid version 1.0 with one vertex cell per
// particle, which VTK 9.1 and ParaView 5.11 open. Format: https://docs.vtk.org, "VTKHDF file
// format".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "simulation/frame.hpp"

namespace kerf {

// Returns the content of the file. Equal frames give equal bytes.
std::string vtkhdf_bytes(const Frame& frame);

// Frames of a run: frames/<name>_NNNNN.vtkhdf and <name>.vtkhdf.series with their times.
class FrameWriter {
 public:
  FrameWriter(std::filesystem::path folder, std::string name)
      : folder_(std::move(folder)), name_(std::move(name)) {}

  // Writes the frame, then the series that names it. Throws UserError (exit_files).
  void write(const Frame& frame);
  // Times of the frames written so far, s; a resumed run begins with those of its checkpoint.
  const std::vector<double>& times() const { return times_; }
  void restore(std::vector<double> times) { times_ = std::move(times); }

 private:
  void write_series() const;

  std::filesystem::path folder_;
  std::string name_;
  std::vector<double> times_;
};

}  // namespace kerf
