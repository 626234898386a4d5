// SPDX-License-Identifier: Apache-2.0
#include "app/later_end.hpp"

#include <algorithm>
#include <filesystem>

#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "machine/characteristic_speed.hpp"
#include "model/case.hpp"
#include "output/checkpoint.hpp"

namespace kerf {
namespace {

// Returns whether the cases differ in the end and in the output alone. What is graded around the
// path of a nozzle, and the fastest speed, are not written and may follow from the end.
bool differs_in_end_alone(const Case& before, const std::string& text_before, const Case& now) {
  Case same = now;
  same.time.end = before.time.end;
  same.output = before.output;
  return write_used(same) == text_before &&
         characteristic_speed(before) == characteristic_speed(now) &&
         std::equal(before.bodies.begin(), before.bodies.end(), now.bodies.begin(),
                    now.bodies.end(),
                    [](const Body& a, const Body& b) { return a.grading == b.grading; });
}

bool are_equally_spaced(const std::vector<double>& times) {
  for (std::size_t n = 0; n < times.size(); ++n)
    if (times[n] != static_cast<double>(n) * times[1]) return false;
  return times.size() > 1;
}

// Returns times of output that begin with those before the earlier end: the times now where these
// do, else the earlier times, continued at their interval, and the end.
std::vector<double> continued_times(std::vector<double> times, double earlier_end,
                                    const std::vector<double>& now, double end) {
  constexpr double slack = 1e-9;
  std::erase_if(times, [=](double time) { return time >= earlier_end; });
  if (times.size() <= now.size() && std::equal(times.begin(), times.end(), now.begin())) return now;
  if (are_equally_spaced(times)) {
    const double interval = times[1];
    for (auto n = static_cast<double>(times.size()); n * interval < end * (1.0 - slack); n += 1.0)
      times.push_back(n * interval);
  }
  times.push_back(end);
  return times;
}

}  // namespace

void continue_to_later_end(RunLoopSettings& settings) {
  const std::filesystem::path checkpoint = settings.folder / "checkpoint.h5";
  if (settings.existing != Existing::resume || !std::filesystem::exists(checkpoint)) return;
  const std::string text = case_of_checkpoint(checkpoint);
  if (text == settings.case_text) return;
  Case before;
  try {
    before = parse_case(text, (settings.folder / "case.used.toml").string());
  } catch (const UserError&) {
    return;  // the run refuses the checkpoint
  }
  Case& now = settings.description;
  const double earlier_end = before.time.end, end = now.time.end;
  if (!(earlier_end <= end) || !differs_in_end_alone(before, text, now)) return;
  settings.continued_text = text;
  settings.continued_end = earlier_end;
  if (earlier_end == end) {  // of a run that went on to this end with the intervals that it had
    now.output = before.output;
    settings.case_text = text;
    return;
  }
  now.output.series_interval = before.output.series_interval;
  now.output.frame_times =
      continued_times(before.output.frame_times, earlier_end, now.output.frame_times, end);
  std::vector<double> pictures = before.output.picture_times;
  std::erase_if(pictures, [=](double time) { return time >= earlier_end; });
  const auto& wanted = now.output.picture_times;
  if (wanted.size() < pictures.size() ||
      !std::equal(pictures.begin(), pictures.end(), wanted.begin())) {
    pictures.push_back(end);
    now.output.picture_times = pictures;
  }
  settings.case_text = write_used(now);
}

}  // namespace kerf
