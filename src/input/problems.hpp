// SPDX-License-Identifier: Apache-2.0
// The problems of a case file. Every message has the format
//   FILE:LINE: KEY = VALUE: what is wrong. Allowed: the range. What to do.
// and all messages (up to ten) are reported at once.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace kerf {

struct Problem {
  std::string key;      // full path of the key, e.g. "body[2].spacing"
  std::string what;     // what is wrong
  std::string allowed;  // the allowed values
  std::string remedy;   // what to do; may be empty
};

// A problem with its place in the file.
struct FoundProblem : Problem {
  int line = 0;
  std::string value{};  // as the file has it; empty where the key is not written
};

// The refusal of a case, with all its problems.
class CaseError : public UserError {
 public:
  CaseError(const std::string& message, std::vector<FoundProblem> problems)
      : UserError(message, exit_bad_input), problems_(std::move(problems)) {}
  const std::vector<FoundProblem>& problems() const { return problems_; }

 private:
  std::vector<FoundProblem> problems_;
};

class Problems {
 public:
  explicit Problems(std::string file_name) : file_name_(std::move(file_name)) {}

  // Stores the line and the value of a key for later messages. A table that Kerf made has line 0:
  // the file does not have its keys.
  void mention(const std::string& key, int line, std::string value);
  // Adds a problem. A key that is not written has the line of the innermost table that contains it.
  void add(Problem problem);
  // Whether the file has the key, and whether a problem of the key was added.
  bool is_written(const std::string& key) const;
  bool concern(const std::string& key) const;
  bool any() const { return !found_.empty(); }
  std::size_t count() const { return found_.size(); }
  // Throws a CaseError with all of them, if there are any; its message has up to ten.
  void throw_if_any() const;

 private:
  struct Mention {
    int line = 0;
    std::string value;
  };
  int line_of(std::string key) const;
  std::string message_of(const FoundProblem& problem) const;

  std::string file_name_;
  std::map<std::string, Mention> mentions_;
  std::vector<FoundProblem> found_;
};

// Returns the candidate closest to `word` by edit distance, or an empty text if none is close.
std::string closest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace kerf
