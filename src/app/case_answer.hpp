// SPDX-License-Identifier: Apache-2.0
// This header declares what the editor of cases tells of a text while it is written.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

// Returns, for the text of the case `file`: `tables` for the form, null where the text is not valid
// TOML; `problems`, each with path, line, value, what is wrong, what is allowed and a remedy; and,
// where there are none, `check` as kerf check --json prints it without a pilot run, `facts` in
// words, and `drawings`.
nlohmann::ordered_json case_answer(const std::string& text, const std::string& file);

}  // namespace kerf
