// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "output/csv.hpp"
#include "output/ledger_table.hpp"
#include "output/series.hpp"

namespace kerf {
namespace {

using Columns = std::vector<SeriesColumn>;

// Shortest text that reads back to the same bits.
std::string text_of(double value) {
  return fmt::format("{}", value);
}

template <class Value>
SeriesColumn column(const std::string& name, const std::string& unit, Value value) {
  return {name, unit, [value](const SeriesSample& sample) {
            if constexpr (std::is_convertible_v<decltype(value(sample)), std::string>)
              return csv_text(value(sample));  // names of probes and limits are free text
            else
              return text_of(static_cast<double>(value(sample)));
          }};
}

SeriesColumn count(const std::string& name,
                   std::function<std::uint64_t(const SeriesSample&)> value) {
  return {name, "1",
          [value](const SeriesSample& sample) { return fmt::format("{}", value(sample)); }};
}

void add_clock(Columns& columns) {
  columns.push_back(column("time", "s", [](const SeriesSample& s) { return s.time; }));
  columns.push_back(count("step", [](const SeriesSample& s) { return s.step; }));
  columns.push_back(column("dt", "s", [](const SeriesSample& s) { return s.last_step.dt; }));
  columns.push_back(column("limit", "1", [](const SeriesSample& s) { return s.last_step.limit; }));
  columns.push_back(count("particles", [](const SeriesSample& s) { return s.particles; }));
}

void add_cut(Columns& columns, const std::string& mass_unit) {
  const auto add = [&](const char* name, const std::string& unit, double CutState::*place) {
    columns.push_back(
        column(name, unit, [place](const SeriesSample& sample) { return sample.cut.*place; }));
  };
  add("front_depth", "m", &CutState::front_depth);
  add("fractured_mass", mass_unit, &CutState::fractured_mass);
  add("fractured_fraction", "1", &CutState::fractured_fraction);
  add("fractured_width", "m", &CutState::fractured_width);
  add("kerf_width", "m", &CutState::kerf_width);
  columns.push_back(count(
      "pieces", [](const SeriesSample& s) { return static_cast<std::uint64_t>(s.cut.pieces); }));
  columns.push_back(
      count("cut_through", [](const SeriesSample& s) { return s.cut.cut_through ? 1u : 0u; }));
  columns.push_back(column("removed_mass", mass_unit, [](const SeriesSample& s) {
    return s.ledger.mass_out + s.ledger.mass_erased;
  }));
}

void add_ledger(Columns& columns, int dimension) {
  for (const LedgerTerm& term : ledger_terms()) {
    const std::string unit = extensive_unit(term.unit, dimension);
    if (term.scalar != nullptr)
      columns.push_back(column(term.name, unit, [place = term.scalar](const SeriesSample& s) {
        return s.ledger.*place;
      }));
    for (std::size_t k = 0; term.vector != nullptr && k < 3; ++k)
      columns.push_back(
          column(fmt::format("{}_{}", term.name, "xyz"[k]), unit,
                 [place = term.vector, k](const SeriesSample& s) { return (s.ledger.*place)[k]; }));
  }
  columns.push_back(
      column("mass_error", "1", [](const SeriesSample& s) { return s.ledger.mass_error(); }));
  columns.push_back(column("momentum_error", "1",
                           [](const SeriesSample& s) { return s.ledger.momentum_error(); }));
  columns.push_back(column("pressure_energy_gap", "1",
                           [](const SeriesSample& s) { return s.ledger.pressure_energy_gap(); }));
  columns.push_back(
      column("energy_drift", "1", [](const SeriesSample& s) { return s.ledger.energy_drift(); }));
}

void add_probes(Columns& columns, const Case& description) {
  std::size_t place = 0;  // in SeriesSample::probes
  const auto add = [&](const std::string& name, const std::string& unit) {
    columns.push_back(
        column(name, unit, [place](const SeriesSample& s) { return s.probes.at(place); }));
    ++place;
  };
  for (const Probe& probe : description.probes) {
    const bool point = probe.kind == Probe::Kind::point;
    if (point) add(probe.name + "_pressure", "Pa");
    for (const char axis : {'x', 'y', 'z'}) {
      if (point)
        add(fmt::format("{}_velocity_{}", probe.name, axis), "m/s");
      else
        add(fmt::format("{}_force_{}", probe.name, axis),
            extensive_unit("N", description.dimension));
    }
  }
}

}  // namespace

std::vector<SeriesColumn> series_columns(const Case& description) {
  Columns columns;
  add_clock(columns);
  add_cut(columns, extensive_unit("kg", description.dimension));
  add_ledger(columns, description.dimension);
  add_probes(columns, description);
  return columns;
}

std::string header_of(const SeriesColumn& column) {
  std::string unit;
  for (const char c : column.unit) {
    if (c == '/')
      unit += "_per_";
    else
      unit += c == ' ' ? '_' : c;
  }
  return csv_text(column.unit == "1" ? column.name : column.name + "_" + unit);
}

}  // namespace kerf
