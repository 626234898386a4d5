// SPDX-License-Identifier: Apache-2.0
// TomlWriter writes the tables of a case file by the schema.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "input/schema.hpp"

namespace kerf {

struct Body;
struct Case;
struct Jet;
struct Load;
struct Material;
struct OutputControl;
struct Probe;
struct Shape;

std::string toml_string(std::string_view text);

// Keys with their values as TOML that no single member stores; they take precedence over members.
using WrittenKeys = std::map<std::string_view, std::string>;

class TomlWriter {
 public:
  // The dimension and the formulation of the case are conditions of all keys.
  explicit TomlWriter(const Case& description);

  // Writes a table: the keys that apply there, in the order of the schema. `conditions`: conditions
  // in addition to the words that the keys hold.
  template <class Structure>
  void table(const std::string& heading, std::string_view section, const Structure& structure,
             const WrittenKeys& others = {}, const std::set<std::string>& conditions = {}) {
    text_ += heading.empty() ? "" : "\n" + heading + "\n";
    for (const std::string& line : lines(section, structure, others, conditions))
      text_ += line + "\n";
  }
  // Returns the table as the value of a key: "{ type = "box", ... }".
  template <class Structure>
  std::string inline_table(std::string_view section, const Structure& structure,
                           const WrittenKeys& others = {}) const {
    return braced(lines(section, structure, others, {}));
  }

  const std::string& result() const { return text_; }

 private:
  template <class Structure>
  std::vector<std::string> lines(std::string_view section, const Structure& structure,
                                 const WrittenKeys& others,
                                 std::set<std::string> conditions) const {
    conditions.insert(conditions_.begin(), conditions_.end());
    keys_stored_in(section, structure, conditions);  // adds the words
    return lines(section, &structure_id<Structure>, const_cast<Structure*>(&structure), others,
                 conditions);
  }
  std::vector<std::string> lines(std::string_view section, const void* id, void* structure,
                                 const WrittenKeys& others,
                                 const std::set<std::string>& conditions) const;
  static std::string braced(const std::vector<std::string>& lines);

  std::size_t dimension_;
  std::set<std::string> conditions_;
  std::string text_;
};

// Each of these functions writes a table of a case. It is in the file that reads the table.
void write_top(TomlWriter& writer, const Case& description);
void write_material(TomlWriter& writer, const Material& material);
void write_body(TomlWriter& writer, const Case& description, const Body& body);
void write_workpiece(TomlWriter& writer, const Case& description);
void write_load(TomlWriter& writer, const Load& load);
void write_machine(TomlWriter& writer, const Case& description);
void write_jet(TomlWriter& writer, const Case& description, const Jet& jet);
void write_probe(TomlWriter& writer, const Probe& probe);
void write_extras(TomlWriter& writer, const Case& description);
void write_output(TomlWriter& writer, const OutputControl& output);

// Returns a shape, including its parts, as one inline table, which TOML requires to be on one line.
std::string shape_text(const TomlWriter& writer, const Shape& shape);
// Returns the name of a material of the case in quotes.
std::string material_text(const Case& description, int material);

}  // namespace kerf
