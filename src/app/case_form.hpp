// SPDX-License-Identifier: Apache-2.0
// This header declares the form in which kerf view --edit shows a case. It follows from the schema.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

// Returns what does not depend on the case: the sections with their keys, the materials of the
// library and the templates.
nlohmann::ordered_json form_schema();

// Returns the tables of a case, those that it lacks included, in the order of the form: each with
// the keys that apply there and their values. A key names its row in form_schema(). Throws the
// CaseError of a text that is not valid TOML.
nlohmann::ordered_json form_tables(const std::string& text);

}  // namespace kerf
