// SPDX-License-Identifier: Apache-2.0
// The table of all metrics of a run: the keys of result.json with their units, labels and meanings.
// Tables of studies, the report and the pages of the viewer take names, units and labels from here;
// docs/metrics.md and docs/result.schema.json are generated from it.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/metric.hpp"

namespace kerf {

struct RunOutcome;

struct ResultMetric : MetricText {
  explicit ResultMetric(MetricText text) : MetricText(std::move(text)) {}

  enum class Form {
    value,    // of the kind that `kind` names
    records,  // a list of objects with the keys of `entries`
    table     // an object of numbers with free names
  };
  // The cases that have the key; `with_such_machine`: those whose machine has that number.
  enum class When {
    always,
    with_jet,
    with_machine,
    with_such_machine,
    with_exposure,
    with_travelling_frame
  };

  Form form = Form::value;
  When when = When::always;
  std::vector<MetricText> entries;
  // The JSON value; nothing where the case has no such key.
  std::function<std::optional<nlohmann::ordered_json>(const RunOutcome&)> value;
};

// Every key of result.json in its order; a dot leads into an object.
const std::vector<ResultMetric>& result_metrics();

// Returns the metric of that name, or null.
const ResultMetric* find_result_metric(std::string_view name);
// Returns the SI unit of a metric in a case of that dimension; "" for a pure number, a word, or an
// unknown name.
std::string metric_unit(std::string_view name, int dimension);
// Returns the label of a metric; the name itself if it is unknown.
std::string metric_label(std::string_view name);

}  // namespace kerf
