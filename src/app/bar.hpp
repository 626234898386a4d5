// SPDX-License-Identifier: Apache-2.0
// A line of the terminal that renews itself: how far something is, and words about it.
#pragma once

#include <string>

namespace kerf {

class Bar {
 public:
  Bar() = default;
  ~Bar() { clear(); }
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;

  void show(double share, const std::string& words);
  void clear();

 private:
  bool is_shown_ = false;
};

}  // namespace kerf
