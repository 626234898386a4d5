// SPDX-License-Identifier: Apache-2.0
#include "analysis/exposure.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/depth_history.hpp"
#include "analysis/line_slope.hpp"
#include "geometry/nozzle.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// The shares of the time after which the law is fitted: the exponents differ where no law holds.
constexpr double fit_shares[] = {0.5, 0.25, 0.125};
// Exponents that differ by more are of no law: the front may as well have come to rest.
constexpr double same_exponent = 0.1;

// Returns the first row at or after a time, of rising ones, the last row at most.
std::size_t row_at(const std::vector<double>& times, double time) {
  const auto row = std::lower_bound(times.begin(), times.end(), time) - times.begin();
  return std::min(static_cast<std::size_t>(row), times.size() - 1);
}

// Returns the mean speed of the front over the last quarter of the time, m/s.
double last_speed(const DepthHistory& history) {
  const std::size_t n = row_at(history.times, 0.75 * history.times.back());
  const double time = history.times.back() - history.times[n];
  return time > 0.0 ? (history.depths.back() - history.depths[n]) / time : 0.0;
}

// Returns the exponent n of the law h = a t^n that fits the depths after the share `from` of the
// time best, by least squares of the logarithms; nothing from fewer than five times.
std::optional<double> fit_exponent(const DepthHistory& history, double from) {
  constexpr std::size_t fewest = 5;
  struct Logarithms {
    double time, depth;
  };
  std::vector<Logarithms> points;
  for (std::size_t k = 0; k < history.times.size(); ++k)
    if (history.times[k] >= from * history.times.back() && history.depths[k] > 0.0)
      points.push_back({std::log(history.times[k]), std::log(history.depths[k])});
  if (points.size() < fewest) return std::nullopt;
  const double slope = line_slope(
      points, [](const Logarithms& point) { return point.time; },
      [](const Logarithms& point) { return point.depth; });
  return std::max(0.0, slope);
}

struct DepthRange {
  double low = Exposure::none, high = Exposure::none;
};

// Returns the depths after a time that the run does not reach. A front that slows down stays
// between its last depth and a motion on at its last speed; the laws continue from the last depth.
// Of a front that rests at the end the run does not show how long it does: its depth is the least.
DepthRange carried(const DepthHistory& history, double time) {
  const double last = history.depths.back(), end = history.times.back();
  if (!(last_speed(history) > 0.0)) return {last, Exposure::none};
  const double most = std::max(last, last + last_speed(history) * (time - end));
  DepthRange range;
  double least_exponent = 1.0, greatest_exponent = 0.0;
  for (const double share : fit_shares) {
    const auto exponent = fit_exponent(history, share);
    if (!exponent) continue;
    const double depth = std::clamp(last * std::pow(time / end, *exponent), last, most);
    range.low = std::fmin(range.low, depth);
    range.high = std::fmax(range.high, depth);
    least_exponent = std::min(least_exponent, *exponent);
    greatest_exponent = std::max(greatest_exponent, *exponent);
  }
  if (greatest_exponent - least_exponent > same_exponent) range.low = last;
  return range;
}

DepthRange depths_after(const DepthHistory& history, double time) {
  if (time > history.times.back()) return carried(history, time);
  const double depth = history.depths[row_at(history.times, time)];
  return {depth, depth};
}

// Returns the time for which a jet of the extent (m) stays within its hole at the speed (m/s): the
// first time t with u t >= W(t), else with the last width.
double longest_exposure(const DepthHistory& history, double extent, double speed) {
  for (std::size_t k = 0; k < history.times.size(); ++k)
    if (speed * history.contacts[k] >= std::max(extent, history.widths[k]))
      return history.contacts[k];
  return std::max(extent, history.widths.back()) / speed;
}

// Returns the exposure after which the water is through a workpiece of the thickness (m) that is
// cut through at a time since contact, within a spacing; none where the run ends before it.
std::optional<double> exposure_of_passage(const DepthHistory& history, const WaterEntry& entry,
                                          double thickness, double since_contact) {
  const std::size_t at_cut = row_at(history.contacts, since_contact);
  for (std::size_t k = at_cut; k < history.times.size(); ++k) {
    if (history.depths[k] < thickness - entry.spacing) continue;
    // The cut is at the time of a row, and a crack may be there before the contact.
    const double time =
        k == at_cut ? std::max(since_contact, history.contacts.front()) : history.contacts[k];
    const double exposure = entry.exposure(time, std::min(thickness, history.depths[k]));
    return exposure > 0.0 ? std::optional(exposure) : std::nullopt;
  }
  return std::nullopt;
}

// Whether the front has passed the far face of a workpiece that is not cut through. What gives way
// ahead of it follows no law of a cut, however deep that is.
bool is_past_uncut(const std::vector<CutState>& history, const CutSummary& cut, double thickness) {
  return !cut.cut_through &&
         std::any_of(history.begin(), history.end(),
                     [&](const CutState& state) { return state.front_depth >= thickness; });
}

double thickness_of(const Case& description) {
  return description.workpiece->size[1] / std::cos(description.jets.back().angle);
}

// A cut in the run: how fast the nozzle may move.
void add_feeds_of_cut(const DepthHistory& history, double extent, Exposure& exposure) {
  const double width = history.widths[row_at(history.contacts, exposure.simulated)];
  exposure.greatest_feed = extent / exposure.simulated;
  exposure.possible_feed = std::max(extent, width) / exposure.simulated;
}

