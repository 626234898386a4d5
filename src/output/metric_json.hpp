// SPDX-License-Identifier: Apache-2.0
// Metrics as JSON: a record becomes an object, and a name with a dot a key of an object inside.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/metric.hpp"

namespace kerf {

// null where there is no value.
inline nlohmann::ordered_json json_of(const MetricValue& value) {
  return std::visit(
      [](const auto& raw) {
        if constexpr (std::is_same_v<std::decay_t<decltype(raw)>, std::monostate>)
          return nlohmann::ordered_json(nullptr);
        else
          return nlohmann::ordered_json(raw);
      },
      value);
}

// Writes a value at a path of keys that are joined by dots.
inline void put(nlohmann::ordered_json& object, std::string_view path,
                nlohmann::ordered_json value) {
  nlohmann::ordered_json* target = &object;
  for (std::size_t dot; (dot = path.find('.')) != std::string_view::npos;
       path.remove_prefix(dot + 1))
    target = &(*target)[std::string(path.substr(0, dot))];
  (*target)[std::string(path)] = std::move(value);
}

template <class Record>
nlohmann::ordered_json object_of(const MetricList<Record>& metrics, const Record& record) {
  auto object = nlohmann::ordered_json::object();
  for (const Metric<Record>& metric : metrics)
    put(object, metric.name, json_of(metric.value(record)));
  return object;
}

}  // namespace kerf
