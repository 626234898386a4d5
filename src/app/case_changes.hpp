// SPDX-License-Identifier: Apache-2.0
// Changes of a case that make its run cheaper.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "model/case.hpp"

namespace kerf {

struct CaseChange {
  std::vector<std::string> lines;  // keys with their tables, ready to be copied
  toml::table changes;             // for input/overlay.hpp
  bool to_plane = false;           // whether the case becomes a plane (2D) one first
  // s, when the run then ends, where the case does not say so; 0 = it says so.
  double ends_at = 0.0;
  std::string condition = {};  // under which it ends then, in a clause
};

// Each returns nothing where the change does not apply.
std::optional<CaseChange> draft_quality(const Case& description, const toml::table& written);
// The end that a machine gives the run where none is written.
std::optional<CaseChange> usual_end(const Case& description, const toml::table& written,
                                    const std::string& file);
// An end after so much of the path as shows whether the cut is stationary, where the window
// travels.
std::optional<CaseChange> shorter_path(const Case& description);
// The end of a run whose cut is stationary.
std::optional<CaseChange> stationary_stop(const Case& description);
// The spacing of a workpiece that is finer than its jet.
std::optional<CaseChange> spacing_of_jet(const Case& description, const toml::table& written);
std::optional<CaseChange> double_spacing(const Case& description, const toml::table& written);
std::optional<CaseChange> smaller_piece(const Case& description);
std::optional<CaseChange> smaller_depth(const Case& description);
std::optional<CaseChange> graded_spacing(const Case& description);
std::optional<CaseChange> symmetry_planes(const Case& description);
std::optional<CaseChange> plane_case(const Case& description);

// Returns a case as a plane (2D) one: without its keys of depth, and with points of two entries.
toml::table as_plane_case(const toml::table& written);

}  // namespace kerf
