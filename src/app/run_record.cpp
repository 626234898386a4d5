// SPDX-License-Identifier: Apache-2.0
#include "app/run_record.hpp"

#include <fmt/format.h>

#include <array>
#include <variant>

#include "core/error.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Of a word of flags, before the number of a jet.
constexpr unsigned jet_bits = 3;

struct HistoryColumn {
  const char* name;
  double& (*member)(CutState&);
};
constexpr std::array<HistoryColumn, 14> history_columns = {{
    {"time", [](CutState& state) -> double& { return state.time; }},
    {"front_depth", [](CutState& state) -> double& { return state.front_depth; }},
    {"cut_depth", [](CutState& state) -> double& { return state.cut_depth; }},
    {"fractured_fraction", [](CutState& state) -> double& { return state.fractured_fraction; }},
    {"fractured_mass", [](CutState& state) -> double& { return state.fractured_mass; }},
    {"fractured_width", [](CutState& state) -> double& { return state.fractured_width; }},
    {"kerf_width", [](CutState& state) -> double& { return state.kerf_width; }},
    {"void_width", [](CutState& state) -> double& { return state.void_width; }},
    {"wake_depth", [](CutState& state) -> double& { return state.wake.depth; }},
    {"wake_lag", [](CutState& state) -> double& { return state.wake.lag; }},
    {"wake_width", [](CutState& state) -> double& { return state.wake.width; }},
    {"water_impulse", [](CutState& state) -> double& { return state.water_impulse; }},
    {"pressed_share", [](CutState& state) -> double& { return state.pressed_share; }},
    {"cut_front", [](CutState& state) -> double& { return state.cut_front; }},
}};

std::string history_name(const char* name) {
  return std::string("cut/") + name;
}

void save_history(std::vector<CutState> history, Archive& archive) {
  for (const HistoryColumn& column : history_columns) {
    std::vector<double> values;
    for (CutState& state : history) values.push_back(column.member(state));
    archive.arrays[history_name(column.name)] = std::move(values);
  }
  std::vector<std::uint32_t> pieces, through;
  std::vector<std::uint8_t> bodies;  // of each body in turn
  std::vector<double> torn;          // likewise
  for (const CutState& state : history) {
    pieces.push_back(static_cast<std::uint32_t>(state.pieces));
    through.push_back((state.cut_through ? 1u : 0u) + (state.is_touched ? 2u : 0u) +
                      (state.is_touched_by_first ? 4u : 0u) +
                      (static_cast<std::uint32_t>(state.cut_jet) << jet_bits));
    for (const BodyCut& body : state.bodies) {
      torn.push_back(body.torn);
      bodies.push_back(static_cast<std::uint8_t>((body.through ? 1 : 0) + (body.severed ? 2 : 0) +
                                                 (body.left ? 4 : 0) + (body.punched ? 8 : 0)));
    }
  }
  archive.arrays["cut/pieces"] = std::move(pieces);
  archive.arrays["cut/through"] = std::move(through);
  archive.arrays["cut/bodies"] = std::move(bodies);
  archive.arrays["cut/torn"] = std::move(torn);
}

template <class T>
const std::vector<T>& find(const Archive& archive, const std::string& name) {
  const auto found = archive.arrays.find(name);
  if (found == archive.arrays.end() || !std::holds_alternative<std::vector<T>>(found->second))
    throw UserError(fmt::format("the checkpoint does not contain '{}'. Start the run again with "
                                "--force.",
                                name),
                    exit_files);
  return std::get<std::vector<T>>(found->second);
}

std::vector<CutState> restore_history(const Archive& archive) {
  const auto& pieces = find<std::uint32_t>(archive, "cut/pieces");
  const auto& through = find<std::uint32_t>(archive, "cut/through");
  const auto& bodies = find<std::uint8_t>(archive, "cut/bodies");
  const auto& torn = find<double>(archive, "cut/torn");
  std::vector<CutState> history(pieces.size());
  const std::size_t count = history.empty() ? 0 : bodies.size() / history.size();
  require(count * history.size() == bodies.size(), "every row has all bodies");
  for (std::size_t i = 0; i < history.size(); ++i) {
    history[i].pieces = static_cast<int>(pieces[i]);
    history[i].cut_through = (through.at(i) & 1u) != 0;
    history[i].is_touched = (through.at(i) & 2u) != 0;
    history[i].is_touched_by_first = (through.at(i) & 4u) != 0;
    history[i].cut_jet = static_cast<int>(through.at(i) >> jet_bits);
    for (std::size_t n = i * count; n < (i + 1) * count; ++n)
      history[i].bodies.push_back({(bodies[n] & 1u) != 0, (bodies[n] & 2u) != 0,
                                   (bodies[n] & 4u) != 0, (bodies[n] & 8u) != 0, torn.at(n)});
  }
  for (const HistoryColumn& column : history_columns) {
    const auto& values = find<double>(archive, history_name(column.name));
    for (std::size_t i = 0; i < history.size(); ++i) column.member(history[i]) = values.at(i);
  }
  return history;
}

constexpr const char* stage_prefix = "stage/";
constexpr const char* limit_prefix = "limit/";

}  // namespace

Archive to_archive(const RunRecord& record) {
  Archive archive;
  archive.texts["case_name"] = record.case_name;
  archive.texts["state"] = record.finished ? "finished" : "running";
  archive.arrays["wall_time"] = std::vector<double>{record.wall_time};
  archive.arrays["row_time"] = std::vector<double>{record.row_time};
  archive.arrays["frame_times"] = record.frame_times;
  archive.arrays["picture_times"] = record.picture_times;
  archive.arrays["schedule"] = std::vector<std::uint64_t>{record.frames_due, record.pictures_due,
                                                          record.rows_due, record.rows};
  archive.arrays["most_stored"] =
      std::vector<double>{record.most_stored.energy, record.most_stored.hourglass};
  for (const auto& [name, steps] : record.limits)
    archive.texts[limit_prefix + name] = fmt::format("{}", steps);
  for (const StageTime& stage : record.stage_times)
    archive.texts[stage_prefix + stage.name] = fmt::format("{}", stage.seconds);
  save_history(record.cut_history, archive);
  archive.arrays["cut/traces"] = record.cut_traces;
  return archive;
}

RunRecord record_from(const Archive& archive) {
  RunRecord record;
  const auto& schedule = find<std::uint64_t>(archive, "schedule");
  record.wall_time = find<double>(archive, "wall_time").at(0);
  record.row_time = find<double>(archive, "row_time").at(0);
  record.frame_times = find<double>(archive, "frame_times");
  record.picture_times = find<double>(archive, "picture_times");
  record.frames_due = schedule.at(0);
  record.pictures_due = schedule.at(1);
  record.rows_due = schedule.at(2);
  record.rows = schedule.at(3);
  const auto& stored = find<double>(archive, "most_stored");
  record.most_stored = {stored.at(0), stored.at(1)};
  for (const auto& [name, text] : archive.texts) {
    if (name == "case_name") record.case_name = text;
    if (name == "state") record.finished = text == "finished";
    if (name.starts_with(limit_prefix))
      record.limits[name.substr(std::string(limit_prefix).size())] = std::stoull(text);
    if (name.starts_with(stage_prefix))
      record.stage_times.push_back(
          {name.substr(std::string(stage_prefix).size()), std::stod(text)});
  }
  record.cut_history = restore_history(archive);
  record.cut_traces = find<std::uint8_t>(archive, "cut/traces");
  return record;
}

}  // namespace kerf
