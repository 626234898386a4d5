// SPDX-License-Identifier: Apache-2.0
// Changes that end the run of a window that travels with its nozzle.
#include <fmt/format.h>

#include <limits>

#include "analysis/stationary_cut.hpp"
#include "app/case_changes.hpp"
#include "machine/simulated_piece.hpp"
#include "machine/travelling_frame.hpp"
#include "output/readable.hpp"

namespace kerf {

namespace {

// Returns when the nozzle has cut so far that stretches of its path can be compared, s: after the
// flight and passage of the water and `stretches` of them; infinite where no window travels.
double end_of_stretches(const Case& description) {
  constexpr double stretches = 4.0;
  const auto frame = travelling_frame(description);
  if (!frame) return std::numeric_limits<double>::infinity();
  const Jet& jet = description.jets.back();
  return frame->start + passage_time(jet, description.workpiece->depth) +
         stretches * stretch_widths * jet.width / frame->speed;
}

}  // namespace

std::optional<CaseChange> shorter_path(const Case& description) {
  const double end = end_of_stretches(description);
  if (!(end < description.time.end)) return {};
  CaseChange change;
  const std::string value = fmt::format("{:.4g} ms", 1e3 * end);
  change.changes.insert("time", toml::table{{"end", value}});
  change.lines.push_back(fmt::format("[time] end = \"{}\"", value));
  return change;
}

std::optional<CaseChange> stationary_stop(const Case& description) {
  const double end = end_of_stretches(description);
  if (!(end < description.time.end) || description.time.stop == RunStop::stationary) return {};
  CaseChange change;
  change.changes.insert("time", toml::table{{"stop", "stationary"}});
  change.lines.emplace_back("[time] stop = \"stationary\"");
  change.ends_at = end;
  change.condition = fmt::format("where the cut is stationary after {}", readable(end, "s"));
  return change;
}

}  // namespace kerf
