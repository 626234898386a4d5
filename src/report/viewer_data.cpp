// SPDX-License-Identifier: Apache-2.0
#include "report/viewer_data.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "report/base64.hpp"
#include "report/html.hpp"
#include "report/palette.hpp"
#include "report/viewer_files.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

constexpr double outliers = 0.002;  // of the particles, on either side of a field

struct FieldText {
  const char *key, *label, *unit;
};
constexpr FieldText all_fields[] = {
    {"speed", "speed", "m/s"},
    {"pressure", "pressure", "Pa"},
    {"equivalent_stress", "equivalent stress (von Mises)", "Pa"},
    {"equivalent_strain", "equivalent strain", "1"},
    {"damage", "damage", "1"},
    {"flaw_damage", "damage by flaws", "1"},
    {"plastic_strain", "plastic strain", "1"},
    {"temperature_rise", "rise of temperature", "K"},
};

const Column* find_column(const Frame& frame, const std::string& name) {
  for (const Column& column : frame.columns)
    if (column.name == name) return &column;
  return nullptr;
}

std::vector<float> speeds(const Frame& frame) {
  std::vector<float> values;
  for (const auto& v : frame.velocity)
    values.push_back(static_cast<float>(std::hypot(v[0], v[1], v[2])));
  return values;
}

// Von Mises' stress of the deviator (xx yy zz xy yz xz), Pa.
std::vector<float> equivalent_stress(const Column& column) {
  std::vector<float> values;
  for (std::size_t k = 0; k + 5 < column.values.size(); k += 6) {
    const float* s = &column.values[k];
    const double normal = double(s[0]) * s[0] + double(s[1]) * s[1] + double(s[2]) * s[2];
    const double shear = double(s[3]) * s[3] + double(s[4]) * s[4] + double(s[5]) * s[5];
    values.push_back(static_cast<float>(std::sqrt(1.5 * (normal + 2.0 * shear))));
  }
  return values;
}

std::vector<float> field_values(const std::string& key, const Frame& frame) {
  if (key == "speed") return speeds(frame);
  if (key == "pressure") return frame.pressure;
  const Column* column = find_column(frame, key == "equivalent_stress" ? "deviatoric_stress" : key);
  if (column == nullptr) return std::vector<float>(frame.position.size(), 0.0f);
  return key == "equivalent_stress" ? equivalent_stress(*column) : column->values;
}

// The bounds of values but for outliers; 0 is between them.
std::pair<double, double> bounds_of(std::vector<float>& values) {
  if (values.empty()) return {0.0, 0.0};
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const auto rank = static_cast<std::ptrdiff_t>(outliers * static_cast<double>(count));
  const auto at = [&](std::ptrdiff_t n) {
    std::nth_element(values.begin(), values.begin() + n, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(n)]);
  };
  return {std::min(0.0, at(rank)), std::max(0.0, at(count - 1 - rank))};
}

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

// Null where a value is no number.
Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(std::isfinite(value) ? Json(value) : Json());
  return list;
}

// The planes of symmetry, of two across one axis the lower.
Json mirrors_of(const Case& description) {
  Json mirrors = Json::array();
  for (std::size_t a = 0; a < 3; ++a)
    if (description.symmetry.minimum[a])
      mirrors.push_back({{"axis", a}, {"place", description.domain.minimum[a]}});
    else if (description.symmetry.maximum[a])
      mirrors.push_back({{"axis", a}, {"place", description.domain.maximum[a]}});
  return mirrors;
}

std::string colour_text(Colour colour) {
  const auto byte = [](double share) { return static_cast<int>(std::lround(255.0 * share)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green),
                     byte(colour.blue));
}

}  // namespace

void ViewerPacker::look_at(const std::vector<FrameFile>& files) {
  for (std::size_t n = looks_.size(); n < files.size(); ++n) {
    const Frame frame = read_frame(files[n].path, description_.dimension);
    for (const float spacing : frame.spacing)
      if (std::find(spacings_.begin(), spacings_.end(), spacing) == spacings_.end())
        spacings_.push_back(spacing);
    Look look{files[n], frame.position.size(), {}};
    for (const FieldText& field : all_fields) {
      std::vector<float> values = field_values(field.key, frame);
      const auto [low, high] = bounds_of(values);
      look.ranges.push_back({low, high});
    }
    looks_.push_back(std::move(look));
  }
}

