// SPDX-License-Identifier: Apache-2.0
#include "study/searches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>

#include "study/design.hpp"
#include "study/metrics.hpp"
#include "study/optimum_runs.hpp"

namespace kerf {

namespace {

using Tried = TriedSetting;

class OptimumSearch {
 public:
  OptimumSearch(const OptimumGoal& goal, double refinement, Laboratory& laboratory)
      : goal_(goal), refinement_(refinement), laboratory_(laboratory) {}

  OptimumAnswer run() {
    const bool has_drafts = goal_.draft < 1.0;
    level_ = refinement_ * goal_.draft;
    spread();
    const int for_drafts = has_drafts ? (2 * goal_.most_runs) / 3 : goal_.most_runs - goal_.repeats;
    constexpr double wide = 0.2;
    follow(best(), wide, for_drafts);
    follow_others(0.5 * wide, for_drafts);
    if (has_drafts) confirm();
    conclude();
    if (has_drafts && std::isfinite(answer_.value)) compare();
    if (best().holds()) look_around();
    return answer_;
  }

 private:
  Setting setting_of(const Shares& shares) const {
    Setting setting;
    for (std::size_t i = 0; i < shares.size(); ++i) goal_.axes[i].put_share(shares[i], setting);
    return setting;
  }

  const Tried* known(const Shares& shares, double refinement) const {
    const auto found = std::find_if(tried_.begin(), tried_.end(), [&](const Tried& tried) {
      return tried.refinement == refinement && is_same(tried.shares, shares);
    });
    return found == tried_.end() ? nullptr : &*found;
  }

  // Makes the runs that do not exist yet.
  void evaluate(const std::vector<Shares>& places, double refinement) {
    std::vector<Trial> trials;
    std::vector<Shares> wanted;
    for (const Shares& shares : places) {
      if (known(shares, refinement) != nullptr) continue;
      trials.push_back({setting_of(shares), 0, refinement});
      wanted.push_back(shares);
    }
    const auto outcomes = laboratory_.run(trials);
    answer_.runs += static_cast<int>(trials.size());
    if (refinement < refinement_) answer_.draft_runs += static_cast<int>(trials.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto found = outcomes[i].metrics.find(goal_.metric);
      const bool has_value = !outcomes[i].failed && found != outcomes[i].metrics.end();
      tried_.push_back({wanted[i], refinement, has_value ? found->second : std::nan(""),
                        outcomes[i].failed ? -1.0 : goal_.condition.margin(outcomes[i].metrics)});
    }
  }
  Tried at(const Shares& shares, double refinement) {
    if (known(shares, refinement) == nullptr) evaluate({shares}, refinement);
    return *known(shares, refinement);
  }

  // Runs points that are spread over the ranges, at the same time.
  void spread() {
    const std::size_t count = std::max<std::size_t>(2 * goal_.axes.size() + 1,
                                                    static_cast<std::size_t>(goal_.most_runs) / 4);
    evaluate(sobol(goal_.axes.size(), count), level_);
  }

  bool is_better(const Tried& a, const Tried& b) const {
    if (a.holds() != b.holds()) return a.holds();
    if (!a.holds()) return a.margin > b.margin;
    return goal_.least ? a.value < b.value : a.value > b.value;
  }
  std::vector<Tried> runs_at(double refinement) const {
    std::vector<Tried> result = tried_;
    std::erase_if(result, [&](const Tried& tried) { return tried.refinement != refinement; });
    return result;
  }
  // Returns the runs at the current resolution, the best first.
  std::vector<Tried> ranking() const {
    std::vector<Tried> result = runs_at(level_);
    std::stable_sort(result.begin(), result.end(),
                     [&](const Tried& a, const Tried& b) { return is_better(a, b); });
    return result;
  }
  Tried best() const { return ranking().front(); }

  // Returns the objective that NLopt minimises: the metric over its value where the search starts.
  double objective(const Tried& tried, double scale) const {
    constexpr double worse_than_any = 10.0;  // where the run has no such metric
    if (!std::isfinite(tried.value)) return worse_than_any;
    return (goal_.least ? 1.0 : -1.0) * tried.value / scale;
  }

