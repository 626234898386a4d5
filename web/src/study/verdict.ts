// SPDX-License-Identifier: Apache-2.0
// What became of a run, and the symbol that says so: its shape and its lightness tell it, not its colour.

import type { StudyRun } from "./study_data.ts";
import { svg } from "./svg.ts";

export type Verdict = "cut" | "may_cut" | "not_cut" | "not_reached" | "mixed" | "done" | "failed" | "running" | "waiting";

export const verdictWords: Record<Verdict, string> = {
  cut: "cut through",
  may_cut: "may cut",
  not_cut: "not cut through",
  not_reached: "not reached by the water",
  mixed: "through in some layouts",
  done: "done",
  failed: "failed",
  running: "at work",
  waiting: "not run yet",
};

export const verdictOrder = Object.keys(verdictWords) as Verdict[];

/** Under a nozzle that stands in place of one that moves it is that of the feed. */
export function verdictOf(run: StudyRun): Verdict {
  if (run.state !== "done") return run.state;
  if ((run.metrics["validity.not_reached"] ?? 0) > 0.5) return "not_reached";
  const through = run.metrics["exposure.cuts"] ?? run.metrics.cut_through;
  if (through === null || through === undefined) return "done";
  if (through > 0.5) return "cut";
  return (run.metrics["exposure.may_cut"] ?? 0) > 0.5 ? "may_cut" : "not_cut";
}

/** Of runs that differ in their layout, or that a projection puts in one place. */
export function verdictOfAll(runs: StudyRun[]): Verdict {
  const all = runs.map(verdictOf);
  const some = (verdict: Verdict) => all.includes(verdict);
  if (some("cut") && some("not_cut")) return "mixed";
  return verdictOrder.find(some) ?? "waiting";
}

/** Around 0, 0; `colour` is that of its series. */
export function symbol(verdict: Verdict, size = 6, colour = "#22272e"): SVGGElement {
  const ring = { r: size, stroke: colour, "stroke-width": 2, fill: "#fff" };
  const halo = svg("circle", { r: size + 2, fill: "#fff" });
  switch (verdict) {
    case "cut":
    case "done":
      return svg("g", {}, halo, svg("circle", { ...ring, fill: colour }));
    case "may_cut":
      return svg("g", {}, halo, svg("circle", ring), svg("circle", { r: size / 3, fill: colour }));
    case "not_cut":
      return svg("g", {}, halo, svg("circle", ring));
    case "mixed":
      return svg("g", {}, halo, svg("circle", ring), svg("path", { d: `M0,${-size}A${size},${size} 0 0 0 0,${size}Z`, fill: colour }));
    case "failed":
      return svg("g", {}, failedSymbol(size, "#fff", 5), failedSymbol(size, "#9a3412", 2.4));
    case "running":
      return svg("g", {}, halo, svg("circle", { ...ring, "stroke-width": 1.5, "stroke-dasharray": "2.5 2" }), svg("circle", { r: 2, fill: colour }));
    case "not_reached":
    case "waiting":
      return svg("g", {}, halo, svg("circle", { ...ring, "stroke-width": 1.5, "stroke-dasharray": "2.5 2" }));
  }
}

function failedSymbol(size: number, colour: string, width: number) {
  const d = `M${-size},${-size}L${size},${size}M${-size},${size}L${size},${-size}`;
  return svg("path", { d, stroke: colour, "stroke-width": width, "stroke-linecap": "round", fill: "none" });
}

/** The symbol in a line of text. */
export function inlineSymbol(verdict: Verdict): SVGSVGElement {
  const picture = svg("svg", { viewBox: "-9 -9 18 18", width: 16, height: 16, "aria-hidden": "true" }, symbol(verdict));
  picture.classList.add("kerf-symbol");
  return picture;
}
