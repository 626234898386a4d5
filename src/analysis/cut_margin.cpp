// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut_margin.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/unbroken.hpp"

namespace kerf {

const MetricList<CutMargin>& CutMargin::metrics() {
  static const MetricList<CutMargin> list{
      {"margin", share(), "margin of the cut",
       "Share of the time that the case states (`end`) which was left after the cut; below 0, "
       "minus the share of the thickness in the way of the jet that is unbroken.",
       &CutMargin::value},
      {"unbroken", "m", "unbroken thickness in the way of the jet",
       "Least thickness, as laid out, of solid that stands and has kept its bonds, over the bodies "
       "that are not cut through.",
       &CutMargin::unbroken}};
  return list;
}

CutMargin CutMargin::measure(const KerfScene& scene) {
  const KerfConditions& conditions = scene.conditions;
  CutMargin margin;
  // Of the bodies in the way, by index into Case::bodies: all, and those that are not cut through.
  std::vector<BodyCount> all, uncut;
  for (const WorkpieceBody& body : scene.view.workpiece.bodies) {
    all.resize(body.body + std::size_t(1), BodyCount::not_at_all);
    uncut.resize(all.size(), BodyCount::not_at_all);
    if (!body.is_in_way) continue;
    const BodyVerdict* verdict = conditions.verdict_on(body.body);
    all.back() = BodyCount::in_full;
    const bool is_cut = verdict != nullptr && verdict->cut.through;
    uncut.back() = is_cut ? BodyCount::as_laid_out : BodyCount::in_full;
  }
  const auto measure = [&](const std::vector<BodyCount>& counts) {
    return measure_unbroken(scene.view, scene.axes, scene.path, counts);
  };
  constexpr double rounding = 1e-6;
  const UnbrokenThickness whole = measure(all);
  margin.is_whole = tells_torn(scene.view.frame) && whole.laid_out > 0.0 &&
                    whole.unbroken > (1.0 - rounding) * whole.laid_out;
  if (!std::isnan(conditions.cut_through_time)) {
    margin.value = conditions.share_after(conditions.cut_through_time, scene.view.frame.time);
    return margin;
  }
  // What is torn and still joins the sides is no cut: the margin stays below 0.
  constexpr double least = 1e-12;
  const UnbrokenThickness left = uncut == all ? whole : measure(uncut);
  margin.value = 0.0;
  if (!(left.laid_out > 0.0)) return margin;
  // Sums over windows leave a rest of rounding, of either sign.
  if (left.least >= rounding * left.laid_out) margin.unbroken = left.least;
  const double share = left.unbroken / left.laid_out;
  margin.value = share < rounding ? -least : -share;
  return margin;
}

}  // namespace kerf
