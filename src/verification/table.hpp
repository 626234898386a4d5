// SPDX-License-Identifier: Apache-2.0
// The table of `kerf verify` shows its rows to readers and to programs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/verify.hpp"

namespace kerf {

std::string table_head();               // for a terminal
std::string table_row(const Row& row);  // one line, and one more for a problem
std::string to_json(const std::vector<Row>& rows);
// Returns the tables of docs/validation.md: one for each case, with its title, its sources and the
// text that `figures` has for it.
std::string to_markdown(const std::vector<VerificationCase>& cases, const std::vector<Row>& rows,
                        const std::map<std::string, std::string>& figures);

}  // namespace kerf
