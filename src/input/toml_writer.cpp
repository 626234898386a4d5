// SPDX-License-Identifier: Apache-2.0
#include "input/toml_writer.hpp"

#include <fmt/format.h>

#include <cmath>

#include "input/units.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// Returns the value of a key as TOML; empty if the value is empty and is not written.
struct ValueText {
  const Key& key;
  std::size_t dimension;

  std::string operator()(const double* value) const {
    if (std::isinf(*value)) return toml_string("none");
    return key.unit.empty() ? shortest(*value)
                            : toml_string(write_quantity(*value, std::string(key.unit)));
  }
  std::string operator()(const int* value) const { return std::to_string(*value); }
  std::string operator()(const std::uint64_t* value) const { return std::to_string(*value); }
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const std::string* value) const {
    const bool optional_name = key.kind == ValueKind::name && !key.required();
    return value->empty() && optional_name ? std::string() : toml_string(*value);
  }
  std::string operator()(const Point* value) const {
    std::vector<std::string> entries;
    for (std::size_t a = 0; a < dimension; ++a) entries.push_back((*this)(&(*value)[a]));
    return list(entries);
  }
  std::string operator()(const std::array<std::string, 3>* formulas) const {
    if (formulas->front().empty()) return {};
    std::vector<std::string> entries;
    for (std::size_t a = 0; a < dimension; ++a) entries.push_back(toml_string((*formulas)[a]));
    return list(entries);
  }
  std::string operator()(const std::vector<double>* values) const {
    std::vector<std::string> entries;
    for (const double& value : *values) entries.push_back((*this)(&value));
    return list(entries);
  }
  std::string operator()(const std::vector<std::array<double, 2>>* corners) const {
    std::vector<std::string> entries;
    for (const auto& corner : *corners)
      entries.push_back(list({(*this)(&corner[0]), (*this)(&corner[1])}));
    return list(entries);
  }
  std::string operator()(const Faces* faces) const {
    std::vector<std::string> entries;
    for (std::size_t side = 0; side < key.choices.size(); ++side)
      if ((side % 2 == 0 ? faces->minimum : faces->maximum)[side / 2])
        entries.push_back(toml_string(key.choices[side]));
    return entries.empty() ? std::string() : list(entries);
  }
  std::string operator()(const WordReference& word) const {
    return toml_string(key.choices[word.get(word.value)]);
  }

  static std::string list(const std::vector<std::string>& entries) {
    return fmt::format("[{}]", fmt::join(entries, ", "));
  }
};

}  // namespace

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < ' ' || c == 127)
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + "\"";
}

TomlWriter::TomlWriter(const Case& description)
    : dimension_(static_cast<std::size_t>(description.dimension)),
      conditions_{description.dimension == 2 ? "2D" : "3D",
                  formulation_name(description.formulation)} {}

std::vector<std::string> TomlWriter::lines(std::string_view section, const void* id,
                                           void* structure, const WrittenKeys& others,
                                           const std::set<std::string>& conditions) const {
  std::vector<std::string> result;
  for (const Key& key : keys_of(section)) {
    if (!key.applies_under(conditions)) continue;
    std::string value;
    if (const auto found = others.find(key.name); found != others.end())
      value = found->second;
    else if (key.member.structure == id)
      value = std::visit(ValueText{key, dimension_}, key.member.of(structure));
    if (!value.empty()) result.push_back(fmt::format("{} = {}", key.name, value));
  }
  return result;
}

std::string TomlWriter::braced(const std::vector<std::string>& lines) {
  return fmt::format("{{ {} }}", fmt::join(lines, ", "));
}

}  // namespace kerf
