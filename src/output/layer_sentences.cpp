// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "model/case.hpp"
#include "output/layer_metrics.hpp"
#include "output/result.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {

std::string join_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t n = 0; n < names.size(); ++n)
    text += (n == 0 ? "" : n + 1 == names.size() ? " and " : ", ") + names[n];
  return text;
}

std::string layers_clause(const RunOutcome& outcome) {
  if (!outcome.kerf) return "";
  std::vector<std::pair<std::string, std::vector<std::string>>> by_fate;
  std::size_t count = 0;
  for (const NamedLayer& layer : named_layers(*outcome.kerf, outcome.description)) {
    if (!layer.layer.verdict.is_in_way) continue;
    ++count;
    const std::string fate = fate_of(layer.layer);
    const auto known = std::find_if(by_fate.begin(), by_fate.end(),
                                    [&](const auto& entry) { return entry.first == fate; });
    if (known == by_fate.end())
      by_fate.push_back({fate, {layer.name}});
    else
      known->second.push_back(layer.name);
  }
  std::string text;
  if (count < 2) return text;
  for (const auto& [fate, names] : by_fate)
    text += fmt::format("{}{} {} {}", text.empty() ? "; " : ", ", join_names(names),
                        names.size() == 1 ? "is" : "are", fate);
  return text;
}

bool fills_the_way(const NamedLayer& layer, const RunOutcome& outcome) {
  const double width = outcome.description.jets.front().width;
  return layer.layer.left < -width && layer.layer.right > width;
}

std::string beside_clause(const RunOutcome& outcome) {
  if (!outcome.kerf) return "";
  const double spacing = finest_spacing(outcome);
  std::vector<std::string> names;
  for (const NamedLayer& layer : named_layers(*outcome.kerf, outcome.description))
    if (layer.layer.top > spacing / 2.0 && !fills_the_way(layer, outcome) &&
        layer.layer.stands_above(outcome.cut.last.cut_depth - spacing))
      names.push_back(layer.name);
  return names.empty() ? "" : " deep beside " + join_names(names);
}

}  // namespace kerf
