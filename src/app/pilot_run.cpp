// SPDX-License-Identifier: Apache-2.0
#include "app/pilot_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <toml++/toml.h>

#include "app/checked_case.hpp"
#include "app/run_cost.hpp"
#include "input/draft.hpp"
#include "input/read.hpp"
#include "input/units.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "report/html.hpp"

namespace kerf {

namespace {

constexpr double wanted_time = 30.0;        // s, of the run
constexpr double arrivals = 2.0;            // simulated at least, in times that the jet flies
constexpr double factor_without_jet = 2.0;  // of spacings

std::string pilot_text(const toml::table& table) {
  std::ostringstream text;
  text << pilot_mark << '\n' << table << '\n';
  return text.str();
}

// Returns the factor by which spacings grow in draft quality.
double coarsening(const Case& description) {
  if (description.jets.empty()) return factor_without_jet;
  double factor = 1.0;
  const int across = particles_across(Quality::draft, description.dimension);
  for (const Jet& jet : description.jets)
    factor = std::max(factor, jet.width / jet.spacing / across);
  return factor;
}

void coarsen(toml::table& table, double factor) {
  const auto written = table["spacing"].value<std::string>();
  if (!written) return;
  const Quantity spacing = read_quantity(*written, "m");
  if (spacing.problem.empty())
    table.insert_or_assign("spacing", fmt::format("{:.6g} mm", 1e3 * factor * spacing.value));
}

void coarsen_spacings(toml::table& root, double factor) {
  for (const char* name : {"machine", "workpiece"})
    if (toml::table* table = root[name].as_table()) coarsen(*table, factor);
  for (const char* name : {"body", "jet"}) {
    toml::array* list = root[name].as_array();
    for (std::size_t n = 0; list && n < list->size(); ++n)
      if (toml::table* table = list->get(n)->as_table()) coarsen(*table, factor);
  }
}

// Returns the time at which the last jet meets its workpiece, s.
double arrival(const Case& description) {
  double time = 0.0;
  for (const Jet& jet : description.jets)
    time = std::max(time, jet.start + jet.standoff / jet.speed);
  return time;
}

void set_end(toml::table& root, double end) {
  if (!root.contains("time")) root.insert("time", toml::table{});
  root["time"].as_table()->insert_or_assign("end", fmt::format("{:.4g} ms", 1e3 * end));
  // Times beyond the end are refused, and intervals would leave few frames.
  if (toml::table* output = root["output"].as_table())
    for (const char* key : {"frame_times", "picture_times", "frame_interval", "series_interval"})
      output->erase(key);
}

}  // namespace

PilotRun pilot_run(const std::string& text, const std::string& file, int threads) {
  Case chosen = parse_case(text, file, quick_look);
  const double full_end = derive(chosen).likely_end;
  PilotRun pilot;
  toml::table root = toml::parse(text), coarse = root;
  coarse.insert_or_assign("quality", "draft");
  coarsen_spacings(coarse, coarsening(chosen));
  if (const auto description = valid_case(pilot_text(coarse), file)) {
    const auto particles = [](const Case& of) {
      return html::count(static_cast<double>(derive(of).particles_expected));
    };
    pilot.changes.push_back(fmt::format("Draft quality: {} particles in place of {}.",
                                        particles(*description), particles(chosen)));
    chosen = *description;
    root = coarse;
  }
  const double seconds = run_cost(derive(chosen), typical_pace(chosen, threads)).seconds;
  const double end = std::max(full_end * wanted_time / seconds, arrivals * arrival(chosen));
  if (end < full_end) {
    toml::table shortened = root;
    set_end(shortened, end);
    if (valid_case(pilot_text(shortened), file)) {
      root = shortened;
      pilot.changes.push_back(fmt::format("It ends at {} in place of {}.", readable(end, "s"),
                                          readable(full_end, "s")));
    }
  }
  pilot.text = pilot_text(root);
  return pilot;
}

}  // namespace kerf
