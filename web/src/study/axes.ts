// SPDX-License-Identifier: Apache-2.0
// Scales in the units that are shown, and the frame of a plot.

import { formatNumber, roundTicks } from "../quantities.ts";
import { titleOf, type Quantity } from "./quantity.ts";
import { faint, ink, soft, svg, text, widthOf } from "./svg.ts";

export interface Scale {
  quantity: Quantity;
  low: number; // SI
  high: number;
  place: (value: number) => number; // px of a number in SI
  ticks: number[]; // SI
}

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

export interface ScaleWishes {
  margin: number; // share of the length that is left free at either end
  ticksAt?: number[]; // the values themselves, if they are few enough
  fromZero?: boolean;
}

const distinct = (values: number[]) => [...new Set(values)].sort((a, b) => a - b);

function logarithmicTicks(low: number, high: number): number[] {
  const ticks: number[] = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
    for (const lead of [1, 2, 5]) ticks.push(lead * 10 ** power);
  return ticks.filter((tick) => tick >= low * 0.999 && tick <= high * 1.001);
}

function ticksOf(low: number, high: number, quantity: Quantity, wishes: ScaleWishes): number[] {
  const given = distinct(wishes.ticksAt ?? []);
  if (given.length > 0 && given.length <= 9) return given;
  const { factor } = quantity;
  const shown = quantity.isLogarithmic ? logarithmicTicks(low / factor, high / factor) : roundTicks(low / factor, high / factor, 6);
  return shown.map((tick) => tick * factor).filter((tick) => tick >= low && tick <= high);
}

export function scaleOf(quantity: Quantity, values: number[], from: number, to: number, wishes: ScaleWishes): Scale {
  const finite = values.filter(Number.isFinite);
  const isLogarithmic = quantity.isLogarithmic && finite.every((value) => value > 0);
  const forth = isLogarithmic ? Math.log : (value: number) => value;
  const back = isLogarithmic ? Math.exp : (value: number) => value;
  let [low, high] = finite.length > 0 ? [Math.min(...finite), Math.max(...finite)] : [0, 1];
  if (wishes.fromZero && !isLogarithmic) [low, high] = [Math.min(0, low), Math.max(0, high)];
  let [first, last] = [forth(low), forth(high)];
  if (first === last) [first, last] = [first - 0.5 * (Math.abs(first) || 1), last + 0.5 * (Math.abs(last) || 1)];
  const free = wishes.margin * (last - first);
  if (!(wishes.fromZero && low === 0)) first -= free;
  last += free;
  const place = (value: number) => from + ((forth(value) - first) / (last - first)) * (to - from);
  const ends = { low: back(first), high: back(last) };
  return { quantity, ...ends, place, ticks: ticksOf(ends.low, ends.high, quantity, wishes) };
}

export function tickWords({ quantity }: Scale, tick: number): string {
  if (quantity.name === "cut_through") return tick > 0.5 ? "yes" : "no";
  return formatNumber(tick / quantity.factor);
}

/** Words of ticks that do not run into each other are kept. */
function apart(scale: Scale, room: (words: string) => number): { at: number; words: string }[] {
  let free = -Infinity;
  const entries = scale.ticks.map((tick) => ({ at: scale.place(tick), words: tickWords(scale, tick) }));
  entries.sort((a, b) => a.at - b.at);
  return entries.filter(({ at, words }) => {
    const half = 0.5 * room(words);
    if (at - half < free) return false;
    free = at + half;
    return true;
  });
}

/** Room for the words at the left. */
export function leftOf(scale: Scale): number {
  const widths = scale.ticks.map((tick) => widthOf(tickWords(scale, tick)));
  return 38 + Math.max(20, ...widths);
}

export function drawAxes(box: Box, x: Scale, y: Scale, withGrid: boolean): SVGGElement {
  const root = svg("g", {});
  const { left, top, width, height } = box;
  const bottom = top + height;
  for (const { at, words } of apart(x, (label) => widthOf(label) + 12)) {
    if (withGrid) root.append(svg("line", { x1: at, x2: at, y1: top, y2: bottom, stroke: faint }));
    root.append(svg("line", { x1: at, x2: at, y1: bottom, y2: bottom + 5, stroke: soft }));
    root.append(text(at, bottom + 20, words, { "text-anchor": "middle" }));
  }
  const zero = y.place(0);
  if (withGrid && zero > top && zero < bottom) root.append(svg("line", { x1: left, x2: left + width, y1: zero, y2: zero, stroke: soft }));
  for (const { at, words } of apart(y, () => 18)) {
    if (withGrid) root.append(svg("line", { x1: left, x2: left + width, y1: at, y2: at, stroke: faint }));
    root.append(svg("line", { x1: left - 5, x2: left, y1: at, y2: at, stroke: soft }));
    root.append(text(left - 9, at + 4.5, words, { "text-anchor": "end" }));
  }
  root.append(text(left + 0.5 * width, bottom + 42, titleOf(x.quantity), { "text-anchor": "middle", "font-weight": 600 }));
  const turned = { "text-anchor": "middle", "font-weight": 600, transform: `translate(14 ${top + 0.5 * height}) rotate(-90)` };
  root.append(text(0, 0, titleOf(y.quantity), turned));
  return root;
}

export function drawFrame({ left, top, width, height }: Box): SVGRectElement {
  return svg("rect", { x: left, y: top, width, height, fill: "none", stroke: ink, "stroke-width": 1 });
}
