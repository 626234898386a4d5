// SPDX-License-Identifier: Apache-2.0
#include "study/key_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/error.hpp"
#include "input/material_library.hpp"
#include "input/overlay.hpp"
#include "input/problems.hpp"
#include "input/units.hpp"

namespace kerf {

namespace {

std::optional<std::size_t> as_index(const std::string& word) {
  std::size_t index = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, index);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return index;
}

std::string name_of(const toml::node& entry) {
  const toml::table* table = entry.as_table();
  return table ? (*table)["name"].value_or(std::string()) : std::string();
}

// Returns the entry of a list by its name or number; null when there is none.
toml::node* entry_of(toml::array& list, const std::string& word) {
  if (toml::table* entry = entry_named(list, word)) return entry;
  const auto index = as_index(word);
  return index && *index < list.size() ? list.get(*index) : nullptr;
}

std::ptrdiff_t number_of(const toml::array& list, const toml::node& entry) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const toml::node& each) { return &each == &entry; });
  return found - list.begin();
}

// Returns all keys of a section, whatever they apply to.
std::vector<std::string> names_in(std::string_view section) {
  std::vector<std::string> names;
  for (const Key& key : keys_of(section)) names.emplace_back(key.name);
  return names;
}

std::string lacks(const std::string& what, const std::string& word,
                  const std::vector<std::string>& known) {
  const std::string guess = closest(word, known);
  std::string sentence = fmt::format("{} \"{}\"", what, word);
  if (!guess.empty()) sentence += fmt::format(" (did you mean \"{}\"?)", guess);
  return sentence;
}

std::string_view section_of(const Key& key) {
  return key.name == "around" || key.name == "parts" ? "shape" : key.name;
}

// Follows a path downwards; `node` is null where the case writes nothing.
struct Walk {
  KeyPath& path;
  toml::node* node = nullptr;
  std::string_view section;
  std::size_t at = 0;

  bool is_done() const { return at == path.segments.size() || !path.problem.empty(); }
  void fail(std::string problem) { path.problem = std::move(problem); }
  toml::node* child(const std::string& name) const {
    toml::table* table = node ? node->as_table() : nullptr;
    return table ? table->get(name) : nullptr;
  }

  void enter(std::string_view word) {
    path.place += fmt::format("{}{}", path.place.empty() ? "" : ".", word);
  }

  void step() {
    const std::string& word = path.segments[at++];
    enter(word);
    const Key* key = find_key(section, word, {});
    if (!key)
      return fail(lacks(
          section.empty() ? "a case has no key" : fmt::format("[{}] of a case has no key", section),
          word, names_in(section)));
    node = child(word);
    if (key->name == "materials" && section.empty())
      step_into_material();
    else if (key->kind == ValueKind::tables)
      step_into_list(*key);
    else if (key->kind == ValueKind::table)
      section = section_of(*key);
    else
      end_at(*key);
  }

  void step_into_material() {
    section = "materials";
    if (at == path.segments.size()) return fail("the path ends at a table, not at a key");
    const std::string& name = path.segments[at++];
    enter(name);
    node = child(name);
    if (!node && !find_library_material(name))
      fail(lacks("neither the case nor the library has a material", name, {}));
  }

  void step_into_list(const Key& key) {
    if (at == path.segments.size()) return fail("the path ends at a list, not at a key");
    const std::string& word = path.segments[at++];
    toml::array* list = node ? node->as_array() : nullptr;
    std::vector<std::string> names;
    if (list)
      for (const toml::node& entry : *list) names.push_back(name_of(entry));
    node = list ? entry_of(*list, word) : nullptr;
    if (!node)
      fail(lacks(fmt::format("the case has no {} of the name or number", key.name), word, names));
    else
      enter(std::to_string(number_of(*list, *node)));
    section = section_of(key);
  }

  void end_at(const Key& key) {
    path.key = &key;
    if (at == path.segments.size()) return;
    const std::string& word = path.segments[at++];
    toml::array* list = node ? node->as_array() : nullptr;
    if (key.kind != ValueKind::vector || at != path.segments.size())
      fail(fmt::format("\"{}\" has no entries with names or numbers", key.name));
    else if (!list || !as_index(word) || *as_index(word) >= list->size())
      fail(fmt::format("the case writes no \"{}\" with an entry {} (the first is 0)", key.name,
                       word));
    else
      enter(std::to_string(*as_index(word)));
  }
};

// Returns the table or list that holds the last segment; it is made where the case has none.
toml::node& holder_of(toml::table& case_table, const KeyPath& path) {
  toml::node* node = &case_table;
  for (std::size_t i = 0; i + 1 < path.segments.size(); ++i) {
    const std::string& word = path.segments[i];
    if (toml::array* list = node->as_array()) {
      node = entry_of(*list, word);
      continue;
    }
    toml::table& table = *node->as_table();
    if (!table.contains(word)) {
      toml::table made;
      if (i == 1 && path.segments[0] == "materials") made.insert("base", word);
      table.insert(word, std::move(made));
    }
    node = table.get(word);
  }
  return *node;
}

}  // namespace

bool KeyPath::is_number() const {
  const ValueKind kind = key->kind;
  return kind == ValueKind::number || kind == ValueKind::integer || kind == ValueKind::quantity ||
         (kind == ValueKind::vector && as_index(segments.back()));
}

KeyPath find_key_path(const std::string& path, const toml::table& case_table) {
  KeyPath result;
  result.text = path;
  result.segments = split_words(path, '.');
  toml::table copy = case_table;
  Walk pair_loop{result, &copy, "", 0};
  while (!pair_loop.is_done()) pair_loop.step();
  if (result.problem.empty() && !result.key)
    result.problem = "the path ends at a table, not at a key";
  return result;
}

toml::node* find_value(toml::table& case_table, const KeyPath& path) {
  toml::node* node = &case_table;
  for (const std::string& word : path.segments) {
    if (!node) return nullptr;
    if (toml::array* list = node->as_array())
      node = entry_of(*list, word);
    else
      node = node->is_table() ? node->as_table()->get(word) : nullptr;
  }
  return node;
}

void set_key(toml::table& case_table, const KeyPath& path, const toml::node& value) {
  toml::node& holder = holder_of(case_table, path);
  const std::string& last = path.segments.back();
  value.visit([&](const auto& concrete) {
    if (toml::array* list = holder.as_array())
      list->replace(list->cbegin() + static_cast<std::ptrdiff_t>(*as_index(last)), concrete);
    else
      holder.as_table()->insert_or_assign(last, concrete);
  });
}

void set_number(toml::table& case_table, const KeyPath& path, double value) {
  require(path.is_number(), "a number is set for a key that cannot have one");
  if (path.key->kind == ValueKind::integer)
    set_key(case_table, path, toml::value<std::int64_t>(static_cast<std::int64_t>(value)));
  else if (path.key->unit.empty())
    set_key(case_table, path, toml::value<double>(value));
  else
    set_key(case_table, path, toml::value<std::string>(write_quantity(value, path.unit())));
}

}  // namespace kerf
