// SPDX-License-Identifier: Apache-2.0
#include "input/edit_toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "input/parse_toml.hpp"
#include "input/text_places.hpp"
#include "input/toml_path.hpp"

namespace kerf {

namespace {

// What the text must mean after the change.
void change(toml::table& root, const PathSteps& steps, const toml::node* value) {
  const PathSteps around = without_last(steps);
  toml::table* parent = table_at(root, around);
  if (value && !parent) {
    change(root, around, toml::parse("x = {}").get("x"));
    parent = table_at(root, around);
  }
  if (value)
    value->visit([&](const auto& plain) { parent->insert_or_assign(steps.back().name, plain); });
  else
    parent->erase(steps.back().name);
  const bool is_removable = !around.empty() && around.back().entry == 0;
  if (!value && parent->empty() && is_removable) change(root, around, nullptr);
}

class TomlEdit {
 public:
  explicit TomlEdit(const std::string& text)
      : text_(text), root_(parse_toml(text, "the case")), places_(text_) {}

  std::string set(const PathSteps& steps, const std::string& literal);

 private:
  bool is_header(const toml::key& key, const toml::node& node) const {
    return places_.offset(node.source().begin) < places_.offset(key.source().begin);
  }
  std::size_t end_of(const toml::node& node) const;
  std::string replaced(std::size_t begin, std::size_t end, const std::string& by) const {
    return text_.substr(0, begin) + by + text_.substr(end);
  }
  std::string with_line(std::size_t at, const std::string& line) const;
  std::string with_table(const PathSteps& steps, const std::string& literal);
  std::string with_key(const toml::table& parent, const std::string& name,
                       const std::string& literal) const;
  std::string with_key_inline(const toml::table& parent, const std::string& assignment) const;
  std::string without_key(const PathSteps& steps, const toml::table& parent);
  std::string without_key_inline(const toml::key& key, const toml::node& node) const;

