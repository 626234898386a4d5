// SPDX-License-Identifier: Apache-2.0
// The rows of `kerf verify` for people and for programs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verify/verify.hpp"

namespace kerf {

std::string table_head();               // for a terminal
std::string table_row(const Row& row);  // one line, and one more for a problem
std::string to_json(const std::vector<Row>& rows);
// For docs/validation.md: one table for each case, with its title and sources, and what `figures`
// has for it.
std::string to_markdown(const std::vector<VerificationCase>& cases, const std::vector<Row>& rows,
                        const std::map<std::string, std::string>& figures);

}  // namespace kerf
