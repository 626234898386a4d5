// SPDX-License-Identifier: Apache-2.0
// What the page of a report draws by itself (web/README.md): the moving picture and the curves, as
// JSON. Frames are packed: places as 16-bit and fields as 8-bit numbers, then deflated.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "output/read_frame.hpp"
#include "report/report_figures.hpp"

namespace kerf {

// Packs the frames of one run. Each frame has bounds of its own, so that frames may be added while
// a run goes on.
class ViewerPacker {
 public:
  // The case must outlive the packer.
  explicit ViewerPacker(const Case& description) : description_(description) {}

  // Reads the frames beyond those known.
  void look_at(const std::vector<FrameFile>& files);
  std::size_t frames() const { return looks_.size(); }

  // Leaves particles out of all frames, the same ones, where not even some eight frames of all of
  // them would fit in `budget` bytes of a page.
  void fit(std::size_t budget);
  double share() const { return share_; }  // of the particles that are shown
  std::size_t largest() const;             // number of a frame with most particles

  // title, dimension, minimum, maximum, categories, spacings, fields.
  nlohmann::ordered_json head() const;
  // time, count and ranges of a frame.
  nlohmann::ordered_json entry(std::size_t number) const;
  // zlib data of the bytes that web/README.md describes, for the fields of head() as it is now.
  std::string pack(std::size_t number) const { return packed(number).data; }
  // entry() with these bytes as text, for a page without a server.
  nlohmann::ordered_json whole_entry(std::size_t number) const;

 private:
  struct Packed {
    std::size_t count = 0;
    std::string data;
  };
  Packed packed(std::size_t number) const;
  std::vector<std::size_t> kept(const Frame& frame) const;
  struct Range {
    double minimum = 0.0, maximum = 0.0;
  };
  struct Look {
    FrameFile file;
    std::size_t count = 0;
    std::vector<Range> ranges;  // of all fields there may be
  };
  Range range_of(std::size_t field) const;  // in all frames
  // Those that are not zero everywhere, which would tell nothing.
  std::vector<std::size_t> fields() const;

  const Case& description_;
  std::vector<Look> looks_;
  std::vector<float> spacings_;  // m
  double share_ = 1.0;
};

// Frames as text within `budget` bytes: fewer of them, evenly spread, where there are too many.
nlohmann::ordered_json viewer_frames(const ViewerPacker& packer, std::size_t budget);
// The data and the script that draws them; empty where the program was built without it.
std::string viewer_script(const nlohmann::ordered_json& run);
// `cut_time` < 0: not cut through.
nlohmann::ordered_json viewer_curves(const std::vector<ReportFigure>& figures,
                                     const std::vector<double>& time, double cut_time);

}  // namespace kerf
