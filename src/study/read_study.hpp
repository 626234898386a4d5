// SPDX-License-Identifier: Apache-2.0
// This header declares the readers of a study file: one table of it, the varied keys with their
// values, and the goals. What is missing or wrong is noted as a problem and replaced by a harmless
// value, so that reading continues; read_study() throws at the end.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/problems.hpp"
#include "study/axis.hpp"
#include "study/named_keys.hpp"
#include "study/study_plan.hpp"

namespace kerf {

inline constexpr int most_runs = 100000;                                        // of a study
inline constexpr std::array<std::string_view, 2> scale_words{"linear", "log"};  // of a range

// One table of a study file.
class StudySection {
 public:
  StudySection(Problems& problems, const toml::table& table, std::string path);

  bool has(std::string_view name) const { return table_.contains(name); }
  std::string path(std::string_view name) const;
  Problems& problems() const { return problems_; }

  // Each function reads a key. A key that is not written has the fallback; without a fallback that
  // is a problem.
  std::string text(std::string_view name, std::optional<std::string> fallback = {});
  // Numbers from `least` to `most` are allowed.
  double number(std::string_view name, double least, double most,
                std::optional<double> fallback = {});
  int whole(std::string_view name, int least, int most, std::optional<int> fallback = {});
  // Returns the index of the word in the list.
  std::size_t word(std::string_view name, std::span<const std::string_view> words,
                   std::optional<std::size_t> fallback = {});
  std::vector<std::string> texts(std::string_view name);
  // A number of result.json by its path, and a list of them.
  std::string metric(std::string_view name, std::optional<std::string> fallback = {});
  std::vector<std::string> metrics(std::string_view name);
  // Returns a table inside this one, or null.
  const toml::table* table(std::string_view name);
  // Returns the tables of a list.
  std::vector<const toml::table*> tables(std::string_view name);
  // Returns the value itself, or null; the key counts as read.
  const toml::node* node(std::string_view name);

  void refuse(std::string_view name, const std::string& what, const std::string& allowed,
              const std::string& remedy);
  // Notes the keys that were not read.
  void refuse_unknown();

 private:
  void missing(std::string_view name, const std::string& allowed);
  void check_metric(std::string_view name, const std::string& metric);

  Problems& problems_;
  const toml::table& table_;
  std::string path_;
  std::set<std::string> known_;
};

// Calls `leaf` for each key below a table. Its path may be in quotes or spread over tables:
// "jet.jet.speed" = ..., jet.jet.speed = ... and [vary.jet.jet] speed = ... are the same. A table
// for which `is_leaf` holds is a value.
void for_each_key(const toml::table& table, const std::string& prefix,
                  const std::function<bool(const toml::table&)>& is_leaf,
                  const std::function<void(const std::string& path, const toml::node&)>& leaf);

// Reads varied keys. Problems are noted at `reported_key`, the key as the study file has it
// ("vary.jet.jet.speed").
class AxisReader {
 public:
  AxisReader(Problems& problems, const toml::table& base) : problems_(problems), base_(base) {}

  // Remembers that the study file has a key in `table`, with its value at `node`. A path that leads
  // to no key is left to the reader of its value.
  void note(const std::string& table, const std::string& path, const std::string& reported_key,
            const toml::node& node);
  // Notes the keys that the study has twice as problems.
  void refuse_repeated() const { refuse_repeated_keys(named_, problems_); }
  // Returns the key of the case; nothing, with a problem noted, where the path leads to none.
  std::optional<KeyPath> key(const std::string& path, const std::string& reported_key);
  // Reads a list of values, a range { from, to, count, scale }, or one value.
  std::optional<Axis> axis(const std::string& path, const std::string& reported_key,
                           const toml::node& node);
  // Reads a range from its two ends.
  std::optional<Axis> range(const std::string& path, const std::string& reported_key,
                            const toml::node* from, const toml::node* to);
  // Reads one number of the key in SI units; nothing, with a problem noted, where it is wrong.
  std::optional<double> number(const KeyPath& path, const std::string& reported_key,
                               const toml::node& node);

 private:
  std::optional<Axis> list(KeyPath path, const std::string& reported_key,
                           const toml::array& values);
  std::optional<Axis> range_of_table(KeyPath path, const std::string& reported_key,
                                     const toml::table& table);
  void fill(Axis& axis, double from, double to, int count, const std::string& reported_key);
  void refuse(const std::string& reported_key, const std::string& what, const std::string& allowed,
              const std::string& remedy);

  Problems& problems_;
  const toml::table& base_;
  std::vector<NamedKey> named_;
};

// Returns the unit of a quantity as written: "mm/min" of "1200 mm/min".
std::string unit_of(const toml::node& node);

// Reads [search], [calibrate] and [model] of a study into the plan.
void read_goals(StudySection& top, AxisReader& reader, StudyPlan& plan);

}  // namespace kerf
