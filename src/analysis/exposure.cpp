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

DepthHistory history_since(const std::vector<CutState>& history, double contact) {
  DepthHistory since;
  double deepest = 0.0;
  for (const CutState& state : history) {
    if (state.time <= contact) continue;
    deepest = std::max(deepest, state.front_depth);
    since.times.push_back(state.time - contact);
    since.depths.push_back(deepest);
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

// Carries the depth to the exposure time: the laws of the three fits, and what holds for every
// front that slows down: it stays between its last depth and a motion on at its last speed.
void carry(const DepthHistory& history, Exposure& exposure) {
  const double least = history.depths.back();
  const double most = least + last_speed(history) * (exposure.time - exposure.simulated);
  const auto within = [&](double depth) { return std::clamp(depth, least, std::max(least, most)); };
  std::vector<double> depths;
  for (const double share : fit_shares) {
    const auto law = fit_depth(history, share);
    if (!law) continue;
    // The law continues from the last depth.
    depths.push_back(within(least * std::pow(exposure.time / exposure.simulated, law->exponent)));
    if (depths.size() == 1) exposure.exponent = law->exponent;
  }
  if (depths.empty()) return;
  exposure.depth = depths.front();
  exposure.depth_low = *std::min_element(depths.begin(), depths.end());
  exposure.depth_high = *std::max_element(depths.begin(), depths.end());
}

// Returns the time since contact after which the carried front has passed the workpiece, s.
double passage_of(const Exposure& exposure, double depth) {
  return exposure.simulated * std::pow(exposure.thickness / depth, 1.0 / exposure.exponent);
}

double thickness_of(const Case& description) {
  return description.workpiece->size[1] / std::cos(description.jets.back().angle);
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
  return simulated > 0.0 ? std::max(0.0, std::log10(time / simulated)) : 0.0;
}

const MetricList<Exposure>& Exposure::metrics() {
  using E = Exposure;
  static const MetricList<E> list{
      {"time", "s", "exposure time, t_e",
       "Time for which the jet acts on a point of its path: its extent over the traverse speed.",
       &E::time},
      {"simulated", "s", "simulated time of the exposure",
       "Time of the run since the jet met the workpiece, until the cut or the end.", &E::simulated},
      {"decades", "1", "decades of time carried",
       "Decimal logarithm of the exposure time over the simulated time; 0 where the run covers the "
       "exposure, and after a cut.",
       [](const E& e) { return e.cuts && std::isnan(e.exponent) ? 0.0 : e.decades(); }},
      {"cuts", "1", "cut through at the traverse speed",
       "Whether the traverse cuts the workpiece through, by the exposure.", &E::cuts},
      {"depth", "m", "depth at the traverse speed",
       "Depth that the exposure reaches, at most the thickness.", &E::depth},
      {"depth_low", "m", "least depth at the traverse speed",
       "Lower end of the interval of that depth from the fits of the law.", &E::depth_low},
      {"depth_high", "m", "greatest depth at the traverse speed", "Upper end of that interval.",
       &E::depth_high},
      {"exponent", "1", "exponent of time, n",
       "Exponent n of the depth over time, which carries the depth beyond the run.", &E::exponent},
      {"greatest_feed", "m/s", "greatest traverse speed that cuts",
       "Traverse speed at which the exposure just cuts through.", &E::greatest_feed}};
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
  if (since.times.empty()) return std::nullopt;
  Exposure exposure;
  exposure.time = exposure_time(machine, description.jets.back(), description.dimension);
  exposure.thickness = thickness_of(description);
  exposure.simulated =
      cut.cut_through ? cut.cut_through_time - cut.contact_time : since.times.back();
  if (cut.cut_through) {
    exposure.depth = exposure.depth_low = exposure.depth_high = exposure.thickness;
    exposure.greatest_feed = machine.traverse_speed * exposure.time / exposure.simulated;
    exposure.cuts = exposure.simulated <= exposure.time;
    return exposure;
  }
  if (exposure.simulated >= exposure.time) {
    exposure.depth = exposure.depth_low = exposure.depth_high = since.depths.back();
    return exposure;
  }
  carry(since, exposure);
  if (exposure.exponent > 0.0 && since.depths.back() > 0.0)
    exposure.greatest_feed =
        machine.traverse_speed * exposure.time / passage_of(exposure, since.depths.back());
  for (double* depth : {&exposure.depth, &exposure.depth_low, &exposure.depth_high})
    *depth = std::min(*depth, exposure.thickness);
  exposure.cuts = exposure.depth_low >= exposure.thickness;
  return exposure;
}

}  // namespace kerf
