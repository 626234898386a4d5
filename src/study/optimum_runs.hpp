// SPDX-License-Identifier: Apache-2.0
// This header declares what the runs of a search for an optimum say of it: between which runs it
// lies, and where else they have a local optimum.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "study/searches.hpp"

namespace kerf {

// A setting as its position in the range of each key, from 0 to 1.
using Shares = std::vector<double>;

double greatest_distance(const Shares& a, const Shares& b);
// Returns whether two settings are the same but for rounding.
bool is_same(const Shares& a, const Shares& b);

struct TriedSetting {
  Shares shares;
  double refinement = 1.0;
  double value = 0.0;   // of the metric; NaN where the run has none
  double margin = 0.0;  // >= 0 where the condition holds
  bool holds() const { return margin >= 0.0 && std::isfinite(value); }
};

// The nearest runs to both sides of a run along one key: those that differ from it by more along
// this key than along any other. Null where there is none.
struct NeighbouringRuns {
  const TriedSetting* below = nullptr;
  const TriedSetting* above = nullptr;
};

// Returns the neighbours along each key.
std::vector<NeighbouringRuns> neighbours_of(const Shares& shares,
                                            const std::vector<TriedSetting>& runs);

// Returns the runs that are better than their neighbours, the best first; of neighbours that are
// equal but for rounding the best. All runs are of one resolution. With several keys only runs at
// which the condition holds are neighbours, because its edge would make a local optimum of each run
// beside it.
std::vector<TriedSetting> local_optima(const std::vector<TriedSetting>& runs, bool least);

// Returns by how much the metric of the optimum is uncertain between its neighbours: by the
// greatest change to one at which the condition holds, to both sides, since a convex metric is no
// further away between runs of equal distances; and up to a better one at which it does not hold.
Bracket between_neighbours(const TriedSetting& best, const std::vector<TriedSetting>& runs,
                           bool least);

// Returns why none of the runs is an answer: the condition held in none, or in none that has the
// metric.
std::string why_none_holds(const OptimumGoal& goal, const std::vector<TriedSetting>& runs);

}  // namespace kerf
