// SPDX-License-Identifier: Apache-2.0
#include "analysis/exposure.hpp"

#include <algorithm>
#include <cmath>

#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// The shares of the time after which the law is fitted: the exponents differ where no law holds.
constexpr double fit_shares[] = {0.5, 0.25, 0.125};
// Exponents that differ by more are of no law: the front may as well have come to rest.
constexpr double same_exponent = 0.1;

DepthHistory history_since(const std::vector<CutState>& history, double contact) {
  DepthHistory since;
  double deepest = 0.0;
  for (const CutState& state : history) {
    if (state.time <= contact) continue;
    deepest = std::max(deepest, state.front_depth);
    since.times.push_back(state.time - contact);
    since.depths.push_back(deepest);
    since.widths.push_back(state.kerf_width);
  }
  return since;
}

// Returns the mean speed of the front over the last quarter of the time, m/s.
double last_speed(const DepthHistory& history) {
  const double late = 0.75 * history.times.back();
  const auto first = std::lower_bound(history.times.begin(), history.times.end(), late);
  const auto n = static_cast<std::size_t>(first - history.times.begin());
  const double time = history.times.back() - history.times[n];
  return time > 0.0 ? (history.depths.back() - history.depths[n]) / time : 0.0;
}

struct DepthRange {
  double low = Exposure::none, high = Exposure::none;
};

// Returns the depths after a time that the run does not reach. A front that slows down stays
// between its last depth and a motion on at its last speed; the laws continue from the last depth.
DepthRange carried(const DepthHistory& history, double time) {
  const double last = history.depths.back(), end = history.times.back();
  const double most = std::max(last, last + last_speed(history) * (time - end));
  DepthRange range;
  double least_exponent = 1.0, greatest_exponent = 0.0;
  for (const double share : fit_shares) {
    const auto law = fit_depth(history, share);
    if (!law) continue;
    const double depth = std::clamp(last * std::pow(time / end, law->exponent), last, most);
    range.low = std::fmin(range.low, depth);
    range.high = std::fmax(range.high, depth);
    least_exponent = std::min(least_exponent, law->exponent);
    greatest_exponent = std::max(greatest_exponent, law->exponent);
  }
  if (greatest_exponent - least_exponent > same_exponent) range.low = last;
  return range;
}

DepthRange depths_after(const DepthHistory& history, double time) {
  if (time > history.times.back()) return carried(history, time);
  const auto next = std::lower_bound(history.times.begin(), history.times.end(), time);
  const double depth = history.depths[static_cast<std::size_t>(next - history.times.begin())];
  return {depth, depth};
}

// Returns the time for which a jet of the extent (m) stays within its hole at the speed (m/s): the
// first time t with u t >= W(t), else with the last width.
double longest_exposure(const DepthHistory& history, double extent, double speed) {
  for (std::size_t k = 0; k < history.times.size(); ++k)
    if (speed * history.times[k] >= std::max(extent, history.widths[k])) return history.times[k];
  return std::max(extent, history.widths.back()) / speed;
}

double thickness_of(const Case& description) {
  return description.workpiece->size[1] / std::cos(description.jets.back().angle);
}

// A cut in the run: how fast the nozzle may move.
void add_feeds_of_cut(const DepthHistory& history, double extent, Exposure& exposure) {
  const auto at = std::lower_bound(history.times.begin(), history.times.end(), exposure.simulated);
  const auto n =
      std::min(static_cast<std::size_t>(at - history.times.begin()), history.times.size() - 1);
  exposure.greatest_feed = extent / exposure.simulated;
  exposure.possible_feed = std::max(extent, history.widths[n]) / exposure.simulated;
}

// No cut in the run: the feed at which the law reaches the thickness.
void add_carried_feeds(const DepthHistory& history, double extent, Exposure& exposure) {
  const auto law = fit_depth(history, fit_shares[0]);
  if (!law || !(law->exponent > 0.0)) return;
  const double passage = history.times.back() *
                         std::pow(exposure.thickness / history.depths.back(), 1.0 / law->exponent);
  exposure.exponent = law->exponent;
  exposure.greatest_feed = extent / passage;
  exposure.possible_feed = std::max(extent, history.widths.back()) / passage;
}

}  // namespace

double DepthLaw::at(double time) const {
  return factor * std::pow(time, exponent);
}

