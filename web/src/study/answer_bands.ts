// SPDX-License-Identifier: Apache-2.0
// The brackets and intervals of a study's answers, where the key they are of is the horizontal axis.

import type { Box, Scale } from "./axes.ts";
import type { StudyData } from "./study_data.ts";
import { svg } from "./svg.ts";
import { all, type View } from "./view.ts";

export interface AnswerBand {
  label: string;
  low: number; // SI
  high: number;
  value?: number; // a line at it
  symbol: () => SVGElement;
  attributes: Record<string, string | number>;
}

function band(label: string, low: number, high: number, attributes: Record<string, string | number>, value?: number): AnswerBand {
  const symbol = () => svg("rect", { x: -9, y: -7, width: 18, height: 14, ...attributes });
  return { label, low, high, value, symbol, attributes };
}

export function bandsOfAnswers(data: StudyData, view: View): AnswerBand[] {
  const { search, calibration } = data.study;
  const bands: AnswerBand[] = [];
  if (search && search.key === view.x && search.low !== null && search.high !== null) {
    bands.push(band("answer with its interval", search.low, search.high, { fill: "#0072b2", "fill-opacity": 0.13 }, search.value ?? undefined));
    if (search.bracket) bands.push(band("bracket of the runs", search.bracket.low, search.bracket.high, { fill: "#0072b2", "fill-opacity": 0.3 }));
    if (search.draft && view.refinement === all)
      bands.push(band("bracket of the drafts", search.draft.low, search.draft.high, { fill: "#8a929c", "fill-opacity": 0.25, stroke: "#8a929c", "stroke-dasharray": "3 3" }));
  }
  if (calibration && calibration.key === view.x && calibration.low !== null && calibration.high !== null)
    bands.push(band("calibrated, with its interval", calibration.low, calibration.high, { fill: "#0072b2", "fill-opacity": 0.16 }, calibration.value ?? undefined));
  return bands;
}

export function drawAnswerBands(bands: AnswerBand[], box: Box, x: Scale): SVGGElement {
  const root = svg("g", { class: "kerf-answer-bands" });
  for (const { low, high, value, attributes } of bands) {
    const [left, right] = [x.place(low), x.place(high)];
    root.append(svg("rect", { x: left, y: box.top, width: Math.max(1, right - left), height: box.height, ...attributes }));
    if (value === undefined) continue;
    const at = x.place(value);
    root.append(svg("line", { x1: at, x2: at, y1: box.top, y2: box.top + box.height, stroke: "#0072b2", "stroke-width": 2, "stroke-dasharray": "7 4" }));
  }
  return root;
}

export function measuredOf(data: StudyData, view: View): { low: number; high: number; value: number } | undefined {
  const { calibration } = data.study;
  const isShown = calibration && calibration.metric === view.metric && calibration.key === view.x && calibration.metric !== "cut_through";
  if (!isShown) return undefined;
  const { measured, uncertainty } = calibration;
  return { low: measured - 2 * uncertainty, high: measured + 2 * uncertainty, value: measured };
}
