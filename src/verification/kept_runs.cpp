// SPDX-License-Identifier: Apache-2.0
#include "verification/kept_runs.hpp"

#include <fmt/format.h>

#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "core/version.hpp"
#include "model/case.hpp"
#include "output/files.hpp"
#include "output/read_frame.hpp"
#include "output/vtkhdf.hpp"

namespace kerf {

namespace {

using Json = nlohmann::json;

// The keys by which a check is judged do not change its signal.
const std::set<std::string>& keys_of_judgement() {
  static const std::set<std::string> keys{
      "quantity", "source", "unit", "reference",   "tolerance", "at_least",   "at_most", "judge",
      "mean",     "plot",   "runs", "relative_to", "scatter",   "calibrated", "interval"};
  return keys;
}

// Returns everything on which the recording of a run depends.
Json identity_of(const PlannedRun& run, const std::vector<const Check*>& checks) {
  Json signals = Json::array();
  for (const Check* check : checks) {
    Json keys = check->parameters.values();
    for (const std::string& key : keys_of_judgement()) keys.erase(key);
    signals.push_back(std::move(keys));
  }
  return {{"version", program_version},
          {"case", run.case_text},
          {"placement", run.placement.text()},
          {"refine", run.refinement},
          {"sample", run.sample_interval},
          {"picture", run.picture_time ? Json(*run.picture_time) : Json()},
          {"signals", std::move(signals)}};
}

std::filesystem::path stem_of(const std::filesystem::path& folder, const std::string& case_name,
                              const PlannedRun& run) {
  const std::string place = run.placement.is_as_written() ? "" : ", " + run.placement.text();
  return folder / case_name / file_name_of(run.name + place);
}

Recording recording_of(const Json& kept) {
  Recording recording;
  for (const Json& series : kept.at("series"))
    recording.series.push_back({series.at("time").get<std::vector<double>>(),
                                series.at("value").get<std::vector<double>>()});
  recording.seconds = kept.at("seconds").get<double>();
  recording.was_kept = true;
  return recording;
}

}  // namespace

std::optional<Recording> KeptRuns::find(const std::string& case_name, const PlannedRun& run,
                                        const std::vector<const Check*>& checks) const {
  if (folder_.empty()) return std::nullopt;
  const auto stem = stem_of(folder_, case_name, run);
  if (!std::filesystem::exists(stem.string() + ".cbor")) return std::nullopt;
  try {
    const Json kept = Json::from_cbor(read_file(stem.string() + ".cbor"));
    if (kept.at("identity") != identity_of(run, checks)) return std::nullopt;
    Recording recording = recording_of(kept);
    if (kept.at("has_look").get<bool>())
      recording.image = read_frame(stem.string() + ".vtkhdf", run.description().dimension);
    return recording;
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const UserError&) {
    return std::nullopt;
  }
}

void KeptRuns::keep(const std::string& case_name, const PlannedRun& run,
                    const std::vector<const Check*>& checks, const Recording& recording) const {
  if (folder_.empty() || !recording.problem.empty()) return;
  const auto stem = stem_of(folder_, case_name, run);
  make_folder(stem.parent_path());
  Json series = Json::array();
  for (const TimeSeries& each : recording.series)
    series.push_back({{"time", each.time}, {"value", each.value}});
  const Json kept{{"identity", identity_of(run, checks)},
                  {"series", std::move(series)},
                  {"seconds", recording.seconds},
                  {"has_look", recording.image.has_value()}};
  if (recording.image) write_file(stem.string() + ".vtkhdf", vtkhdf_bytes(*recording.image));
  const std::vector<std::uint8_t> bytes = Json::to_cbor(kept);
  write_file(stem.string() + ".cbor", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string file_name_of(const std::string& text) {
  std::string name;
  for (const unsigned char c : text) {
    if (std::isalnum(c) != 0)
      name += static_cast<char>(std::tolower(c));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name;
}

}  // namespace kerf
