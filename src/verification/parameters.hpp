// SPDX-License-Identifier: Apache-2.0
// The parameters of a check are the keys of its entry in reference.toml as written; they are
// converted when they are used.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace kerf {

// An error in a reference.toml is a programmer's error, because its text is built in:
// std::logic_error.
class Parameters {
 public:
  explicit Parameters(std::string where) : where_(std::move(where)) {}

  void set(const std::string& key, std::string value) { values_[key] = std::move(value); }
  bool has(const std::string& key) const { return values_.count(key) > 0; }
  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& fallback) const;
  // A quantity with its unit, in `si_unit`; without a unit when that is empty.
  double number(const std::string& key, const std::string& si_unit) const;
  double number(const std::string& key, const std::string& si_unit, double fallback) const;
  // The keys and values as written.
  const std::map<std::string, std::string>& values() const { return values_; }
  // The keys that were not read, which are misspelt.
  std::vector<std::string> unread() const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string where_;
  std::map<std::string, std::string> values_;
  mutable std::map<std::string, bool> read_;
};

}  // namespace kerf
