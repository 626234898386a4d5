// SPDX-License-Identifier: Apache-2.0
#include "study/boundary.hpp"

#include <algorithm>
#include <map>

namespace kerf {

namespace {

// The verdicts along one key, by its value.
using Line = std::map<double, bool>;

// Orders settings, so that they may be keys of a map.
struct Order {
  bool operator()(const Setting& a, const Setting& b) const {
    return std::tie(a.numbers, a.words) < std::tie(b.numbers, b.words);
  }
};

std::map<Setting, Line, Order> lines_along(const std::string& key,
                                           const std::vector<RunRow>& runs) {
  std::map<Setting, Line, Order> lines;
  for (const RunRow& run : runs) {
    const auto value = run.trial.setting.numbers.find(key);
    const auto verdict = cuts(run.metrics);
    const bool counts = run.state == RunState::done && run.trial.repeat == 0;
    if (!counts || value == run.trial.setting.numbers.end() || !verdict) continue;
    Setting others = run.trial.setting;
    others.numbers.erase(key);
    lines[others][value->second] = *verdict;
  }
  return lines;
}

void add_crossings(const std::string& key, const Setting& others, const Line& line,
                   std::vector<Crossing>& crossings) {
  for (auto left = line.begin(), right = left; ++right != line.end(); left = right)
    if (left->second != right->second)
      crossings.push_back({key, left->first, right->first, right->second, others});
}

}  // namespace

std::vector<Crossing> cut_boundary(const std::vector<Axis>& axes, const std::vector<RunRow>& runs) {
  std::vector<Crossing> crossings;
  for (const Axis& axis : axes)
    for (const auto& [others, line] : lines_along(axis.name(), runs))
      add_crossings(axis.name(), others, line, crossings);
  return crossings;
}

}  // namespace kerf
