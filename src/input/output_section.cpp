// SPDX-License-Identifier: Apache-2.0
// Reads and writes [[probe]] and [output].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/draft.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "input/units.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"

namespace kerf {

std::vector<Key> probe_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"name", name, "", "", any, {}, "", "Unique name of the probe", stored_in<&Probe::name>},
      {"kind", word, "", "point", any, probe_words, "", "point = pressure and velocity at the position, means of the matter around it, weighted by the kernel within two smoothing lengths: of the water, or inside a solid of that alone; beside a free surface of the rows that are within reach; plane = force that the side on which the normal points exerts, by pairs of particles across the plane, on water and elastic bodies of the other side, without the forces on rigid bodies and without the momentum that matter carries through the plane: the force between water and a rigid wall is that at a plane in its face with the normal into the wall; gauge = mean pressure and velocity over a round face, as a pressure gauge in a wall measures (a strip in 2D), of such means of the water in front of it", stored_in<&Probe::kind>},
      {"position", vector, "m", "", within(1e6), {}, "", "The point, a point of the plane, or the centre of the face", stored_in<&Probe::position>},
      {"normal", vector, "", "(0, 1, 0)", any, {}, "plane gauge", "Direction of the normal, of any length", stored_in<&Probe::normal>},
      {"diameter", quantity, "m", "", positive, {}, "gauge", "Diameter of the face of the gauge", stored_in<&Probe::diameter>},
  };
  // clang-format on
}

std::vector<Key> output_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"frame_interval", quantity, "s", "(end / 20; where a frame travels with the nozzle no more than a shift of it)", positive, {}, "", "Time between frames"},
      {"frame_times", quantities, "s", "(every frame_interval)", not_negative, {}, "", "Times of the frames, instead of an interval", stored_in<&OutputControl::frame_times>},
      {"picture_times", quantities, "s", "(0 and quarters of the run)", not_negative, {}, "", "Times of the pictures", stored_in<&OutputControl::picture_times>},
      {"series_interval", quantity, "s", "(end / 500; where a frame travels with the nozzle no more than a quarter of a jet width)", positive, {}, "", "Time between rows of series.csv", stored_in<&OutputControl::series_interval>},
      {"checkpoint_interval", quantity, "s", "60 s", positive, {}, "", "Wall-clock time between checkpoints", stored_in<&OutputControl::checkpoint_interval>},
  };
  // clang-format on
}

namespace {

constexpr double most_outputs = 1e5;  // frames or pictures of one run
constexpr double most_rows = 1e7;     // of series.csv

// Refuses an interval that is too short.
void check_interval(Section& section, const char* name, double interval, double end, double most) {
  if (interval > 0.0 && end / interval > most)
    section.refuse(name, fmt::format("this makes {:.3g} entries", end / interval),
                   "Choose a longer interval",
                   fmt::format("at least {}", show_quantity(end / most, "s", Bound::least)));
}

void check_times(Section& section, std::string_view name, const std::vector<double>& times,
                 double end) {
  if (times.empty() || times.back() <= end) return;
  section.refuse(name,
                 fmt::format("{} is after the end of the run", show_quantity(times.back(), "s")),
                 "Remove the time or let the run last longer",
                 fmt::format("times from 0 s to {}", show_quantity(end, "s", Bound::most)));
}

// Returns the times 0, interval, 2 interval, ... and the end, each the double nearest to its
// multiple.
std::vector<double> times_every(double interval, double end) {
  constexpr double slack = 1e-9;
  std::vector<double> times;
  for (double i = 0.0; i * interval < end * (1.0 - slack); i += 1.0) times.push_back(i * interval);
  times.push_back(end);
  return times;
}

// The default times between frames and between rows, s. What is written until a cut becomes
// stationary does not depend on how far the nozzle could go on.
struct StandardIntervals {
  double frames = 0.0, rows = 0.0;

  static StandardIntervals of(const Draft& draft) {
    constexpr double standard_frames = 20.0, standard_rows = 500.0, rows_per_width = 4.0;
    const double end = draft.result.time.end;
    StandardIntervals intervals{end / standard_frames, end / standard_rows};
    if (const auto& workpiece = draft.result.workpiece;
        workpiece && workpiece->frame == WorkpieceFrame::travelling) {
      const Jet& jet = draft.jets.back().jet;
      const double speed = travelling_frame(*workpiece, jet).speed;
      intervals.frames = std::min(intervals.frames, workpiece->shift / speed);
      intervals.rows = std::min(intervals.rows, jet.width / speed / rows_per_width);
    }
    return intervals;
  }
};

void read_frames(Section& section, OutputControl& output, double end, double standard) {
  if (section.has("frame_interval") && section.has("frame_times"))
    section.refuse("frame_times", "an interval is given as well", "Remove one of the two",
                   "one of frame_interval and frame_times");
  const double interval = section.number("frame_interval", standard);
  check_interval(section, "frame_interval", interval, end, most_outputs);
  if (!section.has("frame_times") && interval > 0.0 && end / interval <= most_outputs)
    output.frame_times = times_every(interval, end);
}

void read_probe(Draft& draft, const toml::table& table, const std::string& path) {
  Section section(draft.reading, table, "probe", path);
  Probe probe;
  section.read(probe);
  const Point& normal = probe.normal;
  if (std::hypot(normal[0], normal[1], normal[2]) > 0.0)
    probe.normal = unit_vector(normal);
  else
    section.refuse("normal", "the normal has no direction", "Write for example [0, 1]",
                   "any vector but zero");
  section.refuse_unknown();
  draft.result.probes.push_back(probe);
}

}  // namespace

void read_probes(Draft& draft, Section& top) {
  const auto tables = top.tables("probe");
  for (std::size_t i = 0; i < tables.size(); ++i)
    read_probe(draft, *tables[i], indexed("probe", i));
}

void read_output(Draft& draft, Section& top) {
  const toml::table empty;
  const toml::table* written = top.table("output");
  Section section(draft.reading, written ? *written : empty, "output", written ? "output" : "");
  OutputControl& output = draft.result.output;
  const double end = draft.result.time.end;
  const StandardIntervals standard = StandardIntervals::of(draft);
  read_frames(section, output, end, standard.frames);
  output.picture_times = {0.0, 0.25 * end, 0.5 * end, 0.75 * end, end};
  output.series_interval = standard.rows;
  section.read(output);
  check_times(section, "frame_times", output.frame_times, end);
  check_times(section, "picture_times", output.picture_times, end);
  check_interval(section, "series_interval", output.series_interval, end, most_rows);
  section.refuse_unknown();
}

void write_probe(TomlWriter& writer, const Probe& probe) {
  writer.table("[[probe]]", "probe", probe);
}

void write_output(TomlWriter& writer, const OutputControl& output) {
  writer.table("[output]", "output", output);
}

}  // namespace kerf
