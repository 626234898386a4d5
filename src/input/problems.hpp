// SPDX-License-Identifier: Apache-2.0
// What is wrong with a case file. Every complaint has one format,
//   FILE:LINE: KEY = VALUE: what is wrong. Allowed: the range. What to do.
// and all of them (up to ten) reach the user at once.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

struct Problem {
  std::string key;      // full path of the key, e.g. "body[2].spacing"
  std::string what;     // what is wrong
  std::string allowed;  // the values that would do
  std::string remedy;   // what to do; may be empty
};

class Problems {
 public:
  explicit Problems(std::string file_name) : file_name_(std::move(file_name)) {}

  // Remembers where a key stands and what it says, for complaints about it now or later.
  void mention(const std::string& key, int line, std::string value);
  // A key nobody wrote is placed at the nearest table around it.
  void add(Problem problem);
  bool any() const { return !messages_.empty(); }
  std::size_t count() const { return messages_.size(); }
  // Throws a UserError of all complaints, if there are any.
  void throw_if_any() const;

 private:
  struct Mention {
    int line = 0;
    std::string value;
  };
  int line_of(std::string key) const;

  std::string file_name_;
  std::map<std::string, Mention> mentions_;
  std::vector<std::string> messages_;
};

// The candidate that `word` was probably meant to be, by edit distance; empty when none is near.
std::string closest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace kerf
