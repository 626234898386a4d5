// SPDX-License-Identifier: Apache-2.0
// The table of `kerf verify` shows its rows to readers and to programs.
#pragma once

#include <string>
#include <vector>

#include "verification/verify.hpp"

namespace kerf {

std::string table_head();               // for a terminal
std::string table_row(const Row& row);  // one line, and one more for a problem
std::string to_json(const std::vector<Row>& rows);
// Which table of the documentation: that of theory, docs/validation.md, or that of experiments,
// docs/experiments.md, which tells what was calibrated.
enum class TableKind { theory, experiments };

// Returns the section of a case, with its title, its placement elsewhere, its table, the sources of
// its rows and the text `figures`; empty if it has no row.
std::string to_markdown(const VerificationCase& verification, const Findings& findings,
                        TableKind kind, const std::string& figures);

}  // namespace kerf
