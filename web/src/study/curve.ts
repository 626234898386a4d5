// SPDX-License-Identifier: Apache-2.0
// A metric over one key: the runs, the bracket of a search, what was measured, the reduced model.

import { drawAxes, drawFrame, leftOf, scaleOf, type Box, type Scale } from "./axes.ts";
import { bandsOfAnswers, drawAnswerBands, measuredOf, type AnswerBand } from "./answer_bands.ts";
import { drawKey, drawMark, verdictEntries, type KeyEntry } from "./marks.ts";
import type { Quantities } from "./quantity.ts";
import { modelOf, seriesOf, type Series } from "./series.ts";
import { numberOf, type ModelPoint, type StudyData, type StudyRun } from "./study_data.ts";
import { soft, svg, text } from "./svg.ts";
import type { Tooltip } from "./tooltip.ts";
import { verdictOf } from "./verdict.ts";
import { meanOf, type View } from "./view.ts";

const strip = 28; // px, at the foot, of the runs that have no value

interface Plot {
  box: Box;
  x: Scale;
  y: Scale;
}

const path = (places: [number, number][]) => places.map(([x, y], at) => `${at === 0 ? "M" : "L"}${x.toFixed(1)},${y.toFixed(1)}`).join("");

function drawModel(points: ModelPoint[], series: Series, view: View, { x, y }: Plot): SVGGElement {
  const at = (point: ModelPoint, value: number): [number, number] => [x.place(point.at[view.x]), y.place(value)];
  const upper = points.map((point) => at(point, point.high));
  const lower = points.map((point) => at(point, point.low)).reverse();
  const band = svg("path", { d: `${path([...upper, ...lower])}Z`, fill: series.colour, "fill-opacity": 0.14, class: "kerf-model-band" });
  const middle = svg("path", { d: path(points.map((point) => at(point, point.value))), fill: "none", stroke: series.colour, "stroke-width": 2, "stroke-dasharray": series.dash });
  return svg("g", { class: "kerf-model" }, band, middle);
}

function drawLine(series: Series, view: View, { x, y }: Plot): SVGPathElement {
  const places = new Map<number, StudyRun[]>();
  for (const run of series.runs) {
    const at = numberOf(run, view.x);
    if (at !== undefined && numberOf(run, view.metric) !== undefined) places.set(at, [...(places.get(at) ?? []), run]);
  }
  const sorted = [...places.entries()].sort(([a], [b]) => a - b);
  const d = path(sorted.map(([at, runs]) => [x.place(at), y.place(meanOf(runs, view.metric))]));
  return svg("path", { d, fill: "none", stroke: series.colour, "stroke-width": 1.5, "stroke-opacity": 0.75, "stroke-dasharray": series.dash });
}

function drawRuns(series: Series, view: View, plot: Plot, quantities: Quantities, tooltip: Tooltip): SVGElement[] {
  const floor = plot.box.top + plot.box.height - 0.5 * strip; // where those without the metric stand
  return series.runs.flatMap((run) => {
    const at = numberOf(run, view.x);
    if (at === undefined) return [];
    const value = numberOf(run, view.metric);
    const place = { x: plot.x.place(at), y: value === undefined ? floor : plot.y.place(value) };
    return drawMark({ ...place, runs: [run], verdict: verdictOf(run), colour: series.colour, size: series.isDraft ? 4 : 6 }, view.metric, quantities, tooltip);
  });
}

function keyEntries(list: Series[], models: ModelPoint[][], bands: AnswerBand[], hasMeasured: boolean): KeyEntry[] {
  const entries = verdictEntries(list.flatMap((series) => series.runs.map(verdictOf)));
  for (const { label, colour, dash } of list)
    if (label !== "") entries.push({ words: label, symbol: svg("path", { d: "M-9,0H9", stroke: colour, "stroke-width": 3, "stroke-dasharray": dash }) });
  for (const band of bands) entries.push({ words: band.label, symbol: band.symbol() });
  if (hasMeasured) entries.push({ words: "measured ± twice its uncertainty", symbol: svg("path", { d: "M-9,0H9", stroke: "#9a3412", "stroke-width": 2 }) });
  if (models.some((points) => points.length > 0)) {
    const block = svg("rect", { x: -9, y: -7, width: 18, height: 14, fill: "#22272e", "fill-opacity": 0.14 });
    entries.push({ words: "reduced model, 95% of runs within", symbol: svg("g", {}, block, svg("path", { d: "M-9,0H9", stroke: "#22272e", "stroke-width": 2 })) });
  }
  return entries;
}

