// SPDX-License-Identifier: Apache-2.0
#include "report/viewer_data.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"
#include "report/html.hpp"
#include "report/palette.hpp"
#include "report/viewer_files.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
void append(std::string& bytes, T value) {
  for (std::size_t k = 0; k < sizeof(T); ++k)
    bytes += static_cast<char>((value >> (8 * k)) & 0xff);  // little-endian
}

unsigned quantized(double value, std::pair<double, double> bounds, double steps) {
  const auto [low, high] = bounds;
  if (!(high > low)) return 0;
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return static_cast<unsigned>(std::lround(steps * share));
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9);
  require(status == Z_OK, "deflate a frame");
  packed.resize(size);
  return packed;
}

// Returns a hash of the particle's number, from 0 to 1. It selects the same particles in all frames
// and does not remove complete rows of a lattice.
double lot_of(std::uint32_t id) {
  std::uint32_t bits = id + 0x9e3779b9u;
  bits = (bits ^ (bits >> 16)) * 0x85ebca6bu;
  bits = (bits ^ (bits >> 13)) * 0xc2b2ae35u;
  return (bits ^ (bits >> 16)) / 4294967296.0;
}

// Returns the size of an entry in the page, bytes.
std::size_t size_in_page(const Json& entry) {
  return entry.dump().size() + 1;
}

// Returns a list with null for values that are not finite.
Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(std::isfinite(value) ? Json(value) : Json());
  return list;
}

// Returns the planes of symmetry; of two across one axis the lower one.
Json mirrors_of(const Case& description) {
  Json mirrors = Json::array();
  for (std::size_t a = 0; a < 3; ++a)
    if (description.symmetry.minimum[a])
      mirrors.push_back({{"axis", a}, {"place", description.domain.minimum[a]}});
    else if (description.symmetry.maximum[a])
      mirrors.push_back({{"axis", a}, {"place", description.domain.maximum[a]}});
  return mirrors;
}

}  // namespace

void ViewerPacker::add_frames(const std::vector<FrameFile>& files) {
  for (std::size_t n = frames_.size(); n < files.size(); ++n) {
    const Frame frame = read_frame(files[n].path, description_.dimension);
    const Box domain = at_time(description_, frame.time).domain;
    for (std::size_t a = 0; a < 3; ++a) {
      domain_.minimum[a] = std::min(domain_.minimum[a], domain.minimum[a]);
      domain_.maximum[a] = std::max(domain_.maximum[a], domain.maximum[a]);
    }
    for (const float spacing : frame.spacing)
      if (std::find(spacings_.begin(), spacings_.end(), spacing) == spacings_.end())
        spacings_.push_back(spacing);
    include_fields(frame);
    FrameRecord record{files[n], frame.position.size(), {}};
    for (const ViewerField& field : fields_) {
      record.ranges.push_back(range_in(frame, field));
    }
    frames_.push_back(std::move(record));
  }
}

ViewerPacker::Range ViewerPacker::range_in(const Frame& frame, const ViewerField& field) const {
  if (!field.names.empty()) return {0.0, static_cast<double>(field.names.size() - 1)};
  std::vector<float> values = field_values(field.key, frame, description_);
  const auto [low, high] = bounds_of(values);
  return {low, high};
}

// A frame without particles has no columns: fields may come with a later one.
void ViewerPacker::include_fields(const Frame& frame) {
  for (const ViewerField& field : viewer_fields(frame, description_)) {
    const auto same = [&](const ViewerField& known) { return known.key == field.key; };
    if (std::any_of(fields_.begin(), fields_.end(), same)) continue;
    fields_.push_back(field);
    for (FrameRecord& record : frames_) record.ranges.push_back({});
  }
}

ViewerPacker::Range ViewerPacker::range_of(std::size_t field) const {
  Range range;
  for (const FrameRecord& record : frames_) {
    range.minimum = std::min(range.minimum, record.ranges[field].minimum);
    range.maximum = std::max(range.maximum, record.ranges[field].maximum);
  }
  return range;
}

std::vector<std::size_t> ViewerPacker::fields() const {
  std::vector<std::size_t> numbers;
  for (std::size_t f = 0; f < fields_.size(); ++f)
    if (const Range range = range_of(f); range.maximum > range.minimum) numbers.push_back(f);
  return numbers;
}

Json ViewerPacker::head() const {
  Json head;
  head["title"] = description_.title;
  head["dimension"] = description_.dimension;
  head["minimum"] = domain_.minimum;
  head["maximum"] = domain_.maximum;
  head["mirrors"] = mirrors_of(description_);
  for (const auto& [label, category] :
       {std::pair{"water", Category::water}, std::pair{"solid", Category::solid},
        std::pair{"fractured", Category::fractured}, std::pair{"rigid", Category::rigid}})
    head["categories"].push_back({{"label", label}, {"colour", hex(colour_of(category, false))}});
  // The remaining particles are drawn larger, so that bodies have no gaps.
  head["spacings"] = Json::array();
  for (const float spacing : spacings_)
    head["spacings"].push_back(spacing *
                               static_cast<float>(std::pow(share_, -1.0 / description_.dimension)));
  head["fields"] = Json::array();
  for (const std::size_t f : fields()) {
    head["fields"].push_back({{"key", fields_[f].key},
                              {"label", fields_[f].label},
                              {"unit", fields_[f].unit},
                              {"minimum", range_of(f).minimum},
                              {"maximum", range_of(f).maximum}});
    if (!fields_[f].names.empty()) head["fields"].back()["names"] = fields_[f].names;
  }
  return head;
}

