// SPDX-License-Identifier: Apache-2.0
// This class runs one task at a time beside the thread of the caller: files are written while the
// computation continues.
#pragma once

#include <functional>
#include <future>
#include <utility>

namespace kerf {

class Background {
 public:
  // Waits for the previous task, so that tasks run in order and never two at once. Throws what that
  // task threw.
  void submit(std::function<void()> work) {
    wait();
    under_way_ = std::async(std::launch::async, std::move(work));
  }
  // Throws what the last task threw, once.
  void wait() {
    if (under_way_.valid()) under_way_.get();
  }

 private:
  std::future<void> under_way_;  // its destructor waits for the task
};

}  // namespace kerf
