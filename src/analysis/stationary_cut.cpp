// SPDX-License-Identifier: Apache-2.0
#include "analysis/stationary_cut.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/jet_direction.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

struct Stretch {
  double depth = 0.0, lag = 0.0, width = 0.0, force = 0.0;
  bool is_cut = false;  // throughout
};

// Returns the means over the time between the states first and last of the history. The force
// follows from the impulses of these two.
Stretch mean_of(const std::vector<CutState>& history, std::size_t first, std::size_t last) {
  Stretch mean;
  mean.is_cut = true;
  const double time = history[last].time - history[first].time;
  for (std::size_t n = first + 1; n <= last; ++n) {
    const Wake& wake = history[n].wake;
    const double share = (history[n].time - history[n - 1].time) / time;
    mean.depth += share * wake.depth;
    mean.lag += share * wake.lag;
    mean.width += share * wake.width;
    mean.is_cut = mean.is_cut && wake.depth > 0.0;
  }
  mean.force = (history[last].water_impulse - history[first].water_impulse) / time;
  return mean;
}

double change_of(double before, double after, double least) {
  const double scale = std::max({std::abs(before), std::abs(after), least});
  return scale > 0.0 ? std::abs(after - before) / scale : 0.0;
}

}  // namespace

const MetricList<StationaryCut>& StationaryCut::metrics() {
  using S = StationaryCut;
  static const MetricList<S> list{
      {"reached", "1", "the cut became stationary",
       "Whether depth, lag, width and force changed by no more than the tolerance from one stretch "
       "of the path to the next.",
       &S::reached},
      {"travelled", "m", "path of the nozzle", "How far the nozzle has travelled.", &S::travelled},
      {"change", "1", "change between the last two stretches",
       "Largest relative change of depth, lag, width and force from the stretch of 4 jet widths "
       "before the last one to the last.",
       [](const S& s) { return std::isnan(s.change) ? std::nullopt : std::optional(s.change); }},
      {"depth", "m", "depth of the stationary cut", "Mean depth of the cut in the last stretch.",
       &S::depth},
      {"lag", "m", "lag of the stationary cut",
       "Mean distance along the path by which the front trails the nozzle, between 50% and 90% of "
       "its depth.",
       &S::lag},
      {"width", "m", "width of the stationary cut",
       "Mean width at half the depth across the path; 0 in 2D.", &S::width},
      {"force", extensive("N"), "force on the workpiece",
       "Mean force of the water on the workpiece along the jet.", &S::force}};
  return list;
}

StationaryCut stationary_cut(const Case& description, const std::vector<CutState>& history) {
  StationaryCut cut;
  if (history.empty()) return cut;
  const Jet& jet = description.jets.back();
  const double speed = traverse_speed(jet);
  const auto travelled = [&](const CutState& state) {
    return speed * std::max(0.0, state.time - jet.start - jet.dwell);
  };
  cut.travelled = travelled(history.back());
  const double stretch = stretch_widths * jet.width;
  const auto first_after = [&](double place) {
    const auto found = std::find_if(history.begin(), history.end(), [&](const CutState& state) {
      return travelled(state) >= place - 1e-9 * stretch;
    });
    return static_cast<std::size_t>(found - history.begin());
  };
  constexpr double rounding = 1.0 - 1e-9;
  if (cut.travelled < 2.0 * stretch * rounding) return cut;
  const std::size_t last = history.size() - 1, middle = first_after(cut.travelled - stretch),
                    first = first_after(cut.travelled - 2.0 * stretch);
  if (middle == last || first == middle) return cut;
  const Stretch before = mean_of(history, first, middle), now = mean_of(history, middle, last);
  cut.depth = now.depth;
  cut.lag = now.lag;
  cut.width = now.width;
  cut.force = now.force;
  cut.change = std::max(
      {change_of(before.depth, now.depth, jet.width), change_of(before.lag, now.lag, jet.width),
       change_of(before.width, now.width, jet.width), change_of(before.force, now.force, 0.0)});
  cut.reached = before.is_cut && now.is_cut && cut.change <= description.time.stop_tolerance;
  return cut;
}

}  // namespace kerf
