// SPDX-License-Identifier: Apache-2.0
// report.html: one self-contained page about a run, made from the files in its folder.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "case/case.hpp"

namespace kerf {

// However long the run and however many its particles and pictures, the page stays smaller, bytes.
inline constexpr std::size_t report_limit = 15'000'000;

// Reads result.json, series.csv, the frames and the pictures of a result folder and writes
// report.html there. Throws UserError (exit_files) when one of them is missing or damaged.
void write_report(const std::filesystem::path& folder, const Case& description);

// The page; `run` holds what report/viewer_data.hpp makes of the frames, null where the program was
// built without the viewer. Throws as above.
std::string report_page(const std::filesystem::path& folder, const Case& description,
                        nlohmann::ordered_json run);

// Of the kerf and the machine: a drawing with dimensions, tables; empty for runs without a jet.
std::string kerf_part(const nlohmann::ordered_json& result, const Case& description);
// The tables of numbers.
std::string report_tables(const nlohmann::ordered_json& result, const Case& description);

}  // namespace kerf
