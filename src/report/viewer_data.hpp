// SPDX-License-Identifier: Apache-2.0
// This header declares the data that the script of a report draws (web/README.md): the moving
// picture and the curves, as JSON. Frames are packed: positions as 16-bit and fields as 8-bit
// numbers, deflated.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "output/read_frame.hpp"
#include "report/report_figures.hpp"
#include "report/viewer_fields.hpp"

namespace kerf {

// Packs the frames of one run. Each frame has bounds of its own, so that frames may be added while
// the run proceeds.
class ViewerPacker {
 public:
  // The case must outlive the packer.
  explicit ViewerPacker(const Case& description)
      : description_(description), domain_(description.domain) {}

  // Reads the frames that were added since the last call.
  void add_frames(const std::vector<FrameFile>& files);
  std::size_t frames() const { return frames_.size(); }

  // Omits the same particles from all frames if eight complete frames do not fit in `budget` bytes
  // of a page.
  void fit(std::size_t budget);
  double share() const { return share_; }  // share of the particles that are shown
  std::size_t largest() const;             // the index of a frame with most particles

  // Returns title, dimension, minimum, maximum, categories, spacings and fields.
  nlohmann::ordered_json head() const;
  // Returns time, count and ranges of a frame.
  nlohmann::ordered_json entry(std::size_t number) const;
  // Returns the bytes that web/README.md describes as zlib data, for the current fields of head().
  std::string pack(std::size_t number) const { return packed(number).data; }
  // Returns entry() with these bytes as text, for a page without a server.
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
  struct FrameRecord {
    FrameFile file;
    std::size_t count = 0;
    std::vector<Range> ranges;  // of the fields
  };
  Range range_in(const Frame& frame, const ViewerField& field) const;
  Range range_of(std::size_t field) const;  // in all frames
  void include_fields(const Frame& frame);
  // The numbers of the fields that are not zero everywhere.
  std::vector<std::size_t> fields() const;

  const Case& description_;
  Box domain_;  // m, of all frames: it moves where a frame of the workpiece travels
  std::vector<FrameRecord> frames_;
  std::vector<ViewerField> fields_;  // of all frames
  std::vector<float> spacings_;      // m
  double share_ = 1.0;
};

// Returns frames as text within `budget` bytes; if there are too many, evenly spaced ones.
nlohmann::ordered_json viewer_frames(const ViewerPacker& packer, std::size_t budget);
// Returns the data and the script that draws them; empty where the program was built without it.
std::string viewer_script(const nlohmann::ordered_json& run);
// Returns the curves; `cut_time` < 0 means not cut through.
nlohmann::ordered_json viewer_curves(const std::vector<ReportFigure>& figures,
                                     const std::vector<double>& time, double cut_time);

}  // namespace kerf
