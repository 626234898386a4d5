// SPDX-License-Identifier: Apache-2.0
// This header declares the pictures of a run, PNG files, and the movie that is made of them.
// Particles are discs of their spacing at true scale in the paper's colours. In 3D an oblique view
// with the front half cut away stands beside a thin slice through the axis.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "model/case.hpp"
#include "simulation/frame.hpp"

namespace kerf {

// Returns the part of the domain that the pictures of a case show: its bodies and jets with a
// margin. It is the same for every frame, unless a frame of the workpiece travels.
Box picture_window(const Case& description);

// Draws a frame and returns the bytes of a PNG file; `scale` is the size relative to full size.
std::string draw_picture(const Frame& frame, const Case& description, double scale = 1.0);

// Writes the pictures of a run: pictures/<name>_NN.png.
class PictureWriter {
 public:
  PictureWriter(std::filesystem::path folder, std::string name, Case description)
      : folder_(std::move(folder)), name_(std::move(name)), description_(std::move(description)) {}

  // Throws UserError (exit_files).
  void write(const Frame& frame);
  // The times of the pictures drawn, s; a resumed run begins with those of its checkpoint.
  const std::vector<double>& times() const { return times_; }
  void restore(std::vector<double> times) { times_ = std::move(times); }
  // Returns the path of the picture of that number in the result folder.
  std::string file(std::size_t index) const;

 private:
  std::filesystem::path folder_;
  std::string name_;
  Case description_;
  std::vector<double> times_;
};

// Draws all frames of a result folder, has ffmpeg encode them as movie.mp4 and returns that path.
// `progress` gets the number of drawn frames and of all frames. Throws UserError (exit_files) when
// there is no ffmpeg or no frame.
std::filesystem::path write_movie(const std::filesystem::path& folder, const Case& description,
                                  const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace kerf
