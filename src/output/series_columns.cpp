// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "model/case.hpp"
#include "output/balance_metrics.hpp"
#include "output/csv.hpp"
#include "output/series.hpp"

namespace kerf {
namespace {

using Columns = std::vector<SeriesColumn>;

// Returns the shortest text that is read back to the same bits; `index` selects one of several
// numbers.
template <class Value>
std::string text_of(const Value& value, std::size_t index = 0) {
  if constexpr (std::is_same_v<Value, std::vector<double>>)
    return text_of(value.at(index));
  else if constexpr (std::is_same_v<Value, bool>)
    return value ? "1" : "0";
  else if constexpr (std::is_same_v<Value, std::string>)
    return csv_text(value);
  else if constexpr (std::is_same_v<Value, std::monostate>)
    return "";
  else
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

// One column for a number, three for a vector.
template <class Record>
void add_metrics(Columns& columns, const MetricList<Record>& metrics, int dimension,
                 Record SeriesSample::*record) {
  for (const Metric<Record>& metric : metrics) {
    const std::string unit = metric.unit.in(dimension);
    const bool is_vector = metric.kind == MetricKind::numbers;
    for (std::size_t k = 0; k < (is_vector ? 3 : 1); ++k)
      columns.push_back({is_vector ? fmt::format("{}_{}", metric.name, "xyz"[k]) : metric.name,
                         unit, [record, k, read = metric.value](const SeriesSample& sample) {
                           return std::visit([k](const auto& value) { return text_of(value, k); },
                                             read(sample.*record));
                         }});
  }
}

void add_probes(Columns& columns, const Case& description) {
  std::size_t index = 0;  // in SeriesSample::probes
  const auto add = [&](const std::string& name, const std::string& unit) {
    columns.push_back(
        column(name, unit, [index](const SeriesSample& s) { return s.probes.at(index); }));
    ++index;
  };
  for (const Probe& probe : description.probes) {
    const bool point = !probe.is_plane();
    if (point) add(probe.name + "_pressure", "Pa");
    for (const char axis : {'x', 'y', 'z'}) {
      if (point)
        add(fmt::format("{}_velocity_{}", probe.name, axis), "m/s");
      else
        add(fmt::format("{}_force_{}", probe.name, axis), extensive("N").in(description.dimension));
    }
  }
}

}  // namespace

std::vector<SeriesColumn> series_columns(const Case& description) {
  Columns columns;
  add_clock(columns);
  const int dimension = description.dimension;
  add_metrics(columns, CutState::metrics(), dimension, &SeriesSample::cut);
  columns.push_back(
      column("removed_mass", extensive("kg").in(dimension),
             [](const SeriesSample& s) { return s.balance.mass_out + s.balance.mass_erased; }));
  add_metrics(columns, balance_terms(), dimension, &SeriesSample::balance);
  add_metrics(columns, balance_errors(), dimension, &SeriesSample::balance);
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
