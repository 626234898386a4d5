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
  double laid_out = 0.0, left = 0.0;
  KerfView view = scene.view;
  for (const WorkpieceBody& body : scene.view.workpiece.bodies) {
    if (!body.is_in_way) continue;
    view.body = body.body;
    const UnbrokenThickness thickness = measure_unbroken(view, scene.axes, scene.path);
    laid_out += thickness.laid_out;
    left += thickness.unbroken;
    const BodyVerdict* verdict = conditions.verdict_on(body.body);
    if (verdict == nullptr || !verdict->cut.through) margin.unbroken += thickness.unbroken;
  }
  constexpr double rounding = 1e-6;
  margin.is_whole =
      tells_torn(scene.view.frame) && laid_out > 0.0 && left > (1.0 - rounding) * laid_out;
  if (!std::isnan(conditions.cut_through_time)) {
    margin.value = conditions.share_after(conditions.cut_through_time, scene.view.frame.time);
    margin.unbroken = 0.0;
    return margin;
  }
  // Sums over windows leave a rest of rounding, of either sign.
  if (margin.unbroken < rounding * laid_out) margin.unbroken = 0.0;
  // What is torn and still joins the sides is no cut: the margin stays below 0.
  constexpr double least = 1e-12;
  margin.value = laid_out > 0.0 ? -std::max(margin.unbroken / laid_out, least) : 0.0;
  return margin;
}

}  // namespace kerf
