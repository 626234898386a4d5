// SPDX-License-Identifier: Apache-2.0
#include "app/run_json.hpp"

#include "report/metric_rows.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

// The numbers that tell of a cut, by their paths in result.json.
constexpr const char* key_metrics[] = {"cut_through_time",
                                       "front_speed",
                                       "front_depth",
                                       "cut_depth",
                                       "kerf.depth",
                                       "kerf.margin",
                                       "kerf.middle.width",
                                       "kerf_width",
                                       "fractured_fraction",
                                       "pieces",
                                       "exposure.greatest_feed",
                                       "exposure.possible_feed",
                                       "energy_drift",
                                       "end_time",
                                       "wall_time"};

// Returns the value of a metric; null where there is none.
Json value_at(const Json& result, const std::string& name) {
  const Json* value = find_value(result, name);
  return value != nullptr ? *value : Json();
}

Json bodies_of(const Json& result) {
  Json bodies = Json::array();
  const Json layers = value_at(result, "kerf.layers");
  for (const Json& layer : layers)
    bodies.push_back({{"name", layer.at("name")},
                      {"verdict", layer.at("verdict")},
                      {"cut_through_time", value_at(layer, "cut_through_time")}});
  return bodies;
}

Json warnings_of(const Json& result) {
  Json warnings = Json::array();
  for (const Json& flag : result.at("validity"))
    if (flag.at("state") == "warning")
      warnings.push_back({{"name", flag.at("name")}, {"sentence", flag.at("sentence")}});
  return warnings;
}

}  // namespace

std::string run_json(const Json& result, const std::filesystem::path& folder) {
  Json json = {{"case", result.at("case")},
               {"title", result.at("title")},
               {"folder", folder.string()},
               {"report", (folder / "report.html").string()},
               {"result", (folder / "result.json").string()},
               {"verdict", result.at("verdict")},
               {"cut_through", result.at("cut_through")},
               {"bodies", bodies_of(result)},
               {"metrics", Json::object()},
               {"intervals", value_at(result, "intervals")},
               {"warnings", warnings_of(result)}};
  for (const char* path : key_metrics) json["metrics"][path] = value_at(result, path);
  return json.dump(2) + "\n";
}

}  // namespace kerf
