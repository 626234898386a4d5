// SPDX-License-Identifier: Apache-2.0
// PlannedMessages adds up what ranks would send one another in a step.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "distributed/rank_load.hpp"

namespace kerf {

class PlannedMessages {
 public:
  explicit PlannedMessages(std::vector<RankLoad>& loads) : loads_(loads) {}

  void add(int from, int to, double bytes) {
    if (from == to) return;
    loads_[static_cast<std::size_t>(from)].messages.sent += bytes;
    loads_[static_cast<std::size_t>(to)].messages.received += bytes;
    pairs_.emplace_back(from, to);
    if (pairs_.size() > 2 * kept_ + most_repeated) drop_repeated();
  }
  // Sets the number of partners of each rank.
  void count_partners() {
    drop_repeated();
    for (const auto& [from, to] : pairs_) ++loads_[static_cast<std::size_t>(to)].messages.partners;
  }

 private:
  static constexpr std::size_t most_repeated = 1 << 20;

  void drop_repeated() {
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    kept_ = pairs_.size();
  }

  std::vector<RankLoad>& loads_;
  std::vector<std::pair<int, int>> pairs_;  // sender and receiver
  std::size_t kept_ = 0;
};

}  // namespace kerf
