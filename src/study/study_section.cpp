// SPDX-License-Identifier: Apache-2.0
#include "study/read_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/problems.hpp"
#include "input/section.hpp"
#include "study/metrics.hpp"

namespace kerf {

namespace {

std::string range_text(const char* what, double least, double most) {
  if (std::isinf(most)) return fmt::format("{}, at least {}", what, least);
  return fmt::format("{} from {} to {}", what, least, most);
}

}  // namespace

StudySection::StudySection(Problems& problems, const toml::table& table, std::string path)
    : problems_(problems), table_(table), path_(std::move(path)) {
  for (const auto& [name, value] : table_)
    problems_.mention(this->path(name.str()), static_cast<int>(name.source().begin.line),
                      show(value));
}

std::string StudySection::path(std::string_view name) const {
  return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

const toml::node* StudySection::node(std::string_view name) {
  known_.insert(std::string(name));
  return table_.get(name);
}

std::string StudySection::metric(std::string_view name, std::optional<std::string> fallback) {
  std::string metric = text(name, std::move(fallback));
  if (has(name)) check_metric(name, metric);
  return metric;
}

std::vector<std::string> StudySection::metrics(std::string_view name) {
  std::vector<std::string> list = texts(name);
  for (const std::string& metric : list) check_metric(name, metric);
  return list;
}

void StudySection::check_metric(std::string_view name, const std::string& metric) {
  const std::string problem = why_no_number(metric);
  if (problem.empty()) return;
  const std::string guess = closest(metric, number_names());
  refuse(name, problem, "a number of result.json; docs/metrics.md has all of them",
         guess.empty() ? "Name a number" : fmt::format("Did you mean \"{}\"?", guess));
}

void StudySection::missing(std::string_view name, const std::string& allowed) {
  refuse(name, "the key is missing", allowed, "Add it");
}

std::string StudySection::text(std::string_view name, std::optional<std::string> fallback) {
  const toml::node* found = node(name);
  if (!found) {
    if (!fallback) missing(name, "a text");
    return fallback.value_or("");
  }
  const auto value = found->value_exact<std::string>();
  if (!value) refuse(name, "this is no text", "a text", "Put it between quotes");
  return value.value_or("");
}

double StudySection::number(std::string_view name, double least, double most,
                            std::optional<double> fallback) {
  const std::string allowed = range_text("a number without unit", least, most);
  const toml::node* found = node(name);
  if (!found) {
    if (!fallback) missing(name, allowed);
    return fallback.value_or(least);
  }
  const double value = found->is_number() ? *found->value<double>() : std::nan("");
  if (value >= least && value <= most) return value;
  refuse(name, std::isnan(value) ? "this is no number" : "the value is out of range", allowed,
         "Choose a value in the range");
  return least;
}

int StudySection::whole(std::string_view name, int least, int most, std::optional<int> fallback) {
  const double value =
      number(name, least, most, fallback ? std::optional<double>(*fallback) : std::nullopt);
  if (value != std::floor(value))
    refuse(name, "this is no whole number", range_text("a whole number", least, most),
           "Choose a whole number");
  return static_cast<int>(value);
}

std::size_t StudySection::word(std::string_view name, std::span<const std::string_view> words,
                               std::optional<std::size_t> fallback) {
  if (fallback && !has(name)) {
    node(name);
    return *fallback;
  }
  const std::string allowed = fmt::format("\"{}\"", fmt::join(words, "\", \""));
  if (!node(name)) return missing(name, allowed), 0;
  const std::string written = text(name);
  const auto found = std::find(words.begin(), words.end(), written);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  refuse(name, "the word is unknown", allowed, "Choose one of them");
  return fallback.value_or(0);
}

std::vector<std::string> StudySection::texts(std::string_view name) {
  std::vector<std::string> result;
  const toml::node* found = node(name);
  if (!found) return result;
  const toml::array* list = found->as_array();
  if (!list) {
    refuse(name, "this is no list", "a list of texts", "Write [\"...\", \"...\"]");
    return result;
  }
  for (const toml::node& entry : *list) {
    if (const auto value = entry.value_exact<std::string>())
      result.push_back(*value);
    else
      refuse(name, "an entry is no text", "a list of texts", "Put each between quotes");
  }
  return result;
}

const toml::table* StudySection::table(std::string_view name) {
  const toml::node* found = node(name);
  if (!found) return nullptr;
  if (!found->is_table()) refuse(name, "this is no table", "a table", "See docs/studies.md");
  return found->as_table();
}

std::vector<const toml::table*> StudySection::tables(std::string_view name) {
  std::vector<const toml::table*> result;
  const toml::node* found = node(name);
  if (!found) return result;
  if (const toml::array* list = found->as_array())
    for (const toml::node& entry : *list)
      if (entry.is_table()) result.push_back(entry.as_table());
  const toml::array* list = found->as_array();
  if (!list || result.size() != list->size())
    refuse(name, "this is no list of tables", "a list of tables", "See docs/studies.md");
  return result;
}

void StudySection::refuse(std::string_view name, const std::string& what,
                          const std::string& allowed, const std::string& remedy) {
  problems_.add({path(name), what, allowed, remedy});
}

void StudySection::refuse_unknown() {
  const std::vector<std::string> names(known_.begin(), known_.end());
  for (const auto& [name, value] : table_) {
    if (known_.count(std::string(name.str()))) continue;
    const std::string guess = closest(name.str(), names);
    refuse(name.str(), "a study has no such key here", fmt::format("{}", fmt::join(names, ", ")),
           guess.empty() ? "Remove it" : fmt::format("Did you mean \"{}\"?", guess));
  }
}

}  // namespace kerf