std::optional<DepthLaw> fit_depth(const DepthHistory& history, double from) {
  constexpr double fewest = 5.0;
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < history.times.size(); ++k) {
    if (history.times[k] < from * history.times.back() || history.depths[k] <= 0.0) continue;
    const double log_time = std::log(history.times[k]), log_depth = std::log(history.depths[k]);
    n += 1.0;
    x += log_time;
    y += log_depth;
    xx += log_time * log_time;
    xy += log_time * log_depth;
  }
  const double spread = n * xx - x * x;
  if (n < fewest || !(spread > 0.0)) return std::nullopt;
  DepthLaw law;
  law.exponent = std::max(0.0, (n * xy - x * y) / spread);
  law.factor = std::exp((y - law.exponent * x) / n);
  return law;
}

double Exposure::decades() const {
  return simulated > 0.0 && !std::isnan(exponent) ? std::max(0.0, std::log10(longest / simulated))
                                                  : 0.0;
}

const MetricList<Exposure>& Exposure::metrics() {
  using E = Exposure;
  static const MetricList<E> list{
      {"shortest", "s", "shortest exposure, w / u",
       "Time for which the jet covers a point of its path: its extent over the traverse speed.",
       &E::shortest},
      {"longest", "s", "longest exposure, W / u",
       "Time for which the jet stays within the hole that it has made by then: the width of the "
       "opening over the traverse speed.",
       &E::longest},
      {"simulated", "s", "simulated time of the exposure",
       "Time of the run since the jet met the workpiece, until the cut or the end.", &E::simulated},
      {"decades", "1", "decades of time carried",
       "Decimal logarithm of the longest exposure over the simulated time; 0 where the run covers "
       "the exposure, and after a cut.",
       &E::decades},
      {"cuts", "1", "certainly cut through at the traverse speed",
       "Whether the shortest exposure cuts the workpiece through.", &E::cuts},
      {"may_cut", "1", "possibly cut through at the traverse speed",
       "Whether the longest exposure cuts the workpiece through.", &E::may_cut},
      {"depth", "m", "depth at the traverse speed", "Mean of the two following depths.", &E::depth},
      {"depth_low", "m", "least depth at the traverse speed",
       "Depth after the shortest exposure, at most the thickness.", &E::depth_low},
      {"depth_high", "m", "greatest depth at the traverse speed",
       "Depth after the longest exposure, at most the thickness.", &E::depth_high},
      {"exponent", "1", "exponent of time, n",
       "Exponent n of the depth over time, which carries the depth beyond the run.", &E::exponent},
      {"greatest_feed", "m/s", "greatest traverse speed that cuts",
       "Traverse speed at which the shortest exposure just cuts through.", &E::greatest_feed},
      {"possible_feed", "m/s", "greatest traverse speed that may cut",
       "Traverse speed at which the longest exposure just cuts through.", &E::possible_feed}};
  return list;
}

std::optional<Exposure> exposure_of(const Case& description, const std::vector<CutState>& history,
                                    const CutSummary& cut) {
  if (!description.workpiece || !description.machine || std::isnan(cut.contact_time))
    return std::nullopt;
  const Machine& machine = *description.machine;
  if (machine.motion != NozzleMotion::standing || machine.traverse_speed == 0.0)
    return std::nullopt;
  const DepthHistory since = history_since(history, cut.contact_time);
  if (since.times.empty() || !(since.depths.back() > 0.0)) return std::nullopt;
  Exposure exposure;
  exposure.shortest = exposure_time(machine, description.jets.back(), description.dimension);
  const double extent = exposure.shortest * machine.traverse_speed;
  exposure.longest = longest_exposure(since, extent, machine.traverse_speed);
  exposure.thickness = thickness_of(description);
  exposure.simulated =
      cut.cut_through ? cut.cut_through_time - cut.contact_time : since.times.back();
  const auto after = [&](double time) {
    return cut.cut_through && time >= exposure.simulated
               ? DepthRange{exposure.thickness, exposure.thickness}
               : depths_after(since, time);
  };
  const auto within = [&](double depth) { return std::min(depth, exposure.thickness); };
  if (cut.cut_through)
    add_feeds_of_cut(since, extent, exposure);
  else if (exposure.longest > exposure.simulated)
    add_carried_feeds(since, extent, exposure);
  exposure.depth_low = within(after(exposure.shortest).low);
  exposure.depth_high = within(after(exposure.longest).high);
  exposure.depth = 0.5 * (exposure.depth_low + exposure.depth_high);
  return exposure;
}

}  // namespace kerf