function drawMeasured({ low, high, value }: { low: number; high: number; value: number }, { box, y }: Plot): SVGGElement {
  const [top, bottom] = [y.place(high), y.place(low)];
  const line = { x1: box.left, x2: box.left + box.width, y1: y.place(value), y2: y.place(value), stroke: "#9a3412", "stroke-width": 2 };
  const area = { x: box.left, y: top, width: box.width, height: bottom - top, fill: "#9a3412", "fill-opacity": 0.12 };
  return svg("g", { class: "kerf-measured" }, svg("rect", area), svg("line", line));
}

function drawStrip({ left, top, width, height }: Box): SVGGElement {
  const y = top + height - strip;
  const area = svg("rect", { x: left, y, width, height: strip, fill: "#f5f6f8" });
  const words = text(left - 9, y + 0.5 * strip + 4.5, "none", { "text-anchor": "end", fill: soft });
  return svg("g", {}, area, words, svg("line", { x1: left, x2: left + width, y1: y, y2: y, stroke: soft, "stroke-dasharray": "2 3" }));
}

export function drawCurve(data: StudyData, runs: StudyRun[], view: View, quantities: Quantities, tooltip: Tooltip, width: number): SVGSVGElement {
  const list = seriesOf(data, runs, view, quantities);
  const models = list.map((series) => modelOf(data, view, series));
  const bands = bandsOfAnswers(data, view);
  const measured = measuredOf(data, view);
  const numbers = (name: string) => runs.map((run) => numberOf(run, name)).filter((value) => value !== undefined);
  const ys = [...numbers(view.metric), ...models.flat().flatMap((point) => [point.low, point.high]), ...(measured ? [measured.low, measured.high] : [])];
  const xs = [...numbers(view.x), ...bands.flatMap((band) => [band.low, band.high])];

  const height = Math.round(Math.min(420, Math.max(260, 0.5 * width)));
  const yWishes = { margin: 0.07, fromZero: true, ticksAt: view.metric === "cut_through" ? [0, 1] : undefined };
  const left = leftOf(scaleOf(quantities.get(view.metric), ys, 1, 0, yWishes));
  const box: Box = { left, top: 8, width: width - left - 12, height };
  const x = scaleOf(quantities.get(view.x), xs, left, left + box.width, { margin: 0.06 });
  const hasStrip = numbers(view.metric).length < runs.length;
  const y = scaleOf(quantities.get(view.metric), ys, box.top + height - (hasStrip ? strip : 0), box.top, yWishes);
  const plot: Plot = { box, x, y };

  const root = svg("g", {}, drawAxes(box, x, y, true), drawAnswerBands(bands, box, x));
  if (hasStrip) root.append(drawStrip(box));
  if (measured) root.append(drawMeasured(measured, plot));
  root.append(drawFrame(box));
  const isScattered = view.y !== "" && list.some((series) => series.other === undefined);
  list.forEach((series, at) => {
    if (models[at].length > 0) root.append(drawModel(models[at], series, view, plot));
    else if (!isScattered) root.append(drawLine(series, view, plot));
  });
  for (const series of [...list].reverse()) root.append(...drawRuns(series, view, plot, quantities, tooltip));
  const key = drawKey(keyEntries(list, models, bands, measured !== undefined), left, box.top + height + 62, width - left);
  const whole = box.top + height + 62 + key.height;
  return svg("svg", { viewBox: `0 0 ${width} ${whole}`, width, height: whole, role: "group", id: "kerf-curve-picture" }, root, key.root);
}
