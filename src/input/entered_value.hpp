// SPDX-License-Identifier: Apache-2.0
// Values of keys as a user enters them in a form: 300 MPa, without quotes; lists as 1 mm, 2 mm.
#pragma once

#include <string>
#include <string_view>

#include "core/case_key.hpp"
#include "input/text_places.hpp"

namespace kerf {

// Returns what was entered as TOML; empty for nothing. A text that the key cannot hold gives a
// value that the reader of cases refuses with its remedy.
std::string literal_of(const Key& key, std::string_view entered);

// Returns whether one line can show every value of the key.
bool fits_a_line(const Key& key);

// Returns a value of a file as a user enters it; as it is written, where it is no list of plain
// values.
std::string entered_value(const toml::node& node, const TextPlaces& places);

}  // namespace kerf
