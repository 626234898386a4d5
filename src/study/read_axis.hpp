// SPDX-License-Identifier: Apache-2.0
// Keys of the case and their values, as a study file writes them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <toml++/toml.h>

#include "case/problems.hpp"
#include "study/axis.hpp"

namespace kerf {

// Calls `leaf` for each key below a table, whose name may be a path in quotes or spread over
// tables: "jet.jet.speed" = ..., jet.jet.speed = ... and [vary.jet.jet] speed = ... are the same. A
// table for which `is_leaf` holds is a value.
void for_each_key(const toml::table& table, const std::string& prefix,
                  const std::function<bool(const toml::table&)>& is_leaf,
                  const std::function<void(const std::string& path, const toml::node&)>& leaf);

// Each notes what is wrong at `place`, the key as the study has it ("vary.jet.jet.speed").
class AxisReader {
 public:
  AxisReader(Problems& problems, const toml::table& base) : problems_(problems), base_(base) {}

  // The key of the case; none, with the problem noted, where the path leads to none.
  std::optional<KeyPath> key(const std::string& path, const std::string& place);
  // A list of values, a range { from, to, count, scale }, or one value.
  std::optional<Axis> axis(const std::string& path, const std::string& place,
                           const toml::node& node);
  // A range alone, from two values.
  std::optional<Axis> range(const std::string& path, const std::string& place,
                            const toml::node* from, const toml::node* to);
  // One number of the key in SI units; none, with the problem noted.
  std::optional<double> number(const KeyPath& path, const std::string& place,
                               const toml::node& node);

 private:
  std::optional<Axis> list(KeyPath path, const std::string& place, const toml::array& values);
  std::optional<Axis> range_of_table(KeyPath path, const std::string& place,
                                     const toml::table& table);
  void fill(Axis& axis, double from, double to, int count, const std::string& place);
  void refuse(const std::string& place, const std::string& what, const std::string& allowed,
              const std::string& remedy);

  Problems& problems_;
  const toml::table& base_;
};

// The unit of a quantity as written, "mm/min" of "1200 mm/min".
std::string unit_of(const toml::node& node);

}  // namespace kerf