  // Follows Powell's COBYLA (Advances in Optimization and Numerical Analysis, 1994, p. 51): linear
  // models of objective and constraint over a simplex, without derivatives. Each step is one run.
  void follow(const Tried& start, double first_step, int until_runs) {
    const double size = std::abs(start.value);
    Steps steps{*this, std::isfinite(size) && size > 0.0 ? size : 1.0, {}};
    const int most = until_runs - answer_.runs;
    if (most <= static_cast<int>(start.shares.size()) + 1) return;
    nlopt::opt optimiser(nlopt::LN_COBYLA, static_cast<unsigned>(start.shares.size()));
    optimiser.set_lower_bounds(0.0);
    optimiser.set_upper_bounds(1.0);
    optimiser.set_min_objective(&Steps::objective_at, &steps);
    optimiser.add_inequality_constraint(&Steps::constraint_at, &steps, 0.0);
    optimiser.set_initial_step(first_step);
    optimiser.set_xtol_abs(goal_.tolerance);
    optimiser.set_maxeval(most);
    Shares start_point = start.shares;
    double found = 0.0;
    try {
      optimiser.optimize(start_point, found);
    } catch (const nlopt::roundoff_limited&) {
      // When no step improves the objective, the best run is the answer.
    } catch (const nlopt::forced_stop&) {
      std::rethrow_exception(steps.error);
    }
    pull_back(start_point, until_runs);
  }

  // Spends the runs that are left on the other optima of the first points, the best first.
  void follow_others(double first_step, int until_runs) {
    for (const Tried& other : local_optima(runs_at(level_), goal_.least))
      if (greatest_distance(other.shares, best().shares) > first_step)
        follow(other, first_step, until_runs);
  }

  // The search ends near the limit of the condition, often beyond it. Bisects from there towards
  // the best run that satisfies it, until the limit is known within the tolerance.
  void pull_back(const Shares& end, int until_runs) {
    Shares outside = end;
    while (answer_.runs < until_runs && best().margin >= 0.0) {
      const Shares inside = best().shares;
      Shares middle;
      double distance = 0.0;
      for (std::size_t i = 0; i < end.size(); ++i) {
        middle.push_back(0.5 * (inside[i] + outside[i]));
        distance = std::max(distance, std::abs(inside[i] - outside[i]));
      }
      if (distance <= goal_.tolerance) return;
      if (at(middle, level_).margin < 0.0)
        outside = middle;
      else if (best().shares != middle)
        return;  // the condition holds, but the metric is not better
    }
  }

  // NLopt requests objective and constraint one after the other: the same run provides both.
  struct Steps {
    OptimumSearch& search;
    double scale;
    std::exception_ptr error;  // NLopt is a C library and passes only its own exceptions on

    Tried at(const Shares& shares) {
      try {
        return search.at(shares, search.level_);
      } catch (...) {
        error = std::current_exception();
        throw nlopt::forced_stop();
      }
    }
    static double objective_at(const Shares& shares, Shares&, void* data) {
      auto& steps = *static_cast<Steps*>(data);
      return steps.search.objective(steps.at(shares), steps.scale);
    }
    static double constraint_at(const Shares& shares, Shares&, void* data) {
      return -static_cast<Steps*>(data)->at(shares).margin;
    }
  };

  // Runs the best drafts of each optimum, then the best of all, at the full resolution at the same
  // time, and searches on from the best.
  void confirm() {
    const auto wanted = static_cast<std::size_t>(std::max(2, laboratory_.side_by_side()));
    std::vector<Tried> drafts = local_optima(runs_at(level_), goal_.least);
    for (const Tried& draft : ranking()) drafts.push_back(draft);
    std::vector<Shares> places;
    for (const Tried& draft : drafts)
      if (places.size() < wanted &&
          std::find(places.begin(), places.end(), draft.shares) == places.end())
        places.push_back(draft.shares);
    level_ = refinement_;
    evaluate(places, level_);
    constexpr double steps_of_tolerance = 4.0;
    follow(best(), steps_of_tolerance * goal_.tolerance, goal_.most_runs - goal_.repeats - 1);
  }

