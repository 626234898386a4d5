// SPDX-License-Identifier: Apache-2.0
#include "study/search_ends.hpp"

namespace kerf {

namespace {

constexpr std::size_t most_corners = 256;

// Returns an axis that has the ends of its range alone.
Axis ends_of(Axis axis) {
  axis.values = {axis.values.front(), axis.values.back()};
  return axis;
}

// Adds the settings at the resolution of the study and, with drafts, at theirs.
void add(const std::vector<Setting>& settings, double refinement, double draft,
         std::vector<Trial>& trials) {
  for (const Setting& setting : settings) {
    trials.push_back({setting, 0, refinement});
    if (draft < 1.0) trials.push_back({setting, 0, refinement * draft});
  }
}

// Returns the corners of the ranges; of many ranges the first and the last alone.
std::vector<Setting> corners(const std::vector<Axis>& axes) {
  std::vector<Axis> ends;
  std::size_t count = 1;
  for (const Axis& axis : axes) {
    ends.push_back(ends_of(axis));
    count = count > most_corners ? count : 2 * count;
  }
  if (count <= most_corners) return grid(ends);
  std::vector<Setting> result(2);
  for (const Axis& axis : ends)
    for (const std::size_t end : {0, 1}) axis.put_level(end, result[end]);
  return result;
}

}  // namespace

std::vector<Trial> search_ends(const StudyPlan& plan) {
  std::vector<Trial> trials;
  if (const auto& goal = plan.threshold)
    add(grid({ends_of(goal->axis)}), plan.refinement, goal->draft, trials);
  if (const auto& goal = plan.optimum)
    add(corners(goal->axes), plan.refinement, goal->draft, trials);
  if (!plan.calibration) return trials;
  std::vector<Setting> settings = plan.calibration->predict;
  settings.insert(settings.begin(), plan.calibration->at);
  for (const Setting& setting : settings)
    for (const std::size_t end : {0, 1}) {
      Setting here = setting;
      ends_of(plan.calibration->axis).put_level(end, here);
      add({here}, plan.refinement, 1.0, trials);
    }
  return trials;
}

}  // namespace kerf
