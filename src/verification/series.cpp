// SPDX-License-Identifier: Apache-2.0
#include "verification/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace kerf {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TimeSeries window(const TimeSeries& series, const Parameters& parameters) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double from = parameters.number("from", "s", -infinity);
  const double to = parameters.number("to", "s", infinity);
  TimeSeries result;
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (series.time[i] < from || series.time[i] > to) continue;
    result.time.push_back(series.time[i]);
    result.value.push_back(series.value[i]);
  }
  return result;
}

// Mean of the samples, weighted by the time between them, which may differ.
double mean(const TimeSeries& s) {
  if (s.time.size() < 2) return s.value.front();
  double sum = 0.0;
  for (std::size_t i = 1; i < s.time.size(); ++i)
    sum += 0.5 * (s.value[i] + s.value[i - 1]) * (s.time[i] - s.time[i - 1]);
  return sum / (s.time.back() - s.time.front());
}

// The mean with the weight 1 - cos (Hann's window) over the samples: the centre of a slowly
// decaying oscillation. Over three periods the period must be known to a tenth only, whereas a
// plain mean depends on the last part of a period.
double hann_mean(const TimeSeries& s) {
  const double first = s.time.front(), length = s.time.back() - first;
  if (!(length > 0.0)) return s.value.front();
  TimeSeries product = s, weight = s;
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    weight.value[i] = 1.0 - std::cos(2.0 * std::numbers::pi * (s.time[i] - first) / length);
    product.value[i] *= weight.value[i];
  }
  return mean(product) / mean(weight);
}

double slope(const TimeSeries& s) {
  const auto n = static_cast<double>(s.time.size());
  const double t = std::accumulate(s.time.begin(), s.time.end(), 0.0) / n;
  const double v = std::accumulate(s.value.begin(), s.value.end(), 0.0) / n;
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    product += (s.time[i] - t) * (s.value[i] - v);
    square += (s.time[i] - t) * (s.time[i] - t);
  }
  return square > 0.0 ? product / square : none;
}

// Rate of an exponential decay: the fall of the logarithm with time.
double decay_rate(TimeSeries s) {
  for (double& value : s.value) value = std::log(value);
  return -slope(s);
}

// Mean period between the first and the last crossing, linear between samples.
double period(const TimeSeries& s) {
  std::vector<double> crossings;
  for (std::size_t i = 1; i < s.time.size(); ++i) {
    const double before = s.value[i - 1], after = s.value[i];
    if (before == 0.0 || (before > 0.0) == (after > 0.0)) continue;
    crossings.push_back(s.time[i - 1] + (s.time[i] - s.time[i - 1]) * before / (before - after));
  }
  if (crossings.size() < 2) return none;
  return 2.0 * (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
}

double largest(const TimeSeries& s) {
  return *std::max_element(s.value.begin(), s.value.end(),
                           [](double a, double b) { return std::abs(a) < std::abs(b); });
}

// Greatest mean over any stretch of time "over" long: the pressure of a wave without the
// oscillation of its front.
double peak_of_mean(const TimeSeries& s, const Parameters& parameters) {
  const double over = parameters.number("over", "s");
  double greatest = none;
  for (std::size_t first = 0, last = 0; last < s.time.size(); ++last) {
    while (s.time[last] - s.time[first + 1 < last ? first + 1 : first] >= over) ++first;
    if (s.time[last] - s.time[first] < over) continue;
    const auto from = static_cast<std::ptrdiff_t>(first),
               to = static_cast<std::ptrdiff_t>(last) + 1;
    const double value = mean({{s.time.begin() + from, s.time.begin() + to},
                               {s.value.begin() + from, s.value.begin() + to}});
    if (!(value <= greatest)) greatest = value;
  }
  return greatest;
}

double time_above(const TimeSeries& s, const Parameters& parameters) {
  const double level = parameters.number("level", parameters.text("level_unit", ""));
  const auto is_above = [level](double v) { return v >= level; };
  if (parameters.text("reduce") == "first_above") {
    const auto found = std::find_if(s.value.begin(), s.value.end(), is_above);
    return found == s.value.end() ? none
                                  : s.time[static_cast<std::size_t>(found - s.value.begin())];
  }
  const auto found = std::find_if(s.value.rbegin(), s.value.rend(), is_above);
  return found == s.value.rend() ? none
                                 : s.time[static_cast<std::size_t>(s.value.rend() - found) - 1];
}

// The time at which the signal first passes a level from below, between two samples.
double time_of_passing(const TimeSeries& s, double level) {
  for (std::size_t i = 1; i < s.value.size(); ++i) {
    if (!(s.value[i - 1] < level) || s.value[i] < level) continue;
    const double part = (level - s.value[i - 1]) / (s.value[i] - s.value[i - 1]);
    return s.time[i - 1] + part * (s.time[i] - s.time[i - 1]);
  }
  return none;
}

double time_between(const TimeSeries& s, const Parameters& parameters) {
  const std::string unit = parameters.text("level_unit", "");
  return time_of_passing(s, parameters.number("upper_level", unit)) -
         time_of_passing(s, parameters.number("level", unit));
}

}  // namespace

double value_at(const TimeSeries& series, double time) {
  const auto after = std::lower_bound(series.time.begin(), series.time.end(), time);
  if (after == series.time.end()) return none;
  const auto i = static_cast<std::size_t>(after - series.time.begin());
  if (*after == time) return series.value[i];
  if (i == 0) return none;
  const double part = (time - series.time[i - 1]) / (series.time[i] - series.time[i - 1]);
  return series.value[i - 1] + part * (series.value[i] - series.value[i - 1]);
}

double reduce(const TimeSeries& series, const Parameters& parameters) {
  static const std::map<std::string, std::function<double(const TimeSeries&, const Parameters&)>>
      reductions{
          {"last", [](const TimeSeries& s, const Parameters&) { return s.value.back(); }},
          {"mean", [](const TimeSeries& s, const Parameters&) { return mean(s); }},
          {"hann_mean", [](const TimeSeries& s, const Parameters&) { return hann_mean(s); }},
          {"peak",
           [](const TimeSeries& s, const Parameters&) {
             return *std::max_element(s.value.begin(), s.value.end());
           }},
          {"peak_of_mean", peak_of_mean},
          {"largest", [](const TimeSeries& s, const Parameters&) { return largest(s); }},
          {"slope", [](const TimeSeries& s, const Parameters&) { return slope(s); }},
          {"decay_rate", [](const TimeSeries& s, const Parameters&) { return decay_rate(s); }},
          {"period", [](const TimeSeries& s, const Parameters&) { return period(s); }},
          {"first_above", time_above},
          {"last_above", time_above},
          {"time_between", time_between}};
  const auto found = reductions.find(parameters.text("reduce"));
  if (found == reductions.end())
    parameters.fail(fmt::format("there is no reduction \"{}\"", parameters.text("reduce")));
  const TimeSeries chosen = window(series, parameters);
  return chosen.time.empty() ? none : found->second(chosen, parameters);
}

}  // namespace kerf
