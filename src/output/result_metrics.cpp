// SPDX-License-Identifier: Apache-2.0
#include "output/result_metrics.hpp"

#include <algorithm>
#include <utility>

#include "output/balance_metrics.hpp"
#include "output/layer_metrics.hpp"
#include "output/machine_metrics.hpp"
#include "output/metric_json.hpp"
#include "output/result.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;
using When = ResultMetric::When;
using Form = ResultMetric::Form;
using Table = std::vector<ResultMetric>;

bool has(const RunOutcome& outcome, When when) {
  if (when == When::with_jet) return outcome.kerf.has_value();
  if (when == When::with_exposure) return outcome.exposure.has_value();
  if (when == When::with_travelling_frame) return outcome.stationary.has_value();
  return when == When::always || outcome.description.machine.has_value();
}

// Adds the metrics of a record, which `reach` finds in the outcome of a run.
template <class Record, class Reach>
void add(Table& table, const MetricList<Record>& metrics, When when, Reach reach) {
  for (const Metric<Record>& metric : metrics) {
    ResultMetric entry(metric);
    entry.when = when;
    entry.value = [when, reach, read = metric.value](const RunOutcome& outcome) {
      return has(outcome, when) ? std::optional(json_of(read(std::invoke(reach, outcome))))
                                : std::nullopt;
    };
    table.push_back(std::move(entry));
  }
}

// Adds the metrics of a record under a name, with a word for the object that they describe.
template <class Record, class Reach>
void add_under(Table& table, const MetricList<Record>& metrics, const std::string& prefix,
               const std::string& word, Reach reach, When when = When::with_jet) {
  MetricList<RunOutcome> named;
  add_metrics(named, metrics, prefix, word, reach);
  add(
      table, named, when, [](const RunOutcome& outcome) -> auto& { return outcome; });
}

template <class Record>
std::vector<MetricText> texts_of(const MetricList<Record>& metrics) {
  return {metrics.begin(), metrics.end()};
}

// A list of records of one kind, of which `reach` gives a vector.
template <class Record, class Reach>
ResultMetric records(MetricText text, When when, const MetricList<Record>& metrics, Reach reach) {
  ResultMetric entry(std::move(text));
  entry.form = Form::records;
  entry.when = when;
  entry.entries = texts_of(metrics);
  entry.value = [when, reach, &metrics](const RunOutcome& outcome) -> std::optional<Json> {
    if (!has(outcome, when)) return std::nullopt;
    Json list = Json::array();
    for (const Record& record : reach(outcome)) list.push_back(object_of(metrics, record));
    return list;
  };
  return entry;
}

// An object of numbers whose names the run decides, of which `reach` gives pairs of name and
// number.
template <class Reach>
ResultMetric free_table(MetricText text, Reach reach) {
  ResultMetric entry(std::move(text));
  entry.form = Form::table;
  entry.value = [reach](const RunOutcome& outcome) -> std::optional<Json> {
    Json table = Json::object();
    for (const auto& [name, number] : reach(outcome)) table[name] = number;
    return table;
  };
  return entry;
}

void add_cut(Table& table) {
  // The state is that at the end; the summary has whether the workpiece was cut through at any
  // time.
  add(table, CutState::metrics(), When::always, [](const RunOutcome& outcome) {
    CutState state = outcome.cut.last;
    state.cut_through = outcome.cut.cut_through;
    return state;
  });
  add(
      table, CutSummary::metrics(), When::always,
      [](const RunOutcome& outcome) -> auto& { return outcome.cut; });
  table.push_back(records(
      {"fragments", "1", "fragments", "The 100 heaviest fragments."}, When::always,
      Fragment::metrics(), [](const RunOutcome& outcome) {
        constexpr std::size_t most = 100;
        const auto& all = outcome.cut.fragments;
        return std::vector(all.begin(),
                           all.begin() + static_cast<std::ptrdiff_t>(std::min(most, all.size())));
      }));
}

template <class... Measurements>
void add_measurements(Table& table, const std::tuple<Measurements...>*) {
  (add_under(
       table, Measurements::metrics(), "kerf.", "",
       [](const RunOutcome& outcome) -> auto& { return outcome.kerf->of<Measurements>(); }),
   ...);
}

void add_kerf(Table& table) {
  add_under(
      table, KerfShape::metrics(), "kerf.", "kerf",
      [](const RunOutcome& outcome) -> auto& { return outcome.kerf->shape; });
  add_measurements(table, static_cast<const KerfMeasurements*>(nullptr));
  table.push_back(records({"kerf.layers", "1", "layers of the workpiece",
                           "The bodies of the workpiece, the upper first, where it has several."},
                          When::with_jet, NamedLayer::metrics(), [](const RunOutcome& outcome) {
                            return named_layers(*outcome.kerf, outcome.description);
                          }));
  add_under(
      table, KerfShape::metrics(), "opening.", "opening",
      [](const RunOutcome& outcome) -> auto& { return outcome.kerf->opening; });
}

