// SPDX-License-Identifier: Apache-2.0
// Pieces of TOML as case files have them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace kerf {

std::string quoted(std::string_view text);

// Writes the keys of one table; units come from the schema.
class TomlWriter {
 public:
  explicit TomlWriter(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {}

  void open(const std::string& heading, std::string section);
  void raw(std::string_view name, const std::string& value);
  void text(std::string_view name, std::string_view value) { raw(name, quoted(value)); }
  void number(std::string_view name, double value) { raw(name, number_text(name, value)); }
  void numbers(std::string_view name, const std::vector<double>& values);
  void vector(std::string_view name, const Point& point);
  void expressions(std::string_view name, const std::array<std::string, 3>& formulas);
  void faces(std::string_view name, const Faces& faces);
  // A number as the key of that name wants it: plain, or a text with its unit.
  std::string number_text(std::string_view name, double value) const;
  const std::string& result() const { return text_; }

 private:
  std::size_t dimension_;
  std::string section_;
  std::string text_;
};

// A shape as one inline table: TOML keeps those on one line, parts and all.
std::string shape_text(const Shape& shape, int dimension);

}  // namespace kerf