Json ViewerPacker::entry(std::size_t number) const {
  const FrameRecord& record = frames_.at(number);
  Json entry{{"time", record.file.time}, {"count", record.count}, {"ranges", Json::array()}};
  for (const std::size_t f : fields())
    entry["ranges"].push_back(
        {{"minimum", record.ranges[f].minimum}, {"maximum", record.ranges[f].maximum}});
  return entry;
}

std::vector<std::size_t> ViewerPacker::kept(const Frame& frame) const {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    if (share_ >= 1.0 || lot_of(frame.id[i]) < share_) rows.push_back(i);
  return rows;
}

ViewerPacker::Packed ViewerPacker::packed(std::size_t number) const {
  const FrameRecord& record = frames_.at(number);
  const Frame frame = read_frame(record.file.path, description_.dimension);
  const std::vector<std::size_t> rows = kept(frame);
  const Box& box = domain_;
  std::string bytes;
  for (std::size_t a = 0; a < static_cast<std::size_t>(description_.dimension); ++a)
    for (const std::size_t i : rows)
      append(bytes, static_cast<std::uint16_t>(quantized(
                        frame.position[i][a], {box.minimum[a], box.maximum[a]}, 65535.0)));
  for (const std::size_t i : rows) bytes += static_cast<char>(frame.category[i]);
  for (const std::size_t i : rows)
    bytes += static_cast<char>(std::find(spacings_.begin(), spacings_.end(), frame.spacing[i]) -
                               spacings_.begin());
  for (const std::size_t f : fields()) {
    const Range& range = record.ranges[f];
    const std::vector<float> values = field_values(fields_[f].key, frame, description_);
    for (const std::size_t i : rows)
      bytes += static_cast<char>(
          quantized(static_cast<double>(values[i]), {range.minimum, range.maximum}, 255.0));
  }
  return {rows.size(), deflated(bytes)};
}

Json ViewerPacker::whole_entry(std::size_t number) const {
  Json whole = entry(number);
  Packed frame = packed(number);
  whole["count"] = frame.count;
  whole["data"] = html::base64(frame.data);
  return whole;
}

std::size_t ViewerPacker::largest() const {
  return static_cast<std::size_t>(std::max_element(frames_.begin(), frames_.end(),
                                                   [](const FrameRecord& a, const FrameRecord& b) {
                                                     return a.count < b.count;
                                                   }) -
                                  frames_.begin());
}

void ViewerPacker::fit(std::size_t budget) {
  constexpr std::size_t fewest_frames = 8;  // fewer do not show a motion
  constexpr double reserve = 0.9;           // frames with equal numbers of particles differ in size
  if (frames_.empty()) return;
  const std::size_t wanted = std::min(fewest_frames, frames_.size());
  const double size = static_cast<double>(wanted * size_in_page(whole_entry(largest())));
  if (size > static_cast<double>(budget)) share_ *= reserve * static_cast<double>(budget) / size;
}

Json viewer_frames(const ViewerPacker& packer, std::size_t budget) {
  Json frames = Json::array();
  if (packer.frames() == 0) return frames;
  const std::size_t size = size_in_page(packer.whole_entry(packer.largest()));
  std::size_t most = std::max<std::size_t>(2, budget / size);
  const std::size_t last = packer.frames() - 1;
  for (;; most = std::max<std::size_t>(2, most * 3 / 4)) {
    const std::size_t stride = last / (most - 1) + (last % (most - 1) != 0 ? 1 : 0);
    frames = Json::array();
    std::size_t sum = 0;
    const auto add = [&](std::size_t number) {
      frames.push_back(packer.whole_entry(number));
      sum += size_in_page(frames.back());
    };
    for (std::size_t n = 0; n < last; n += std::max<std::size_t>(1, stride)) add(n);
    add(last);
    if (sum <= budget || most == 2) return frames;
  }
}

std::string viewer_script(const Json& run) {
  const std::string_view script = viewer_text("script");
  if (script.empty()) return {};
  return html::data_script("kerf-run", run.dump()) + "<script>" + std::string(script) +
         "</script>\n";
}

Json viewer_curves(const std::vector<ReportFigure>& figures, const std::vector<double>& time,
                   double cut_time) {
  Json curves;
  curves["time"] = time;
  curves["groups"] = Json::array();
  for (const ReportFigure& figure : figures) {
    Json group{{"label", figure.title}, {"unit", figure.axis.unit}, {"series", Json::array()}};
    for (const Curve& curve : figure.curves)
      group["series"].push_back(
          {{"key", curve.label}, {"label", curve.label}, {"values", numbers(curve.y)}});
    curves["groups"].push_back(std::move(group));
  }
  curves["marks"] = Json::array();
  if (cut_time >= 0.0) curves["marks"].push_back({{"time", cut_time}, {"label", "cut through"}});
  return curves;
}

}  // namespace kerf
