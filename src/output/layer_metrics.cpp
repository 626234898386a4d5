// SPDX-License-Identifier: Apache-2.0
#include "output/layer_metrics.hpp"

#include <cmath>

#include "model/case.hpp"

namespace kerf {

std::string fate_of(const KerfLayer& layer) {
  if (!layer.verdict.is_in_way) return "not under the jet";
  if (layer.verdict.cut.through) {
    if (layer.is_covered) return "broken under a body that is not cut through";
    if (layer.shape.through_share >= 0.5) return "cut through";
    if (layer.shape.through_share > 0.0) return cut_on_part_of_way;
    if (layer.verdict.cut.punched) return "punched out";
    return layer.verdict.cut.severed ? "parted" : "broken through";
  }
  return layer.fractured_mass > 0.0 && !layer.verdict.cut.left ? "cut in part" : "whole";
}

namespace {

// Where a layer lies.
const MetricList<NamedLayer>& place_metrics() {
  using L = NamedLayer;
  static const MetricList<L> list{
      {"face", "m", "depth of the face of the layer",
       "Depth of the body's face at the axis below that of the workpiece, as laid out; none for "
       "a "
       "body beside the jet.",
       [](const L& entry) {
         const double top = entry.layer.top;
         return std::isinf(top) ? std::nullopt : std::optional(top);
       }},
      {"left", "m", "left edge of the layer",
       "Edge of the body as laid out, across the jet from its axis.",
       [](const L& entry) { return entry.layer.left; }},
      {"right", "m", "right edge of the layer", "The other edge, likewise.",
       [](const L& entry) { return entry.layer.right; }}};
  return list;
}

}  // namespace

const MetricList<NamedLayer>& NamedLayer::metrics() {
  using L = NamedLayer;
  static const MetricList<L> list = [] {
    MetricList<L> all{
        {"name", "1", "body", "Name of the body.", &L::name},
        {"verdict", "1", "verdict on the layer",
         "`cut through`; `cut through on a part of the way`, where all of the thickness is removed "
         "on less than half of it under a nozzle that travels; `parted` by a crack, `punched out` "
         "around a plug, or `broken through` while its sides are not parted, where not all of the "
         "thickness is removed; `cut in part`; "
         "`whole`, without any fracture; "
         "`broken under a body that is not cut through`, as where it is crushed without water; "
         "or `not under the jet`.",
         [](const L& entry) { return fate_of(entry.layer); }},
        {"cut_through", "1", "layer cut through", "Whether the body has been cut through.",
         [](const L& entry) { return entry.layer.verdict.cut.through; }},
        {"cut_through_time", "s", "time to cut through the layer",
         "Time at which the body was first found cut through.",
         [](const L& entry) {
           const BodyVerdict& verdict = entry.layer.verdict;
           return verdict.cut.through ? std::optional(verdict.time) : std::nullopt;
         }},
        {"cut_through_by", "1", "kind of the cut of the layer",
         "`severed` where no piece of the body joins the sides of the jet, `punched` where a plug "
         "under the jet is apart from the rim, else `holed`.",
         [](const L& entry) {
           const BodyCut& cut = entry.layer.verdict.cut;
           return cut.through ? std::optional(kind_of_cut(cut.severed, cut.punched)) : std::nullopt;
         }},
        {"margin", share(), "margin of the cut of the layer",
         "Share of the time that the case states (`end`) which was left after the cut; below 0, "
         "minus the share of the body's thickness in the way of the jet that is unbroken.",
         [](const L& entry) { return entry.layer.margin; }},
        {"unbroken", "m", "unbroken thickness of the layer",
         "Least thickness of the body, as laid out, that stands and has kept its bonds in the way "
         "of the jet.",
         [](const L& entry) { return entry.layer.unbroken; }}};
    all.insert(all.end(), place_metrics().begin(), place_metrics().end());
    add_metrics(all, KerfShape::metrics(), "", "kerf in the layer",
                [](const L& entry) -> const KerfShape& { return entry.layer.shape; });
    const MetricList<L> amounts{
        {"volume", extensive("m3"), "volume of the layer", "Initial volume of the body.",
         [](const L& entry) { return entry.layer.volume; }},
        {"removed_volume", extensive("m3"), "volume removed from the layer",
         "Initial volume of the body's solid that no longer stands.",
         [](const L& entry) { return entry.layer.removed_volume; }},
        {"fractured_mass", extensive("kg"), "fractured mass of the layer",
         "Mass of the body that is fractured and has not left the domain.",
         [](const L& entry) { return entry.layer.fractured_mass; }},
        {"removed_fraction", share(), "removed share of the layer",
         "Removed volume over the volume.", [](const L& entry) {
           const double volume = entry.layer.volume;
           return volume > 0.0 ? entry.layer.removed_volume / volume : 0.0;
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
