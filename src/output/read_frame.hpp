// SPDX-License-Identifier: Apache-2.0
// These functions read the frames of a run from its folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "simulation/frame.hpp"

namespace kerf {

struct FrameFile {
  std::filesystem::path path;
  double time = 0.0;  // s
};

// Returns the frames that a run has written into `folder` so far and that are still there, in order
// of time; none when there is no series. Throws UserError (exit_files) where the series is damaged.
std::vector<FrameFile> frame_files(const std::filesystem::path& folder);

// Reads a frame that output/vtkhdf.hpp wrote. Throws UserError (exit_files) where the file is
// missing or damaged.
Frame read_frame(const std::filesystem::path& file, int dimension);

}  // namespace kerf
