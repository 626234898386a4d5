// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "input/section.hpp"
#include "input/units.hpp"
#include "study/read_study.hpp"

namespace kerf {

namespace {

constexpr int most_levels = 1000;

const char* remedy_of_list = "Write [value, ...] or { from = ..., to = ..., count = ... }";

}  // namespace

std::string unit_of(const toml::node& node) {
  const std::string text = node.value_or(std::string());
  const auto start = text.find_first_not_of(" +-.0123456789eE");
  return start == std::string::npos ? "" : text.substr(start);
}

void for_each_key(const toml::table& table, const std::string& prefix,
                  const std::function<bool(const toml::table&)>& is_leaf,
                  const std::function<void(const std::string& path, const toml::node&)>& leaf) {
  for (const auto& [name, node] : table) {
    const std::string path =
        prefix.empty() ? std::string(name.str()) : fmt::format("{}.{}", prefix, name.str());
    const toml::table* inner = node.as_table();
    if (inner && !is_leaf(*inner))
      for_each_key(*inner, path, is_leaf, leaf);
    else
      leaf(path, node);
  }
}

void AxisReader::refuse(const std::string& reported_key, const std::string& what,
                        const std::string& allowed, const std::string& remedy) {
  problems_.add({reported_key, what, allowed, remedy});
}

void AxisReader::note(const std::string& table, const std::string& path,
                      const std::string& reported_key, const toml::node& node) {
  const KeyPath found = find_key_path(path, base_);
  const int line = static_cast<int>(node.source().begin.line);
  problems_.mention(reported_key, line, show(node));
  if (found.problem.empty()) named_.push_back({table, reported_key, line, found});
}

std::optional<KeyPath> AxisReader::key(const std::string& path, const std::string& reported_key) {
  KeyPath result = find_key_path(path, base_);
  if (result.problem.empty()) return result;
  refuse(reported_key, result.problem,
         "a key of the case, such as \"machine.pressure\" or, of lists, "
         "\"body.NAME.spacing\"",
         "docs/keys.md has all keys");
  return std::nullopt;
}

std::optional<double> AxisReader::number(const KeyPath& path, const std::string& reported_key,
                                         const toml::node& node) {
  const Key& key = *path.key;
  const std::string allowed = allowed_text(key);
  double value = 0.0;
  if (key.unit.empty()) {
    if (!node.is_number()) {
      refuse(reported_key, "this is no number", allowed, remedy_of_list);
      return std::nullopt;
    }
    value = *node.value<double>();
  } else {
    const auto written = node.value_exact<std::string>();
    const Quantity quantity =
        written ? read_quantity(*written, path.unit()) : Quantity{0.0, "a unit is missing"};
    if (!quantity.problem.empty()) {
      refuse(reported_key, fmt::format("{}: {}", show(node), quantity.problem), allowed,
             fmt::format("Write a text such as \"{}\"", example_of(path.unit())));
      return std::nullopt;
    }
    value = quantity.value;
  }
  if (in_range(key, value)) return value;
  refuse(reported_key, fmt::format("{} is out of range", show(node)), allowed,
         "Choose a value in the range");
  return std::nullopt;
}

std::optional<Axis> AxisReader::axis(const std::string& path, const std::string& reported_key,
                                     const toml::node& node) {
  auto found = key(path, reported_key);
  if (!found) return std::nullopt;
  if (const toml::array* values = node.as_array()) return list(*found, reported_key, *values);
  if (const toml::table* table = node.as_table())
    return range_of_table(*found, reported_key, *table);
  return list(*found, reported_key, toml::array{node});
}

std::optional<Axis> AxisReader::list(KeyPath path, const std::string& reported_key,
                                     const toml::array& values) {
  Axis axis;
  axis.path = std::move(path);
  if (values.empty()) {
    refuse(reported_key, "the list is empty", "at least one value", remedy_of_list);
    return std::nullopt;
  }
  const ValueKind kind = axis.path.key->kind;
  const bool is_word =
      kind == ValueKind::word || kind == ValueKind::name || kind == ValueKind::text;
  if (!is_word && !axis.path.is_number()) {
    refuse(reported_key, "a study cannot vary this key as a whole",
           "a key that holds one number or word",
           "Name one number of a list by its index, from 0: \"....position.0\"");
    return std::nullopt;
  }
  // With "none" among them, values are words as they are written: it is no number.
  const bool has_none = axis.path.key->may_be_none() &&
                        std::any_of(values.begin(), values.end(), [](const toml::node& value) {
                          return value.value_exact<std::string>() == "none";
                        });
  for (const toml::node& value : values) {
    const std::string text = value.value_or(std::string());
    if (is_word || (has_none && text == "none")) {
      axis.words.push_back(text);
      continue;
    }
    const auto number = this->number(axis.path, reported_key, value);
    if (!number) return std::nullopt;
    if (has_none)
      axis.words.push_back(text.empty() ? fmt::format("{}", *number) : text);
    else
      axis.values.push_back(*number);
  }
  if (!has_none) axis.shown_unit = unit_of(*values.get(0));
  return axis;
}

std::optional<Axis> AxisReader::range_of_table(KeyPath path, const std::string& reported_key,
                                               const toml::table& table) {
  StudySection section(problems_, table, reported_key);
  const toml::node *from = section.node("from"), *to = section.node("to");
  const int count = section.whole("count", 2, most_levels, 5);
  const bool is_logarithmic = section.word("scale", scale_words, 0) == 1;
  section.refuse_unknown();
  auto axis = range(path.text, reported_key, from, to);
  if (!axis) return std::nullopt;
  axis->is_logarithmic = is_logarithmic;
  fill(*axis, axis->values.front(), axis->values.back(), count, reported_key);
  return axis;
}

std::optional<Axis> AxisReader::range(const std::string& path, const std::string& reported_key,
                                      const toml::node* from, const toml::node* to) {
  const auto found = key(path, reported_key);
  if (!found) return std::nullopt;
  if (!from || !to || !found->is_number()) {
    refuse(reported_key, "a range needs two numbers, from and to", allowed_text(*found->key),
           remedy_of_list);
    return std::nullopt;
  }
  const auto first = number(*found, reported_key, *from), last = number(*found, reported_key, *to);
  if (!first || !last) return std::nullopt;
  if (*first >= *last) {
    refuse(reported_key, fmt::format("from = {} is not less than to = {}", show(*from), show(*to)),
           allowed_text(*found->key), "Swap or correct them");
    return std::nullopt;
  }
  Axis axis;
  axis.path = *found;
  axis.shown_unit = unit_of(*from);
  axis.is_range = true;
  axis.values = {*first, *last};
  return axis;
}

void AxisReader::fill(Axis& axis, double from, double to, int count,
                      const std::string& reported_key) {
  if (axis.is_logarithmic && from <= 0.0) {
    refuse(reported_key, "a range of ratios starts at 0 or below", "from greater than 0",
           "Correct from, or write scale = \"linear\"");
    axis.is_logarithmic = false;
  }
  axis.values.clear();
  for (int i = 0; i < count; ++i)
    axis.values.push_back(
        between(from, to, static_cast<double>(i) / (count - 1), axis.is_logarithmic));
  axis.values.back() = to;
}

}  // namespace kerf
