// SPDX-License-Identifier: Apache-2.0
#include "study/optimum_runs.hpp"

#include <algorithm>

namespace kerf {

namespace {

// Runs nearer to each other are the same but for rounding.
constexpr double same_share = 1e-9;

// Returns the distance along a key if it is the greatest, else 0.
double distance_along(std::size_t key, const Shares& from, const Shares& to) {
  const double along = to[key] - from[key];
  if (std::abs(along) <= same_share) return 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (std::abs(to[i] - from[i]) > std::abs(along)) return 0.0;
  return along;
}

// Returns whether a neighbour is no better than a run; `or_equal`: also as good.
bool is_no_better(const TriedSetting* neighbour, const TriedSetting& run, bool least,
                  bool or_equal) {
  if (neighbour == nullptr || !neighbour->holds()) return true;
  const double worse = (least ? 1.0 : -1.0) * (neighbour->value - run.value);
  return or_equal ? worse >= 0.0 : worse > 0.0;
}

}  // namespace

double greatest_distance(const Shares& a, const Shares& b) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, std::abs(a[i] - b[i]));
  return greatest;
}

bool is_same(const Shares& a, const Shares& b) {
  return greatest_distance(a, b) <= same_share;
}

std::vector<NeighbouringRuns> neighbours_of(const Shares& shares,
                                            const std::vector<TriedSetting>& runs) {
  std::vector<NeighbouringRuns> result(shares.size());
  for (std::size_t key = 0; key < shares.size(); ++key) {
    NeighbouringRuns& found = result[key];
    for (const TriedSetting& run : runs) {
      const double along = distance_along(key, shares, run.shares);
      if (along < 0.0 && (!found.below || run.shares[key] > found.below->shares[key]))
        found.below = &run;
      if (along > 0.0 && (!found.above || run.shares[key] < found.above->shares[key]))
        found.above = &run;
    }
  }
  return result;
}

std::vector<TriedSetting> local_optima(const std::vector<TriedSetting>& runs, bool least) {
  std::vector<TriedSetting> among = runs;
  if (!runs.empty() && runs.front().shares.size() > 1)
    std::erase_if(among, [](const TriedSetting& run) { return !run.holds(); });
  std::vector<TriedSetting> result;
  for (const TriedSetting& run : among) {
    if (!run.holds()) continue;
    // Of runs in a row that are equal only the first counts.
    const auto neighbours = neighbours_of(run.shares, among);
    const bool is_best = std::all_of(neighbours.begin(), neighbours.end(), [&](const auto& near) {
      return is_no_better(near.below, run, least, false) &&
             is_no_better(near.above, run, least, true);
    });
    if (is_best) result.push_back(run);
  }
  std::stable_sort(result.begin(), result.end(), [&](const auto& a, const auto& b) {
    return least ? a.value < b.value : a.value > b.value;
  });
  return result;
}

Bracket between_neighbours(const TriedSetting& best, const std::vector<TriedSetting>& runs,
                           bool least) {
  double change = 0.0, denied = best.value;
  const auto include = [&](const TriedSetting* neighbour) {
    if (neighbour == nullptr || !std::isfinite(neighbour->value)) return;
    if (neighbour->holds())
      change = std::max(change, std::abs(neighbour->value - best.value));
    else
      denied = least ? std::min(denied, neighbour->value) : std::max(denied, neighbour->value);
  };
  for (const NeighbouringRuns& near : neighbours_of(best.shares, runs)) {
    include(near.below);
    include(near.above);
  }
  Bracket interval{std::min(best.value - change, denied), std::max(best.value + change, denied)};
  const bool is_amount =
      std::none_of(runs.begin(), runs.end(), [](const auto& run) { return run.value < 0.0; });
  if (is_amount) interval.low = std::max(0.0, interval.low);
  return interval;
}

}  // namespace kerf
