// SPDX-License-Identifier: Apache-2.0
// A process map: a metric, or the verdict, over two keys.

import { Delaunay } from "d3-delaunay";

import { drawAxes, drawFrame, leftOf, scaleOf, type Box, type Scale } from "./axes.ts";
import { bandsOf, drawLadder, ladderWidth, type Bands } from "./bands.ts";
import { ContourDrawing, outline, pathOf, type Plane } from "./contour_lines.ts";
import { drawKey, drawMark, verdictEntries, type KeyEntry } from "./marks.ts";
import { grown, patchesOf, raster, type Node } from "./patches.ts";
import type { Quantities } from "./quantity.ts";
import type { Setting } from "./study_data.ts";
import { hatch, ink, svg } from "./svg.ts";
import type { Tooltip } from "./tooltip.ts";
import { verdictOf } from "./verdict.ts";
import type { Point, View } from "./view.ts";

const size = 161; // of the raster
export const verdictColours = { cut: "#8fc7ec", not_cut: "#fbe3c2" };

interface Ground {
  box: Box;
  x: Scale;
  y: Scale;
  plane: Plane;
  place: (point: Point) => { u: number; v: number };
}

function groundOf(box: Box, x: Scale, y: Scale, points: Point[]): Ground {
  const [columns, rows] = [points.map((point) => x.place(point.x)), points.map((point) => y.place(point.y))];
  const [left, right] = [Math.min(...columns), Math.max(...columns)];
  const [high, low] = [Math.min(...rows), Math.max(...rows)];
  const plane = { x: (u: number) => left + u * (right - left), y: (v: number) => low + v * (high - low) };
  const place = (point: Point) => ({ u: (x.place(point.x) - left) / (right - left || 1), v: (y.place(point.y) - low) / (high - low || 1) });
  return { box, x, y, plane, place };
}

function layer(ground: Ground, points: Point[], value: (point: Point) => number) {
  const nodes: Node[] = points.map((point) => ({ ...ground.place(point), value: value(point) }));
  const patches = patchesOf(nodes.filter((node) => Number.isFinite(node.value)), nodes);
  const values = raster(patches, size);
  const more = grown(grown(values, size), size);
  return { patches, drawing: new ContourDrawing(values, more, size, ground.plane), values };
}

function clip(id: string, d: string) {
  return svg("clipPath", { id }, svg("path", { d }));
}

/** Each run's own value, up to half way to its neighbours. */
function drawCells(root: SVGGElement, ground: Ground, points: Point[], bands: Bands) {
  const { box, x, y } = ground;
  const cells = Delaunay.from(points, (point) => x.place(point.x), (point) => y.place(point.y));
  const areas = svg("g", { class: "kerf-areas" });
  root.append(areas);
  const voronoi = cells.voronoi([box.left, box.top, box.left + box.width, box.top + box.height]);
  points.forEach((point, at) => {
    if (!Number.isFinite(point.value)) return;
    const fill = bands.colourOf(point.value);
    areas.append(svg("path", { d: voronoi.renderCell(at), fill, stroke: fill, "stroke-width": 0.6 }));
  });
}

function drawBands(root: SVGGElement, ground: Ground, points: Point[], bands: Bands) {
  const { patches, drawing } = layer(ground, points, (point) => point.value);
  const areas = svg("g", { "clip-path": "url(#kerf-known)", class: "kerf-areas" });
  root.append(clip("kerf-known", outline(patches, ground.plane)), areas);
  bands.colours.forEach((fill, at) => {
    const d = at === 0 ? outline(patches, ground.plane) : drawing.area(bands.edges[at - 1]);
    areas.append(svg("path", { d, fill }));
  });
  for (const edge of bands.edges)
    areas.append(svg("path", { d: pathOf(drawing.line(edge)), fill: "none", stroke: "#fff", "stroke-opacity": 0.75, "stroke-width": 1 }));
}

function throughShare(point: Point): number {
  const judged = point.runs.map(verdictOf).filter((verdict) => ["cut", "may_cut", "not_cut"].includes(verdict));
  return judged.filter((verdict) => verdict === "cut").length / judged.length;
}

