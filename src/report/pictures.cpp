// SPDX-License-Identifier: Apache-2.0
#include "report/pictures.hpp"

#include <fmt/format.h>

#include "output/files.hpp"
#include "report/picture.hpp"

namespace kerf {

std::string PictureWriter::file(std::size_t index) const {
  return fmt::format("pictures/{}_{:02}.png", name_, index);
}

void PictureWriter::write(const Frame& frame) {
  make_inner_folder(folder_ / "pictures");
  write_file(folder_ / file(times_.size()), draw_picture(frame, description_));
  times_.push_back(frame.time);
}

}  // namespace kerf
