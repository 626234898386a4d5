// SPDX-License-Identifier: Apache-2.0
// report.html: one self-contained page about a run, made from the files in its folder.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "case/case.hpp"
#include "output/series.hpp"

namespace kerf {

// Reads result.json, series.csv and the pictures of a result folder and writes report.html there.
// Throws UserError (exit_files) when one of them is missing or damaged.
void write_report(const std::filesystem::path& folder, const Case& description);

// The curves of a run as figures; `cut_time` marks the cut where it is not negative.
std::string report_plots(const SeriesTable& series, const Case& description, double cut_time);
// The tables of numbers.
std::string report_tables(const nlohmann::ordered_json& result, const Case& description);

}  // namespace kerf
