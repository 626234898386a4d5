// SPDX-License-Identifier: Apache-2.0
// The steps of a metric that a map tells apart, their colours and the legend of them.

import { sample, stops, viridisCodes } from "../colour_maps.ts";
import { formatNumber, roundTicks } from "../quantities.ts";
import { titleOf, type Quantity } from "./quantity.ts";
import { soft, svg, text } from "./svg.ts";

export interface Bands {
  quantity: Quantity;
  edges: number[]; // between bands, SI
  colours: string[]; // one more than edges
  colourOf: (value: number) => string;
}

const map = stops(viridisCodes);
const written = (share: number) => `rgb(${sample(map, share).join(",")})`;

export function bandsOf(quantity: Quantity, values: number[]): Bands | undefined {
  if (values.length === 0) return undefined;
  const { factor } = quantity;
  const [low, high] = [Math.min(...values) / factor, Math.max(...values) / factor];
  const isFlat = !(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)));
  const inner = isFlat ? [] : roundTicks(low, high, 8).filter((tick) => tick > low && tick < high);
  const edges = inner.map((tick) => tick * factor);
  const colours = Array.from({ length: edges.length + 1 }, (_, at) => written(edges.length === 0 ? 0.5 : at / edges.length));
  const colourOf = (value: number) => colours[edges.filter((edge) => value >= edge).length];
  return { quantity, edges, colours, colourOf };
}

/** A ladder of colours, its edges labelled. */
export function drawLadder(bands: Bands, left: number, top: number, height: number): SVGGElement {
  const root = svg("g", {});
  const { colours, edges, quantity } = bands;
  const step = height / colours.length;
  const width = 18;
  colours.forEach((fill, at) => {
    root.append(svg("rect", { x: left, y: top + height - (at + 1) * step, width, height: step + 0.5, fill }));
  });
  root.append(svg("rect", { x: left, y: top, width, height, fill: "none", stroke: soft }));
  edges.forEach((edge, at) => {
    const y = top + height - (at + 1) * step;
    root.append(svg("line", { x1: left + width, x2: left + width + 4, y1: y, y2: y, stroke: soft }));
    root.append(text(left + width + 8, y + 4.5, formatNumber(edge / quantity.factor)));
  });
  const x = left + width + 60;
  const turned = { "text-anchor": "middle", "font-weight": 600, transform: `translate(${x} ${top + 0.5 * height}) rotate(-90)` };
  root.append(text(0, 0, titleOf(quantity), turned));
  return root;
}

export const ladderWidth = 96;