  // Runs the best setting at the coarser resolution and extrapolates to spacing 0.
  void compare() {
    const Tried draft = at(best().shares, refinement_ * goal_.draft);
    if (draft.margin < 0.0 || !std::isfinite(draft.value)) return;
    answer_.draft_value = draft.value;
    answer_.extrapolated = at_zero_spacing(answer_.value, draft.value, 1.0 / goal_.draft);
    answer_.low = std::min(answer_.low, *answer_.extrapolated);
    answer_.high = std::max(answer_.high, *answer_.extrapolated);
  }

  void conclude() {
    const Tried found = best();
    answer_.setting = setting_of(found.shares);
    if (!found.holds()) {
      answer_.value = answer_.low = answer_.high = std::nan("");
      answer_.problem = why_none_holds(goal_, tried_);
      return;
    }
    answer_.value = answer_.low = answer_.high = found.value;
    std::vector<Trial> layouts;
    for (int repeat = 1; repeat < goal_.repeats; ++repeat)
      layouts.push_back({answer_.setting, repeat, refinement_});
    if (layouts.empty()) return;
    answer_.runs += static_cast<int>(layouts.size());
    for (const Outcome& outcome : laboratory_.run(layouts)) {
      const auto value = outcome.metrics.find(goal_.metric);
      if (value == outcome.metrics.end()) continue;
      answer_.low = std::min(answer_.low, value->second);
      answer_.high = std::max(answer_.high, value->second);
      if (!goal_.condition.holds(outcome.metrics))
        answer_.problem = fmt::format("{} does not hold in every layout at the best setting",
                                      goal_.condition.text());
    }
  }

  // Finds between which runs the optimum lies, and the others that the runs show.
  void look_around() {
    const Tried found = best();
    const std::vector<Tried> runs = runs_at(refinement_);
    const auto neighbours = neighbours_of(found.shares, runs);
    for (std::size_t i = 0; i < goal_.axes.size(); ++i) {
      const auto key_at = [&](double share) {
        Setting setting;
        goal_.axes[i].put_share(share, setting);
        return setting.numbers.at(goal_.axes[i].name());
      };
      const auto& [below, above] = neighbours[i];
      answer_.neighbours.push_back(
          {key_at(below ? below->shares[i] : 0.0), key_at(above ? above->shares[i] : 1.0)});
    }
    const Bracket between = between_neighbours(found, runs, goal_.least);
    answer_.low = std::min(answer_.low, between.low);
    answer_.high = std::max(answer_.high, between.high);
    add_others(found.shares, local_optima(runs, goal_.least), 0.0);
    if (goal_.draft >= 1.0) return;
    const auto drafts = local_optima(runs_at(refinement_ * goal_.draft), goal_.least);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Tried& draft : drafts)
      nearest = std::min(nearest, greatest_distance(draft.shares, found.shares));
    add_others(found.shares, drafts, nearest);
  }

  // Adds optima that are further from the answer than its own, which lies at the distance `own`.
  void add_others(const Shares& answer, const std::vector<Tried>& optima, double own) {
    constexpr int most = 3;
    int added = 0;
    for (const Tried& other : optima)
      if (greatest_distance(other.shares, answer) > std::max(own, goal_.tolerance) &&
          added++ < most)
        answer_.others.push_back({setting_of(other.shares), other.value, other.refinement});
  }

  const OptimumGoal& goal_;
  double refinement_;
  Laboratory& laboratory_;
  double level_ = 1.0;        // the current resolution
  std::vector<Tried> tried_;  // at any resolution
  OptimumAnswer answer_;
};

}  // namespace

OptimumAnswer find_optimum(const OptimumGoal& goal, double refinement, Laboratory& laboratory) {
  return OptimumSearch(goal, refinement, laboratory).run();
}

}  // namespace kerf
