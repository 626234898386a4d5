// SPDX-License-Identifier: Apache-2.0
// A movie of a run, drawn frame by frame and encoded by ffmpeg where that is installed.
#pragma once

#include <filesystem>
#include <functional>

#include "case/case.hpp"

namespace kerf {

// Writes movie.mp4 into a result folder from all its frames; the file. `progress` is told how many
// of how many frames are drawn. Throws UserError (exit_files) without ffmpeg or frames.
std::filesystem::path write_movie(const std::filesystem::path& folder, const Case& description,
                                  const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace kerf