ViewerPacker::Range ViewerPacker::range_of(std::size_t field) const {
  Range range;
  for (const Look& look : looks_) {
    range.minimum = std::min(range.minimum, look.ranges[field].minimum);
    range.maximum = std::max(range.maximum, look.ranges[field].maximum);
  }
  return range;
}

std::vector<std::size_t> ViewerPacker::fields() const {
  std::vector<std::size_t> numbers;
  for (std::size_t f = 0; f < std::size(all_fields); ++f)
    if (const Range range = range_of(f); range.maximum > range.minimum) numbers.push_back(f);
  return numbers;
}

Json ViewerPacker::head() const {
  Json head;
  head["title"] = description_.title;
  head["dimension"] = description_.dimension;
  head["minimum"] = description_.domain.minimum;
  head["maximum"] = description_.domain.maximum;
  head["mirrors"] = mirrors_of(description_);
  for (const auto& [label, category] :
       {std::pair{"water", Category::water}, std::pair{"solid", Category::solid},
        std::pair{"fractured", Category::fractured}, std::pair{"rigid", Category::rigid}})
    head["categories"].push_back(
        {{"label", label}, {"colour", colour_text(colour_of(category, false))}});
  head["spacings"] = spacings_;
  head["fields"] = Json::array();
  for (const std::size_t f : fields())
    head["fields"].push_back({{"key", all_fields[f].key},
                              {"label", all_fields[f].label},
                              {"unit", all_fields[f].unit},
                              {"minimum", range_of(f).minimum},
                              {"maximum", range_of(f).maximum}});
  return head;
}

Json ViewerPacker::entry(std::size_t number) const {
  const Look& look = looks_.at(number);
  Json entry{{"time", look.file.time}, {"count", look.count}, {"ranges", Json::array()}};
  for (const std::size_t f : fields())
    entry["ranges"].push_back(
        {{"minimum", look.ranges[f].minimum}, {"maximum", look.ranges[f].maximum}});
  return entry;
}

std::string ViewerPacker::pack(std::size_t number) const {
  const Look& look = looks_.at(number);
  const Frame frame = read_frame(look.file.path, description_.dimension);
  const Box& box = description_.domain;
  std::string bytes;
  for (std::size_t a = 0; a < static_cast<std::size_t>(description_.dimension); ++a)
    for (const auto& place : frame.position)
      append(bytes, static_cast<std::uint16_t>(
                        quantized(place[a], {box.minimum[a], box.maximum[a]}, 65535.0)));
  for (const Category category : frame.category) bytes += static_cast<char>(category);
  for (const float spacing : frame.spacing)
    bytes += static_cast<char>(std::find(spacings_.begin(), spacings_.end(), spacing) -
                               spacings_.begin());
  for (const std::size_t f : fields()) {
    const Range& range = look.ranges[f];
    for (const float value : field_values(all_fields[f].key, frame))
      bytes += static_cast<char>(
          quantized(static_cast<double>(value), {range.minimum, range.maximum}, 255.0));
  }
  return deflated(bytes);
}

Json viewer_frames(const ViewerPacker& packer, std::size_t budget) {
  Json frames = Json::array();
  if (packer.frames() == 0) return frames;
  const auto entry = [&](std::size_t number) {
    Json frame = packer.entry(number);
    frame["data"] = base64(packer.pack(number));
    return frame;
  };
  // The last one is about the largest.
  const std::size_t last_number = packer.frames() - 1;
  Json last = entry(last_number);
  const std::size_t size = std::max<std::size_t>(1, last.at("data").get_ref<std::string&>().size());
  const std::size_t most = std::max<std::size_t>(2, budget / size);
  const std::size_t stride = last_number / (most - 1) + (last_number % (most - 1) != 0 ? 1 : 0);
  for (std::size_t n = 0; n < last_number; n += std::max<std::size_t>(1, stride))
    frames.push_back(entry(n));
  frames.push_back(std::move(last));
  return frames;
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
