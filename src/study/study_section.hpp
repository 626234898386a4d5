// SPDX-License-Identifier: Apache-2.0
// One table of a study file. What is missing or wrong becomes a problem and a harmless value, so
// that reading goes on; the caller throws at the end.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "case/problems.hpp"

namespace kerf {

class StudySection {
 public:
  StudySection(Problems& problems, const toml::table& table, std::string path);

  bool has(std::string_view name) const { return table_.contains(name); }
  std::string path(std::string_view name) const;
  Problems& problems() const { return problems_; }

  // Each reads a key. When it is not written: the fallback, or a problem where there is none.
  std::string text(std::string_view name, std::optional<std::string> fallback = {});
  // From `least` to `most`.
  double number(std::string_view name, double least, double most,
                std::optional<double> fallback = {});
  int whole(std::string_view name, int least, int most, std::optional<int> fallback = {});
  // The place of the word in the list.
  std::size_t word(std::string_view name, std::span<const std::string_view> words,
                   std::optional<std::size_t> fallback = {});
  std::vector<std::string> texts(std::string_view name);
  // A table inside this one, or null.
  const toml::table* table(std::string_view name);
  // The tables of a list.
  std::vector<const toml::table*> tables(std::string_view name);
  // The value itself, or null; it counts as read.
  const toml::node* node(std::string_view name);

  void refuse(std::string_view name, const std::string& what, const std::string& allowed,
              const std::string& remedy);
  // Notes the keys that nobody has asked for.
  void refuse_unknown();

 private:
  void missing(std::string_view name, const std::string& allowed);

  Problems& problems_;
  const toml::table& table_;
  std::string path_;
  std::set<std::string> known_;
};

}  // namespace kerf