/** Regions, the bracket between runs that do and do not cut, and the boundary half way. */
function drawVerdicts(root: SVGGElement, ground: Ground, points: Point[], withRegions: boolean): boolean {
  const { patches, drawing, values } = layer(ground, points, throughShare);
  if (patches.length === 0) return false;
  const known = outline(patches, ground.plane);
  root.append(clip("kerf-judged", known));
  const inside = svg("g", { "clip-path": "url(#kerf-judged)" });
  root.append(inside);
  if (withRegions) {
    inside.append(svg("path", { d: known, fill: verdictColours.not_cut }));
    inside.append(svg("path", { d: drawing.area(0.5), fill: verdictColours.cut, class: "kerf-region-cut" }));
  }
  const isMixed = values.some((value) => value > 0) && values.some((value) => value < 1);
  if (!isMixed) return false;
  const between = drawing.area(1e-3) + drawing.area(1 - 1e-3);
  inside.append(svg("path", { d: between, "fill-rule": "evenodd", fill: "url(#kerf-bracket)", class: "kerf-bracket" }));
  const d = pathOf(drawing.line(0.5));
  inside.append(svg("path", { d, fill: "none", stroke: "#fff", "stroke-width": 7, "stroke-linejoin": "round" }));
  inside.append(svg("path", { d, fill: "none", stroke: ink, "stroke-width": 3, "stroke-linejoin": "round", class: "kerf-boundary" }));
  return true;
}

function keyEntries(points: Point[], withRegions: boolean, hasBoundary: boolean, hasBest: boolean): KeyEntry[] {
  const block = (fill: string) => svg("rect", { x: -8, y: -7, width: 16, height: 14, fill, stroke: "#8a929c" });
  const entries = verdictEntries(points.map((point) => point.verdict));
  if (withRegions) entries.push({ words: "cuts", symbol: block(verdictColours.cut) }, { words: "does not cut", symbol: block(verdictColours.not_cut) });
  if (hasBoundary) {
    entries.push({ words: "boundary, half way between runs", symbol: svg("path", { d: "M-8,0H8", stroke: ink, "stroke-width": 3 }) });
    const pattern = svg("g", {}, svg("rect", { x: -8, y: -7, width: 16, height: 14, fill: "#9aa3ad" }), block("url(#kerf-bracket)"));
    entries.push({ words: "it may lie anywhere in here", symbol: pattern });
  }
  if (hasBest) entries.push({ words: "answer", symbol: bestRing(7) });
  return entries;
}

function bestRing(radius: number): SVGGElement {
  const ring = (stroke: string, width: number) => svg("circle", { r: radius, fill: "none", stroke, "stroke-width": width });
  return svg("g", { class: "kerf-best" }, ring("#fff", 6), ring("#d55e00", 3));
}

function bestPlace(setting: Setting | undefined, view: View): [number, number] | undefined {
  const [x, y] = [setting?.[view.x], setting?.[view.y]];
  return typeof x === "number" && typeof y === "number" ? [x, y] : undefined;
}

export interface MapWishes {
  width: number; // px
  best: Setting | undefined; // the answer of a search
}

export function drawMap(points: Point[], view: View, quantities: Quantities, tooltip: Tooltip, wishes: MapWishes): SVGSVGElement {
  const { width } = wishes;
  const [xs, ys] = [points.map((point) => point.x), points.map((point) => point.y)];
  const byVerdict = view.metric === "cut_through";
  const bands = byVerdict ? undefined : bandsOf(quantities.get(view.metric), points.map((point) => point.value).filter(Number.isFinite));
  const height = Math.round(Math.min(520, Math.max(300, 0.62 * width)));
  const yWishes = { margin: 0.07, ticksAt: ys };
  const left = leftOf(scaleOf(quantities.get(view.y), ys, 0, 1, yWishes));
  const box: Box = { left, top: 8, width: width - left - (bands ? ladderWidth : 12), height };
  const x = scaleOf(quantities.get(view.x), xs, left, left + box.width, { margin: 0.07, ticksAt: xs });
  const y = scaleOf(quantities.get(view.y), ys, box.top + height, box.top, yWishes);
  const ground = groundOf(box, x, y, points);

  const defs = svg("defs", {}, hatch("kerf-bracket", "#ffffff90", 8, 2));
  const plot = svg("g", {}, svg("rect", { x: box.left, y: box.top, width: box.width, height, fill: "#f5f6f8" }));
  if (bands && view.style === "cells") drawCells(plot, ground, points, bands);
  else if (bands) drawBands(plot, ground, points, bands);
  const hasBoundary = drawVerdicts(plot, ground, points, byVerdict);
  plot.append(drawAxes(box, x, y, false), drawFrame(box));
  const best = bestPlace(wishes.best, view);
  if (best) plot.append(svg("g", { transform: `translate(${x.place(best[0])} ${y.place(best[1])})` }, bestRing(12)));
  for (const point of points) plot.append(drawMark({ ...point, x: x.place(point.x), y: y.place(point.y) }, view.metric, quantities, tooltip));
  if (bands) plot.append(drawLadder(bands, box.left + box.width + 14, box.top, height));
  const key = drawKey(keyEntries(points, byVerdict, hasBoundary, best !== undefined), left, box.top + height + 62, width - left);
  const whole = box.top + height + 62 + key.height;
  return svg("svg", { viewBox: `0 0 ${width} ${whole}`, width, height: whole, role: "group", id: "kerf-map-picture" }, defs, plot, key.root);
}