void add_machine(Table& table) {
  const std::size_t first = table.size();
  const auto reach = [](const RunOutcome& outcome) { return MachineRecord{outcome.description}; };
  add(table, MachineRecord::setting(), When::with_machine, reach);
  for (std::size_t i = first; i < table.size(); ++i) {
    if (!table[i].may_be_missing) continue;
    table[i].when = When::with_such_machine;
    table[i].value = [read = table[i].value](const RunOutcome& outcome) {
      const auto value = read(outcome);
      return value && value->is_null() ? std::nullopt : value;
    };
  }
  add(table, MachineRecord::jet(), When::with_machine, reach);
  for (std::size_t i = first; i < table.size(); ++i) table[i].name = "machine." + table[i].name;
}

void add_exposure(Table& table) {
  add_under(
      table, Exposure::metrics(), "exposure.", "",
      [](const RunOutcome& outcome) -> auto& { return *outcome.exposure; }, When::with_exposure);
}

void add_stationary(Table& table) {
  add_under(
      table, StationaryCut::metrics(), "stationary.", "",
      [](const RunOutcome& outcome) -> auto& { return *outcome.stationary; },
      When::with_travelling_frame);
}

void add_run(Table& table) {
  const auto whole = [](const RunOutcome& outcome) -> auto& {
    return outcome;
  };
  add(table, RunOutcome::run_metrics(), When::always, whole);
  table.push_back(
      records({"validity", "1", "validity", "What the run can and cannot promise, flag by flag."},
              When::always, ValidityFlag::metrics(), validity_of));
  table.push_back(free_table(
      {"time_step_limits", "1", "limits of the time step", "Number of steps that each limit set."},
      [](const RunOutcome& outcome) -> auto& { return outcome.time_step_limits; }));
  MetricList<Balance> terms;
  add_metrics(
      terms, balance_terms(), "balance.", "", [](const Balance& b) -> auto& { return b; });
  add(
      table, terms, When::always,
      [](const RunOutcome& outcome) -> auto& { return outcome.balance; });
  table.push_back(free_table(
      {"stage_times", "s", "computing time by stage", "Computing time of each stage of a step."},
      [](const RunOutcome& outcome) {
        std::vector<std::pair<std::string, double>> times;
        for (const StageTime& stage : outcome.stage_times)
          times.emplace_back(stage.name, stage.seconds);
        return times;
      }));
  add(table, RunOutcome::file_metrics(), When::always, whole);
  table.push_back(records(
      {"pictures", "1", "pictures", "The pictures of the run."}, When::always,
      RunPicture::metrics(), [](const RunOutcome& outcome) -> auto& { return outcome.pictures; }));
  table.push_back(records(
      {"intervals", "1", "intervals of the headline numbers",
       "What the spacing and the layout of the particles leave open; empty unless the run "
       "was started with --converge."},
      When::always, MetricInterval::metrics(),
      [](const RunOutcome& outcome) -> auto& { return outcome.intervals; }));
}

Table make_table() {
  Table table;
  const auto whole = [](const RunOutcome& outcome) -> auto& {
    return outcome;
  };
  add(table,
      MetricList<RunOutcome>{
          {"verdict", "1", "verdict", "The result in one sentence.", verdict_of}},
      When::always, whole);
  add_cut(table);
  add_kerf(table);
  add_machine(table);
  add_exposure(table);
  add_stationary(table);
  add(
      table, DerivedNumbers::metrics(), When::always,
      [](const RunOutcome& outcome) -> auto& { return outcome.derived; });
  add(
      table, balance_errors(), When::always,
      [](const RunOutcome& outcome) -> auto& { return outcome.balance; });
  add_run(table);
  return table;
}

}  // namespace

const Table& result_metrics() {
  static const Table table = make_table();
  return table;
}

const ResultMetric* find_result_metric(std::string_view name) {
  const Table& table = result_metrics();
  const auto found = std::find_if(table.begin(), table.end(), [name](const ResultMetric& metric) {
    return metric.name == name;
  });
  return found == table.end() ? nullptr : &*found;
}

std::string metric_unit(std::string_view name, int dimension) {
  const ResultMetric* metric = find_result_metric(name);
  const std::string unit = metric ? metric->unit.in(dimension) : "";
  return unit == "1" ? "" : unit;
}

std::string metric_label(std::string_view name) {
  const ResultMetric* metric = find_result_metric(name);
  return metric ? metric->label : std::string(name);
}

Json result_of(const RunOutcome& outcome) {
  Json result = Json::object();
  for (const ResultMetric& metric : result_metrics())
    if (auto value = metric.value(outcome)) put(result, metric.name, std::move(*value));
  return result;
}

}  // namespace kerf
