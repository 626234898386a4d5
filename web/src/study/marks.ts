// SPDX-License-Identifier: Apache-2.0
// The symbols of runs in a map or a curve, each a link to its report, and the key to them.

import type { Quantities } from "./quantity.ts";
import type { StudyRun } from "./study_data.ts";
import { ink, svg, text, widthOf } from "./svg.ts";
import { describe, type Tooltip } from "./tooltip.ts";
import { symbol, verdictOrder, verdictWords, type Verdict } from "./verdict.ts";

export interface Mark {
  x: number; // px
  y: number;
  runs: StudyRun[];
  verdict: Verdict;
  colour?: string;
  size?: number;
}

export function drawMark(mark: Mark, metric: string, quantities: Quantities, tooltip: Tooltip): SVGElement {
  const { x, y, runs, verdict, colour, size } = mark;
  const report = runs.find((run) => run.report)?.report;
  const shape = symbol(verdict, size ?? 6, colour ?? ink);
  const target = svg("circle", { r: 13, fill: "transparent" });
  const root = svg(report ? "a" : "g", { transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`, tabindex: 0, class: "kerf-mark" }, target, shape);
  if (report) root.setAttribute("href", report);
  else root.setAttribute("role", "img");
  root.setAttribute("aria-label", describe(runs, metric, quantities));
  root.dataset.runs = runs.map((run) => run.id).join(" ");
  root.dataset.verdict = verdict;
  tooltip.attach(root, runs, metric);
  return root;
}

export interface KeyEntry {
  words: string;
  symbol: SVGElement; // around 0, 0 and 16 px wide
}

export function verdictEntries(verdicts: Verdict[]): KeyEntry[] {
  const present = verdictOrder.filter((verdict) => verdicts.includes(verdict));
  return present.map((verdict) => ({ words: verdictWords[verdict], symbol: symbol(verdict) }));
}

/** In lines as long as there is room; the height is told. */
export function drawKey(entries: KeyEntry[], left: number, top: number, width: number): { root: SVGGElement; height: number } {
  const root = svg("g", {});
  const line = 24;
  let [x, y] = [left, top + 12];
  for (const entry of entries) {
    const long = 22 + widthOf(entry.words) + 22;
    if (x > left && x + long > left + width) [x, y] = [left, y + line];
    root.append(svg("g", { transform: `translate(${x + 8} ${y})` }, entry.symbol), text(x + 22, y + 4.5, entry.words));
    x += long;
  }
  return { root, height: entries.length > 0 ? y - top + 20 : 0 };
}
