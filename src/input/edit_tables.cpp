// SPDX-License-Identifier: Apache-2.0
#include "input/edit_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "input/edit_toml.hpp"
#include "input/parse_toml.hpp"
#include "input/text_places.hpp"
#include "input/toml_path.hpp"

namespace kerf {

namespace {

// The headings of a text, as the offsets of their brackets.
using Headings = std::set<std::size_t>;

class TableText {
 public:
  explicit TableText(const std::string& text)
      : text_(text), root_(parse_toml(text, "the case")), places_(text_) {
    add_node(root_, all_);
  }

  toml::table& root() { return root_; }
  // Returns the text with lines behind the last table whose heading begins with this name.
  std::string with_block(const std::string& name, const std::string& block) const;
  // Returns the text without a table; empty where it has no heading of its own.
  std::string without_block(const toml::table& table) const;

 private:
  // Each adds the headings of a table or list of tables, and of all tables in it.
  void add_heading(const toml::table& table, Headings& headings) const;
  void add_node(const toml::node& node, Headings& headings) const;
  std::size_t block_start(std::size_t heading) const;
  std::size_t block_end(std::size_t heading, const Headings& inner) const;
  bool is_blank_line(std::size_t start) const;
  std::size_t line_before(std::size_t start) const { return places_.line_start(start - 1); }

  std::string text_;
  toml::table root_;
  TextPlaces places_;
  Headings all_;
};

void TableText::add_heading(const toml::table& table, Headings& headings) const {
  const std::size_t at = places_.offset(table.source().begin);
  if (!table.is_inline() && at < text_.size() && text_[at] == '[') headings.insert(at);
  for (const auto& [key, node] : table) add_node(node, headings);
}

void TableText::add_node(const toml::node& node, Headings& headings) const {
  if (const toml::table* table = node.as_table()) add_heading(*table, headings);
  const toml::array* list = node.as_array();
  for (std::size_t n = 0; list && n < list->size(); ++n) add_node(*list->get(n), headings);
}

bool TableText::is_blank_line(std::size_t start) const {
  const std::string line = text_.substr(start, places_.line_end(start) - start);
  return line.find_first_not_of(" \t\r\n") == std::string::npos;
}

// Returns where the lines of a table begin: with the comment directly above its heading, if that is
// set off from what precedes it.
std::size_t TableText::block_start(std::size_t heading) const {
  const std::size_t line = places_.line_start(heading);
  std::size_t start = line;
  const auto is_comment = [&](std::size_t at) {
    const auto first = text_.find_first_not_of(" \t", at);
    return first != std::string::npos && text_[first] == '#';
  };
  while (start > 0 && is_comment(line_before(start))) start = line_before(start);
  const bool is_set_off = start > 0 && is_blank_line(line_before(start));
  return is_set_off ? start : line;
}

// Returns the end of the last line of a table that is not blank.
std::size_t TableText::block_end(std::size_t heading, const Headings& inner) const {
  std::size_t end = text_.size();
  for (auto next = all_.upper_bound(heading); next != all_.end(); ++next)
    if (inner.count(*next) == 0) {
      end = block_start(*next);
      break;
    }
  while (end > 0 && is_blank_line(line_before(end))) end = line_before(end);
  return end;
}

std::string TableText::with_block(const std::string& name, const std::string& block) const {
  const std::string line_end = text_.find("\r\n") != std::string::npos ? "\r\n" : "\n";
  Headings same;
  if (const toml::node* node = root_.get(name)) add_node(*node, same);
  const std::size_t at = same.empty() ? text_.size() : block_end(*same.rbegin(), {});
  std::string added;
  if (at > 0 && text_[at - 1] != '\n') added += '\n';
  if (at > 0) added += '\n';
  added += block;
  if (line_end != "\n")
    for (std::size_t n = added.find('\n'); n != std::string::npos; n = added.find('\n', n + 2))
      added.replace(n, 1, line_end);
  return text_.substr(0, at) + added + text_.substr(at);
}

std::string TableText::without_block(const toml::table& table) const {
  Headings own;
  add_heading(table, own);
  const std::size_t heading = places_.offset(table.source().begin);
  if (own.count(heading) == 0) return {};
  std::size_t begin = block_start(heading);
  const std::size_t end = block_end(heading, own);
  if (begin > 0 && is_blank_line(line_before(begin))) begin = line_before(begin);
  return text_.substr(0, begin) + text_.substr(end);
}

// Removes a table, and the list or table around it where that becomes empty.
void erase(toml::table& root, const PathSteps& steps) {
  toml::table* around = table_at(root, without_last(steps));
  const PathStep& last = steps.back();
  if (last.entry == 0) {
    around->erase(last.name);
    if (around->empty() && steps.size() > 1) erase(root, without_last(steps));
    return;
  }
  toml::array& list = *(*around)[last.name].as_array();
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(last.entry - 1));
  if (list.empty()) around->erase(last.name);
}

}  // namespace

std::string with_table(const std::string& text, std::string_view heading,
                       const std::string& lines) {
  const bool is_list = heading.starts_with("[[");
  const std::size_t brackets = is_list ? 2 : 1;
  const PathSteps steps = steps_of(heading.substr(brackets, heading.size() - 2 * brackets));
  TableText edited(text);
  const std::string changed =
      edited.with_block(steps.front().name, fmt::format("{}\n{}", heading, lines));
  // The text with nothing but the table, which is appended to what the text means.
  toml::table expected = edited.root();
  toml::table added = parse_toml(lines, "the table");
  if (is_list) {
    if (!expected.contains(steps[0].name)) expected.insert(steps[0].name, toml::array{});
    if (toml::array* list = expected[steps[0].name].as_array()) list->push_back(std::move(added));
  } else {
    if (!expected.contains(steps[0].name)) expected.insert(steps[0].name, toml::table{});
    if (toml::table* around = expected[steps[0].name].as_table())
      around->insert(steps.back().name, std::move(added));
  }
  if (!means(changed, expected))
    throw UserError(fmt::format(
        "the form cannot add a table {}, as the case is written. Add it to the text.", heading));
  return changed;
}

std::string without_table(const std::string& text, std::string_view path) {
  const PathSteps steps = steps_of(path);
  TableText edited(text);
  const toml::table* table = steps.empty() ? nullptr : table_at(edited.root(), steps);
  if (!table) throw UserError(fmt::format("there is no table {} in the case", path));
  std::string changed = edited.without_block(*table);
  if (changed.empty() && steps.back().entry == 0) changed = with_value(text, path, "");
  toml::table expected = edited.root();
  erase(expected, steps);
  if (!means(changed, expected))
    throw UserError(fmt::format(
        "{}: the form cannot remove this table, as it is written. Remove it in the text.", path));
  return changed;
}

}  // namespace kerf
