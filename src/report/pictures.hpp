// SPDX-License-Identifier: Apache-2.0
// The pictures of a run: pictures/<name>_NN.png.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "simulation/frame.hpp"

namespace kerf {

class PictureWriter {
 public:
  PictureWriter(std::filesystem::path folder, std::string name, Case description)
      : folder_(std::move(folder)), name_(std::move(name)), description_(std::move(description)) {}

  // Throws UserError (exit_files).
  void write(const Frame& frame);
  // Times of the pictures drawn so far, s; a resumed run begins with those of its checkpoint.
  const std::vector<double>& times() const { return times_; }
  void restore(std::vector<double> times) { times_ = std::move(times); }
  // Where the picture of that number is, relative to the result folder.
  std::string file(std::size_t index) const;

 private:
  std::filesystem::path folder_;
  std::string name_;
  Case description_;
  std::vector<double> times_;
};

}  // namespace kerf
