// SPDX-License-Identifier: Apache-2.0
#include "output/read_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "output/files.hpp"
#include "output/hdf5.hpp"
#include "output/seal.hpp"
#include "output/vtkhdf.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void damaged(const fs::path& file, const char* what) {
  throw UserError(fmt::format("{}: the file is damaged ({}). Remove it, or run the case again.",
                              file.string(), what),
                  exit_files);
}

template <class T>
std::vector<std::array<double, 3>> triples(const std::vector<T>& values) {
  std::vector<std::array<double, 3>> rows(values.size() / 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a) rows[i][a] = static_cast<double>(values[3 * i + a]);
  return rows;
}

template <class T>
void read_column(const hdf5::Handle& group, const char* name, std::vector<T>& values) {
  values = hdf5::read_array<T>(group, name);
}
void read_column(const hdf5::Handle& group, const char* name,
                 std::vector<std::array<double, 3>>& values) {
  values = triples(hdf5::read_array<float>(group, name));
}
void read_column(const hdf5::Handle& group, const char* name, std::vector<Category>& values) {
  for (const std::uint8_t code : hdf5::read_array<std::uint8_t>(group, name))
    values.push_back(static_cast<Category>(std::min<std::uint8_t>(code, 3)));
}

void read_fields(const hdf5::Handle& group, Frame& frame) {
  std::set<std::string> known;
  for_each_column(frame, [&](const char* name, const char*, auto& values) {
    read_column(group, name, values);
    known.insert(name);
  });
  const std::size_t count = frame.position.size();
  const std::vector<std::string> names = hdf5::arrays_in(group);
  for_each_piece_column(frame, [&](const char* name, const char*, auto& values) {
    if (std::find(names.begin(), names.end(), name) == names.end()) return;
    read_column(group, name, values);
    known.insert(name);
  });
  known.insert(derived_arrays.begin(), derived_arrays.end());
  for (const std::string& name : names) {
    if (known.count(name) != 0 || count == 0) continue;
    const hdf5::Handle dataset = hdf5::open_dataset(group, name);
    auto values = hdf5::read_array<float>(group, name);
    const int components = static_cast<int>(values.size() / count);
    frame.columns.push_back({name, hdf5::read_text_attribute(dataset, "unit"), components,
                             std::move(values), hdf5::read_text_attribute(dataset, "label")});
  }
}

// Every field has an entry for each particle; those of pieces may be missing.
bool is_intact(const Frame& frame) {
  const std::size_t count = frame.position.size();
  bool intact = true;
  for_each_column(frame, [&](const char*, const char*, const auto& values) {
    intact = intact && values.size() == count;
  });
  for_each_piece_column(frame, [&](const char*, const char*, const auto& values) {
    intact = intact && (values.empty() || values.size() == count);
  });
  return intact && std::all_of(frame.columns.begin(), frame.columns.end(), [&](const Column& c) {
           return c.values.size() == count * static_cast<std::size_t>(c.components);
         });
}

}  // namespace

std::vector<FrameFile> frame_files(const fs::path& folder) {
  fs::path series;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".series") series = entry.path();
  std::vector<FrameFile> files;
  if (series.empty()) return files;
  try {
    const auto json = nlohmann::json::parse(read_file(series));
    for (const auto& entry : json.at("files")) {
      const fs::path file = folder / entry.at("name").get<std::string>();
      if (fs::exists(file)) files.push_back({file, entry.at("time").get<double>()});
    }
  } catch (const nlohmann::json::exception& error) {
    damaged(series, error.what());
  }
  return files;
}

Frame read_frame(const fs::path& file, int dimension) {
  Frame frame;
  frame.dimension = dimension;
  if (sealed_version(read_file(file), frame_kind) != frame_version)
    damaged(file, "its last line does not have the checksum of its bytes");
  try {
    const hdf5::Handle opened = hdf5::open(file);
    const hdf5::Handle root = hdf5::open_group(opened, "VTKHDF");
    frame.position = triples(hdf5::read_array<double>(root, "Points"));
    frame.time = hdf5::read_array<double>(root, "FieldData/TimeValue").at(0);
    frame.step = hdf5::read_array<std::uint64_t>(root, "FieldData/step").at(0);
    read_fields(hdf5::open_group(root, "PointData"), frame);
  } catch (const hdf5::Error& error) {
    damaged(file, error.what());
  } catch (const std::out_of_range& error) {
    damaged(file, error.what());
  }
  if (!is_intact(frame)) damaged(file, "fields of different lengths");
  return frame;
}

}  // namespace kerf
