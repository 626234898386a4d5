// SPDX-License-Identifier: Apache-2.0
#include "output/layer_metrics.hpp"

#include "model/case.hpp"

namespace kerf {

const MetricList<NamedLayer>& NamedLayer::metrics() {
  using L = NamedLayer;
  static const MetricList<L> list = [] {
    MetricList<L> all{{"name", "1", "body", "Name of the body.", &L::name}};
    add_metrics(all, KerfShape::metrics(), "", "kerf in the layer",
                [](const L& entry) -> const KerfShape& { return entry.layer.shape; });
    const MetricList<L> amounts{
        {"volume", extensive("m3"), "volume of the layer", "Initial volume of the body.",
         [](const L& entry) { return entry.layer.volume; }},
        {"removed_volume", extensive("m3"), "volume removed from the layer",
         "Initial volume of the body's solid that no longer stands.",
         [](const L& entry) { return entry.layer.removed_volume; }},
        {"removed_fraction", share(), "removed share of the layer",
         "Removed volume over the volume.", [](const L& entry) {
           const KerfLayer& layer = entry.layer;
           return layer.volume > 0.0 ? layer.removed_volume / layer.volume : 0.0;
         }}};
    all.insert(all.end(), amounts.begin(), amounts.end());
    return all;
  }();
  return list;
}

std::vector<NamedLayer> named_layers(const Kerf& kerf, const Case& description) {
  std::vector<NamedLayer> layers;
  for (const KerfLayer& layer : kerf.layers)
    layers.push_back({description.bodies.at(static_cast<std::size_t>(layer.body)).name, layer});
  return layers;
}

}  // namespace kerf
