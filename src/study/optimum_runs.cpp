// SPDX-License-Identifier: Apache-2.0
#include "study/optimum_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

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

// Metrics that differ by a smaller share are equal: the lengths of a result are differences of
// positions, which are kept in single precision, and each of which has a rounding error of up to
// 2^-24 = 6e-8 of the greatest position.
constexpr double same_metric = 1e-6;

bool is_as_good(const TriedSetting& a, const TriedSetting& b) {
  return std::abs(a.value - b.value) <=
         same_metric * std::max(std::abs(a.value), std::abs(b.value));
}

bool is_better(const TriedSetting& a, const TriedSetting& b, bool least) {
  return least ? a.value < b.value : a.value > b.value;
}

// The plateaus of runs: neighbours that are equally good belong to one.
class Plateaus {
 public:
  Plateaus(const std::vector<TriedSetting>& runs, bool least)
      : runs_(runs), least_(least), plateau_(runs.size()), is_best_(runs.size(), true) {
    std::iota(plateau_.begin(), plateau_.end(), std::size_t{0});
    visit([this](std::size_t run, std::size_t neighbour) {
      if (is_as_good(runs_[run], runs_[neighbour])) join(run, neighbour);
    });
    visit([this](std::size_t run, std::size_t neighbour) {
      if (plateau_[run] != plateau_[neighbour] && is_better(runs_[neighbour], runs_[run], least_))
        is_best_[plateau_[run]] = false;
    });
  }

  // Returns the best run of each plateau that has no better neighbour.
  std::vector<TriedSetting> best() const {
    std::vector<TriedSetting> result;
    for (std::size_t run = 0; run < runs_.size(); ++run)
      if (runs_[run].holds() && is_best_[plateau_[run]] && leads(run)) result.push_back(runs_[run]);
    return result;
  }

 private:
  // Calls `use` for each pair of a run and a neighbour at which the condition holds.
  template <class Use>
  void visit(Use use) const {
    const auto look = [&](std::size_t run, const TriedSetting* neighbour) {
      if (neighbour && neighbour->holds())
        use(run, static_cast<std::size_t>(neighbour - runs_.data()));
    };
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      if (!runs_[run].holds()) continue;
      for (const NeighbouringRuns& near : neighbours_of(runs_[run].shares, runs_)) {
        look(run, near.below);
        look(run, near.above);
      }
    }
  }

  void join(std::size_t a, std::size_t b) {
    std::replace(plateau_.begin(), plateau_.end(), std::size_t(plateau_[b]),
                 std::size_t(plateau_[a]));
  }

  // Returns whether a run is the first of the best of its plateau.
  bool leads(std::size_t run) const {
    for (std::size_t other = 0; other < runs_.size(); ++other) {
      if (other == run || plateau_[other] != plateau_[run]) continue;
      if (is_better(runs_[other], runs_[run], least_)) return false;
      if (other < run && runs_[other].value == runs_[run].value) return false;
    }
    return true;
  }

  const std::vector<TriedSetting>& runs_;
  bool least_;
  std::vector<std::size_t> plateau_;  // of each run
  std::vector<bool> is_best_;         // whether the plateau of that number has no better neighbour
};

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
  std::vector<TriedSetting> result = Plateaus(among, least).best();
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

std::string why_none_holds(const OptimumGoal& goal, const std::vector<TriedSetting>& runs) {
  const auto holding = std::count_if(runs.begin(), runs.end(),
                                     [](const TriedSetting& run) { return run.margin >= 0.0; });
  if (holding == 0)
    return fmt::format("{} held in none of {} runs. Widen the ranges", goal.condition.text(),
                       runs.size());
  return fmt::format("{} held in {} of {} runs, and none of these has {}. Choose another metric",
                     goal.condition.text(), holding, runs.size(), goal.metric);
}

}  // namespace kerf
