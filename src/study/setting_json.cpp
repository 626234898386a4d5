// SPDX-License-Identifier: Apache-2.0
#include "study/setting_json.hpp"

namespace kerf {

nlohmann::ordered_json setting_json(const Setting& setting) {
  auto json = nlohmann::ordered_json::object();
  for (const auto& [key, value] : setting.numbers) json[key] = value;
  for (const auto& [key, value] : setting.words) json[key] = value;
  return json;
}

Setting setting_of(const nlohmann::ordered_json& json) {
  Setting setting;
  for (const auto& [key, value] : json.items()) {
    if (value.is_string())
      setting.words[key] = value.get<std::string>();
    else
      setting.numbers[key] = value.get<double>();
  }
  return setting;
}

}  // namespace kerf
