// SPDX-License-Identifier: Apache-2.0
// The reference of result.json, written from the table of metrics.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

// Returns the table of docs/metrics.md: name, unit, label and meaning of every metric, as Markdown.
std::string metrics_table();

// Returns docs/result.schema.json: the JSON Schema (draft 7) of result.json. Beside the keywords of
// the standard each number has "unit" and, where it differs in two dimensions, "unit_2d".
nlohmann::ordered_json result_schema();

}  // namespace kerf
