// SPDX-License-Identifier: Apache-2.0
// One piece of work at a time, done beside the caller's thread: what is written to the disk while
// the computation goes on.
#pragma once

#include <functional>
#include <future>
#include <utility>

namespace kerf {

class Background {
 public:
  // Waits for the piece before, so that pieces are done in order and never two at once. Throws what
  // that one threw.
  void submit(std::function<void()> work) {
    wait();
    under_way_ = std::async(std::launch::async, std::move(work));
  }
  // Throws what the last piece threw, once.
  void wait() {
    if (under_way_.valid()) under_way_.get();
  }

 private:
  std::future<void> under_way_;  // waits for the work when it goes
};

}  // namespace kerf