// The times after which the depths of carried() reach a depth, s; infinite = never.
struct PassageRange {
  double first = std::numeric_limits<double>::infinity();  // of the greatest depth
  double last = 0.0;                                       // of the least depth
};

PassageRange passages_of(const DepthHistory& history, double depth) {
  const double reached = history.depths.back(), end = history.times.back();
  const double speed = last_speed(history);
  PassageRange range;
  double least_exponent = 1.0, greatest_exponent = 0.0;
  for (const double share : fit_shares) {
    const auto exponent = fit_exponent(history, share);
    if (!exponent) continue;
    // A division by zero is a front at rest, which is infinitely late.
    const double by_law = end * std::pow(depth / reached, 1.0 / *exponent);
    const double by_speed = end + (depth - reached) / speed;
    range.first = std::min(range.first, std::max(by_law, by_speed));
    range.last = std::max(range.last, std::max(by_law, by_speed));
    least_exponent = std::min(least_exponent, *exponent);
    greatest_exponent = std::max(greatest_exponent, *exponent);
  }
  if (range.last == 0.0 || greatest_exponent - least_exponent > same_exponent)
    range.last = std::numeric_limits<double>::infinity();
  return range;
}

// No cut in the run: the feeds at which the least and the greatest of the carried depths reach the
// thickness, so that they agree with the depths at every feed.
void add_carried_feeds(const DepthHistory& history, double extent, Exposure& exposure) {
  const auto exponent = fit_exponent(history, fit_shares[0]);
  if (!exponent || !(*exponent > 0.0)) return;
  const PassageRange passage = passages_of(history, exposure.thickness);
  if (std::isinf(passage.first)) return;  // the front has come to rest
  exposure.exponent = *exponent;
  exposure.greatest_feed = extent / passage.last;
  exposure.possible_feed = std::max(extent, history.widths.back()) / passage.first;
}

// Returns the depth of the cut that the water had entered before the workpiece was cut through, or
// by the end of a run in which it was not, m.
double depth_before(const std::vector<CutState>& history, const CutSummary& cut) {
  double deepest = 0.0;
  for (const CutState& state : history)
    if (!cut.cut_through || state.time < cut.cut_through_time)
      deepest = std::max(deepest, std::min(state.front_depth, state.cut_depth));
  return deepest;
}

// Of a cut that holds of a nozzle at rest only, the depth before it is what is certain.
void deny_certainty(double depth, Exposure& exposure) {
  exposure.is_uncertain = true;
  if (!std::isnan(exposure.possible_feed)) exposure.greatest_feed = 0.0;
  exposure.depth_low = std::fmin(exposure.depth_low, depth);
}

// The depth under a nozzle at rest tells nothing of one that moves faster than its water, and that
// under drops nothing certain of one that is exposed to a few of them.
void limit_to_jet(const Jet& jet, Exposure& exposure) {
  // A feed that is not a number stays so.
  exposure.greatest_feed = std::min({exposure.greatest_feed, jet.speed, exposure.pausing_feed});
  exposure.possible_feed = std::min(exposure.possible_feed, jet.speed);
}

// Finds the feed at which the slugs of a jet that has broken up in air leave gaps.
void add_pauses(const Jet& jet, double extent, Exposure& exposure) {
  const double period = slugs_of(jet).period;
  if (period == 0.0) return;
  exposure.pausing_feed = extent / period / Exposure::few_pulses;
  exposure.has_pauses = exposure.shortest / period < Exposure::few_pulses;
}

}  // namespace

std::optional<Exposure> exposure_of(const Case& description, const std::vector<CutState>& history,
                                    const CutSummary& cut) {
  if (!stands_for_traverse(description) || std::isnan(cut.contact_time)) return std::nullopt;
  if (description.machine->is_pulsed()) return std::nullopt;  // a moving nozzle pauses elsewhere
  const Machine& machine = *description.machine;
  const WaterEntry entry = entry_of(description);
  Exposure exposure;
  exposure.thickness = thickness_of(description);
  const DepthHistory since = depth_history(description, history, cut, exposure.thickness);
  if (since.times.empty() || !(since.depths.back() > 0.0)) return std::nullopt;
  exposure.shortest = exposure_time(machine, description.jets.back(), description.dimension);
  const double extent = exposure.shortest * machine.traverse_speed;
  exposure.longest = longest_exposure(since, extent, machine.traverse_speed);
  const auto passage = cut.cut_through
                           ? exposure_of_passage(since, entry, exposure.thickness,
                                                 cut.cut_through_time - cut.contact_time)
                           : std::nullopt;
  exposure.simulated = passage.value_or(since.times.back());
  if (is_past_uncut(history, cut, exposure.thickness)) return exposure;
  if (passage)
    add_feeds_of_cut(since, extent, exposure);
  else if (exposure.longest > exposure.simulated)
    add_carried_feeds(since, extent, exposure);
  add_pauses(description.jets.back(), extent, exposure);
  limit_to_jet(description.jets.back(), exposure);
  const auto after = [&](double time) {
    return passage && time >= *passage ? DepthRange{exposure.thickness, exposure.thickness}
                                       : depths_after(since, time);
  };
  const auto within = [&](double depth) { return std::min(depth, exposure.thickness); };
  exposure.depth_low = within(after(exposure.shortest).low);
  exposure.depth_high = within(after(exposure.longest).high);
  if (cut.holds_at_rest_only())
    deny_certainty(depth_before(history, cut), exposure);
  else
    exposure.depth = std::sqrt(exposure.depth_low * exposure.depth_high);
  return exposure;
}

}  // namespace kerf