  std::string text_;
  toml::table root_;
  TextPlaces places_;
};

// Returns the end of a value; the region of a dotted table ends before its values.
std::size_t TomlEdit::end_of(const toml::node& node) const {
  std::size_t end = places_.offset(node.source().end);
  const toml::table* table = node.as_table();
  if (!table || table->is_inline()) return end;
  for (const auto& [key, value] : *table)
    if (!is_header(key, value)) end = std::max(end, end_of(value));
  return end;
}

std::string TomlEdit::with_line(std::size_t at, const std::string& line) const {
  const std::string end = text_.find("\r\n") != std::string::npos ? "\r\n" : "\n";
  const bool needs_end = at > 0 && text_[at - 1] != '\n';
  return replaced(at, at, (needs_end ? end : "") + line + end);
}

std::string TomlEdit::with_key_inline(const toml::table& parent,
                                      const std::string& assignment) const {
  const toml::source_region& region = parent.source();
  if (parent.empty())
    return replaced(places_.offset(region.begin), places_.offset(region.end),
                    fmt::format("{{ {} }}", assignment));
  std::size_t end = 0;
  for (const auto& [key, value] : parent) end = std::max(end, end_of(value));
  return replaced(end, end, ", " + assignment);
}

// Adds a line below the last value of the table, or below its heading.
std::string TomlEdit::with_key(const toml::table& parent, const std::string& name,
                               const std::string& literal) const {
  const std::string assignment = fmt::format("{} = {}", name, literal);
  if (parent.is_inline()) return with_key_inline(parent, assignment);
  std::optional<std::size_t> last_end;
  std::string prefix;  // indentation, or the names of a dotted table
  for (const auto& [key, value] : parent) {
    if (is_header(key, value) || end_of(value) < last_end.value_or(0)) continue;
    last_end = end_of(value);
    const std::size_t begin = places_.offset(key.source().begin);
    prefix = text_.substr(places_.line_start(begin), begin - places_.line_start(begin));
  }
  if (last_end) return with_line(places_.line_end(*last_end), prefix + assignment);
  if (&parent != &root_)
    return with_line(places_.line_end(places_.offset(parent.source().begin)), assignment);
  return with_line(0, assignment);
}

std::string TomlEdit::with_table(const PathSteps& steps, const std::string& literal) {
  const PathSteps around = without_last(steps);
  const std::string assignment = fmt::format("{} = {}", steps.back().name, literal);
  if (around.back().entry > 0)
    throw UserError(fmt::format("there is no table {}[{}] in the case. Add it to the text.",
                                around.back().name, around.back().entry));
  const bool is_inner = around.size() > 1 && around.front().name != "materials";
  if (is_inner) return set(around, fmt::format("{{ {} }}", assignment));
  std::string heading = around.front().name;
  if (around.size() > 1) heading += "." + around[1].name;
  return with_line(text_.size(),
                   fmt::format("{}[{}]\n{}", text_.empty() ? "" : "\n", heading, assignment));
}

std::string TomlEdit::without_key_inline(const toml::key& key, const toml::node& node) const {
  std::size_t begin = places_.offset(key.source().begin), end = end_of(node);
  const auto before = text_.find_last_not_of(" \t", begin - 1);
  if (text_[before] == ',') return replaced(before, end, "");
  const auto after = text_.find_first_not_of(" \t", end);
  if (text_[after] == ',') end = text_.find_first_not_of(" \t", after + 1);
  return replaced(begin, end, "");
}

std::string TomlEdit::without_key(const PathSteps& steps, const toml::table& parent) {
  const auto found = parent.find(steps.back().name);
  if (found == parent.end()) return text_;
  const PathSteps around = without_last(steps);
  const bool is_alone = parent.size() == 1 && !around.empty() && around.back().entry == 0;
  if (parent.is_inline())
    return is_alone ? set(around, "") : without_key_inline(found->first, found->second);
  const std::size_t begin = places_.line_start(places_.offset(found->first.source().begin));
  std::string left = replaced(begin, places_.line_end(end_of(found->second)), "");
  const std::size_t heading = places_.offset(parent.source().begin);
  if (!is_alone || text_[heading] != '[') return left;
  const std::size_t start = places_.line_start(heading);
  left.erase(start, places_.line_end(heading) - start);
  const bool is_gap = start > 1 && left.compare(start - 2, 2, "\n\n") == 0;
  if (is_gap && (start == left.size() || left[start] == '\n')) left.erase(start - 1, 1);
  return left;
}

std::string TomlEdit::set(const PathSteps& steps, const std::string& literal) {
  const toml::table* parent = table_at(root_, without_last(steps));
  if (literal.empty()) return parent ? without_key(steps, *parent) : text_;
  if (!parent) return with_table(steps, literal);
  const toml::node* node = parent->get(steps.back().name);
  if (!node) return with_key(*parent, steps.back().name, literal);
  return replaced(places_.offset(node->source().begin), end_of(*node), literal);
}

// Returns what the changed text must mean.
toml::table expected_table(const std::string& text, const PathSteps& steps,
                           const std::string& literal) {
  toml::table root = parse_toml(text, "the case");
  if (literal.empty()) {
    const toml::table* parent = table_at(root, without_last(steps));
    if (parent && parent->contains(steps.back().name)) change(root, steps, nullptr);
    return root;
  }
  const toml::table value = parse_toml(fmt::format("x = {}\n", literal), "the value");
  change(root, steps, value.get("x"));
  return root;
}

}  // namespace

std::string with_value(const std::string& text, std::string_view path, const std::string& literal) {
  const PathSteps steps = steps_of(path);
  if (steps.empty()) throw UserError("no key is named");
  const std::string changed = TomlEdit(text).set(steps, literal);
  if (!means(changed, expected_table(text, steps, literal)))
    throw UserError(fmt::format(
        "{}: the form cannot change this key, as it is written. Change it in the text.", path));
  return changed;
}

}  // namespace kerf
