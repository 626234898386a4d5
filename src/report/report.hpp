// SPDX-License-Identifier: Apache-2.0
// This header declares report.html: one self-contained page on a run, made from the files in its
// folder.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

struct Case;

// The largest size of the page, bytes, whatever the number of particles, frames and pictures.
inline constexpr std::size_t report_limit = 15'000'000;

// Reads result.json, series.csv, the frames and the pictures of a result folder and writes
// report.html there. Throws UserError (exit_files) when one of them is missing or damaged.
void write_report(const std::filesystem::path& folder, const Case& description);

// A run of a comparison.
struct ComparedRun {
  std::filesystem::path folder;
  const Case& description;
};
// Writes compare.html into the folder of the first run: both runs side by side, with their
// verdicts, pictures and numbers, and the lines in which the cases differ. Throws as write_report()
// does.
void write_comparison(const ComparedRun& first, const ComparedRun& second);

// Returns the page of two runs side by side whose particles move with one slider of time. `runs`:
// the data of both, as the script of the viewer takes it (web/README.md). The numbers are there
// where both runs have ended. Throws as write_report() does.
std::string moving_comparison(const ComparedRun& first, const ComparedRun& second,
                              const std::string& runs);

// Returns the page. `run` holds the frames as report/viewer_data.hpp packs them, null where the
// program was built without the viewer. Throws as write_report() does.
std::string report_page(const std::filesystem::path& folder, const Case& description,
                        nlohmann::ordered_json run);

}  // namespace kerf
