// SPDX-License-Identifier: Apache-2.0
// This header declares the parts of report.html that have files of their own, and how numbers of
// result.json are read for them.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>
#include <string>

namespace kerf {

struct Case;

// Returns a number of result.json; NaN for null.
inline double value_of(const nlohmann::ordered_json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

// Returns the table of the setting of the machine and its jet from result.json.
std::string machine_table(const nlohmann::ordered_json& result);
// Returns the table of the exposure from result.json, which has one.
std::string exposure_table(const nlohmann::ordered_json& result);
// Returns the table of the workpiece, its materials and its thickness at the jet, from the object
// `kerf` of result.json.
std::string workpiece_table(const nlohmann::ordered_json& kerf, const Case& description);

// Returns whether the workpiece is cut through although the kerf goes through nowhere on the path:
// the rest has a crack.
inline bool is_parted(const nlohmann::ordered_json& result) {
  return result.contains("kerf") && result.at("cut_through").get<bool>() &&
         !result.at("kerf").at("through").get<bool>() &&
         !(value_of(result.at("kerf").at("through_share")) > 0.0);
}

// Returns whether a layer of the kerf stands in the way of the jet where the kerf is deeper beside
// it. Results of earlier versions do not tell.
inline bool stands_in_kerf(const nlohmann::ordered_json& layer, double depth) {
  return layer.contains("face") && layer.at("face").is_number() &&
         !layer.at("cut_through").get<bool>() && value_of(layer.at("unbroken")) > 0.0 &&
         value_of(layer.at("face")) + value_of(layer.at("depth")) < depth;
}

// Says what share of the material in the way of the jet is gone below the kerf: "without loss of
// material". Results of earlier versions do not tell.
std::string loss_words(const nlohmann::ordered_json& kerf);

// Names such layers: ", beside bone, which is not cut through".
std::string standing_words(const nlohmann::ordered_json& kerf);

// Returns whether the workpiece is cut through as plugs of all bodies in the way have come off.
inline bool is_punched(const nlohmann::ordered_json& result) {
  const auto kind = result.find("cut_through_by");
  return kind != result.end() && *kind == "punched";
}

// Returns the content of a result.json. Throws UserError (exit_files) where the run has not ended
// or the file is damaged.
nlohmann::ordered_json read_result(const std::filesystem::path& path);
// Ends the command because a result.json is not as Kerf writes it.
[[noreturn]] void refuse_result(const std::filesystem::path& path, const char* why);
// Calls `make`, which uses the content of a result.json.
template <class Make>
auto using_result(const std::filesystem::path& path, const Make& make) {
  try {
    return make();
  } catch (const nlohmann::json::exception& error) {
    refuse_result(path, error.what());
  }
}
// Says whether the workpiece is cut through; where the nozzle stands in place of one that moves, at
// the traverse speed.
std::string verdict_part(const nlohmann::ordered_json& result, bool has_jet);
// Returns the path of a picture that result.json lists, and its element.
std::filesystem::path file_of(const std::filesystem::path& folder,
                              const nlohmann::ordered_json& picture);
std::string picture_figure(const std::filesystem::path& folder,
                           const nlohmann::ordered_json& picture);
// Returns the picture of the end of the run; empty where there is none.
std::string last_picture(const nlohmann::ordered_json& result, const std::filesystem::path& folder);

// Returns what an operator reads first: the picture of the cut, beside it the verdict on each body
// and up to which feed the cut goes through; empty for a run without a jet. `picture` is the
// picture of the end of the run, which stands for the drawing of a kerf where there is none.
std::string first_screen(const nlohmann::ordered_json& result, const Case& description,
                         const std::string& picture);
// Returns the drawing of the kerf; empty where nothing was cut.
std::string kerf_figure(const nlohmann::ordered_json& result, const Case& description);
// Returns the tables of the kerf and the machine; empty for a run without a
// jet.
std::string kerf_part(const nlohmann::ordered_json& result, const Case& description);
// Returns the table of the intervals of the headline numbers, from the list `intervals` of
// result.json, or the remark that there are none; empty for a run without a jet.
std::string intervals_table(const nlohmann::ordered_json& result);
// Returns the tables of all other numbers.
std::string report_tables(const nlohmann::ordered_json& result, const Case& description);

}  // namespace kerf
