// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut_margin.hpp"

#include <cmath>

#include "analysis/unbroken.hpp"

namespace kerf {

double share_after(double cut_through_time, double duration) {
  return duration > 0.0 ? (duration - cut_through_time) / duration : 0.0;
}

const MetricList<CutMargin>& CutMargin::metrics() {
  static const MetricList<CutMargin> list{
      {"margin", share(), "margin of the cut",
       "Share of the run that was left after the cut; below 0, minus the share of the thickness in "
       "the way of the jet that is unbroken.",
       &CutMargin::value},
      {"unbroken", "m", "unbroken thickness in the way of the jet",
       "Least thickness, as laid out, of solid that stands and has kept its bonds, over the bodies "
       "that are not cut through.",
       &CutMargin::unbroken}};
  return list;
}

CutMargin CutMargin::measure(const KerfScene& scene) {
  const KerfConditions& conditions = scene.conditions;
  if (!std::isnan(conditions.cut_through_time))
    return {share_after(conditions.cut_through_time, scene.view.frame.time), 0.0};
  CutMargin margin;
  double laid_out = 0.0;
  KerfView view = scene.view;
  for (const WorkpieceBody& body : scene.view.workpiece.bodies) {
    if (!body.is_in_way) continue;
    view.body = body.body;
    const UnbrokenThickness thickness = measure_unbroken(view, scene.axes, scene.path);
    laid_out += thickness.laid_out;
    const BodyVerdict* verdict = conditions.verdict_on(body.body);
    if (verdict == nullptr || !verdict->cut.through) margin.unbroken += thickness.unbroken;
  }
  if (laid_out > 0.0) margin.value = -margin.unbroken / laid_out;
  return margin;
}

}  // namespace kerf
