// SPDX-License-Identifier: Apache-2.0
// This header declares the tables that the form of a case adds: another body, jet, load, probe or
// material, with values to start from.
#pragma once

#include <string>
#include <string_view>

namespace kerf {

// Returns whether a case may hold several tables of a section, by the heading in the schema:
// `[[body]]` or `[materials.NAME]`.
bool is_repeatable(std::string_view section);

// Returns whether the tables of a section are a list; else their headings name them.
bool is_list(std::string_view section);

// Returns the word for one table of a repeatable section: "body", "material".
std::string word_of_table(std::string_view section);

struct NewTable {
  std::string text;  // of the case with the table
  std::string path;  // of the table
};

// Returns the case with another table of a repeatable section. Every key that must be given has a
// value: one that suits the case where Kerf can tell, such as a box below the other bodies, else an
// example of what the key takes. `file` names the case and the folder of its meshes; `name` is that
// of the table, and empty for a name that is free. Throws a UserError where the table cannot be
// added.
NewTable with_new_table(const std::string& text, const std::string& file, std::string_view section,
                        const std::string& name);

}  // namespace kerf
