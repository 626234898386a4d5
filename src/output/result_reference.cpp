// SPDX-License-Identifier: Apache-2.0
#include "output/result_reference.hpp"

#include <fmt/format.h>

#include "output/result_metrics.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;
using Form = ResultMetric::Form;
using When = ResultMetric::When;

// Returns the text of the column of units: the unit of a number, or the type of another value.
std::string unit_text(const MetricText& metric) {
  if (metric.kind == MetricKind::flag) return "true or false";
  if (metric.kind == MetricKind::text) return "text";
  const std::string space = metric.unit.in(3), plane = metric.unit.in(2);
  return space == plane ? space : fmt::format("{} (2D: {})", space, plane);
}

std::string table_row(const std::string& name, const std::string& unit, const MetricText& metric) {
  return fmt::format("| `{}` | {} | {} | {} |\n", name, unit, metric.label, metric.meaning);
}

Json value_schema(const MetricText& metric) {
  static constexpr const char* types[] = {"number", "integer", "boolean", "string", "array"};
  const char* type = types[static_cast<std::size_t>(metric.kind)];
  Json schema;
  schema["type"] = metric.may_be_missing ? Json{type, "null"} : Json(type);
  if (metric.kind == MetricKind::numbers) schema["items"] = {{"type", {"number", "null"}}};
  schema["title"] = metric.label;
  schema["description"] = metric.meaning;
  const std::string space = metric.unit.in(3), plane = metric.unit.in(2);
  const bool is_number = metric.kind != MetricKind::flag && metric.kind != MetricKind::text;
  if (is_number) schema["unit"] = space;
  if (is_number && space != plane) schema["unit_2d"] = plane;
  return schema;
}

Json object_schema() {
  return {{"type", "object"},
          {"properties", Json::object()},
          {"required", Json::array()},
          {"additionalProperties", false}};
}

// The requirement of a key.
struct Required {
  bool object, key;  // the object that holds the key, and in it the key
};

// Puts the schema of a key into that of the object that holds it; a dot leads into an inner object.
void put(Json& object, const std::string& name, Json schema, Required required) {
  const std::size_t dot = name.find('.');
  const std::string key = name.substr(0, dot);
  if (dot == std::string::npos) {
    object["properties"][key] = std::move(schema);
    if (required.key) object["required"].push_back(key);
    return;
  }
  if (!object["properties"].contains(key)) {
    object["properties"][key] = object_schema();
    if (required.object) object["required"].push_back(key);
  }
  put(object["properties"][key], name.substr(dot + 1), std::move(schema), {true, required.key});
}

Json schema_of(const ResultMetric& metric) {
  if (metric.form == Form::value) return value_schema(metric);
  Json schema{{"title", metric.label}, {"description", metric.meaning}};
  if (metric.form == Form::table) {
    schema["type"] = "object";
    schema["additionalProperties"] = {{"type", "number"}, {"unit", metric.unit.in(3)}};
    return schema;
  }
  Json entry = object_schema();
  for (const MetricText& text : metric.entries)
    put(entry, text.name, value_schema(text), {true, true});
  schema["type"] = "array";
  schema["items"] = std::move(entry);
  return schema;
}

}  // namespace

std::string metrics_table() {
  std::string text = "| name | unit | label | meaning |\n| --- | --- | --- | --- |\n";
  for (const ResultMetric& metric : result_metrics()) {
    const bool is_list = metric.form == Form::records;
    text += table_row(metric.name, is_list ? "list" : unit_text(metric), metric);
    for (const MetricText& entry : metric.entries)
      text += table_row(metric.name + "[]." + entry.name, unit_text(entry), entry);
  }
  return text;
}

Json result_schema() {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", "result.json of a run of Kerf"}};
  schema.update(object_schema());
  for (const ResultMetric& metric : result_metrics())
    put(schema, metric.name, schema_of(metric),
        {metric.when == When::always, metric.when != When::with_such_machine});
  return schema;
}

}  // namespace kerf
