// SPDX-License-Identifier: Apache-2.0
// The places of a TOML text: the parser names them by line and column, in characters; these
// functions convert them to bytes.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

namespace kerf {

class TextPlaces {
 public:
  explicit TextPlaces(const std::string& text);

  std::size_t offset(const toml::source_position& place) const;
  std::size_t line_start(std::size_t offset) const;
  // Returns the first byte after the line, whose end is included.
  std::size_t line_end(std::size_t offset) const;
  // Returns the text of a value or key as it is written.
  std::string slice(const toml::source_region& region) const;
  const std::string& text() const { return text_; }

 private:
  const std::string& text_;
  std::vector<std::size_t> lines_;  // offset of the start of each
};

}  // namespace kerf
