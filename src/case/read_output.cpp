// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "case/draft.hpp"
#include "case/units.hpp"

namespace kerf {

namespace {

constexpr double most_outputs = 1e5;  // frames or pictures of one run
constexpr double most_rows = 1e7;     // of series.csv

// The interval of a key; too short a one is refused.
double read_interval(Section& section, std::string_view name, double end, double standard_count) {
  const double most = name == "series_interval" ? most_rows : most_outputs;
  const double interval = section.number(name, end / standard_count);
  if (interval > 0.0 && end / interval > most)
    section.refuse(name, fmt::format("this makes {:.3g} entries", end / interval),
                   "Choose a longer interval",
                   fmt::format("at least {}", write_quantity(end / most, "s")));
  return interval;
}

void check_times(Section& section, std::string_view name, const std::vector<double>& times,
                 double end) {
  if (times.empty() || times.back() <= end) return;
  section.refuse(name,
                 fmt::format("{} is after the end of the run", write_quantity(times.back(), "s")),
                 "Remove the time or let the run last longer",
                 fmt::format("times from 0 s to {}", write_quantity(end, "s")));
}

// 0, interval, 2 interval, ... and the end, each the nearest double to its multiple.
std::vector<double> times_every(double interval, double end) {
  constexpr double slack = 1e-9;
  std::vector<double> times;
  for (double i = 0.0; i * interval < end * (1.0 - slack); i += 1.0) times.push_back(i * interval);
  times.push_back(end);
  return times;
}

void read_frames(Section& section, OutputControl& output, double end) {
  constexpr double standard_frames = 20.0;
  if (section.has("frame_interval") && section.has("frame_times"))
    section.refuse("frame_times", "an interval is given as well", "Remove one of the two",
                   "one of frame_interval and frame_times");
  const double interval = read_interval(section, "frame_interval", end, standard_frames);
  const bool usable = interval > 0.0 && end / interval <= most_outputs;
  output.frame_times = section.quantities(
      "frame_times", usable ? times_every(interval, end) : std::vector<double>());
  check_times(section, "frame_times", output.frame_times, end);
}

}  // namespace

void read_output(Draft& draft, Section& top) {
  constexpr double standard_rows = 500.0;
  const toml::table empty;
  const toml::table* written = top.table("output");
  Section section(draft.reading, written ? *written : empty, "output", written ? "output" : "");
  OutputControl& output = draft.result.output;
  const double end = draft.result.time.end;
  read_frames(section, output, end);
  output.picture_times =
      section.quantities("picture_times", {0.0, 0.25 * end, 0.5 * end, 0.75 * end, end});
  check_times(section, "picture_times", output.picture_times, end);
  output.series_interval = read_interval(section, "series_interval", end, standard_rows);
  output.checkpoint_interval = section.number("checkpoint_interval");
  section.refuse_unknown();
}

}  // namespace kerf
