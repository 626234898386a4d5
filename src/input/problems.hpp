// SPDX-License-Identifier: Apache-2.0
// The problems of a case file. Every message has the format
//   FILE:LINE: KEY = VALUE: what is wrong. Allowed: the range. What to do.
// and all messages (up to ten) are reported at once.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

struct Problem {
  std::string key;      // full path of the key, e.g. "body[2].spacing"
  std::string what;     // what is wrong
  std::string allowed;  // the allowed values
  std::string remedy;   // what to do; may be empty
};

class Problems {
 public:
  explicit Problems(std::string file_name) : file_name_(std::move(file_name)) {}

  // Stores the line and the value of a key for later messages.
  void mention(const std::string& key, int line, std::string value);
  // Adds a problem. A key that is not written has the line of the innermost table that contains it.
  void add(Problem problem);
  bool any() const { return !messages_.empty(); }
  std::size_t count() const { return messages_.size(); }
  // Throws a UserError with all messages, if there are any.
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

// Returns the candidate closest to `word` by edit distance, or an empty text if none is close.
std::string closest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace kerf
