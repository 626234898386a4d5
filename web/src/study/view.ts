// SPDX-License-Identifier: Apache-2.0
// What the reader has chosen to see. It is kept in the address, so that a link shows the same.

import { numberOf, type Key, type StudyData, type StudyRun, type Value } from "./study_data.ts";
import { verdictOfAll, type Verdict } from "./verdict.ts";

export const all = "all";

export interface View {
  metric: string;
  x: string;
  y: string; // "" = there is one numeric key only
  style: string; // of a map: "contours", or "cells" that end half way between runs
  refinement: string; // or all
  repeat: string; // or all
  fixed: Record<string, string>; // other keys: a value, or all
}

/** Runs at one place of a map or a curve. */
export interface Point {
  x: number;
  y: number;
  runs: StudyRun[];
  value: number; // mean of the metric, NaN = none
  verdict: Verdict;
}

export function numericKeys(data: StudyData): Key[] {
  return data.study.keys.filter((key) => key.kind !== "words" && valuesOf(data, key.key).length > 1);
}

/** That occur in runs. */
export function valuesOf(data: StudyData, key: string): Value[] {
  const values = [...new Set(data.study.runs.map((run) => run.setting[key]).filter((value) => value !== undefined))];
  return values.sort((a, b) => (typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b))));
}

export function distinctOf(data: StudyData, name: "refinement" | "repeat"): number[] {
  return [...new Set(data.study.runs.map((run) => run[name]))].sort((a, b) => a - b);
}

/** Those that at least one run has, the columns of the table first; flags are told by the verdict. */
export function metricsOf(data: StudyData): string[] {
  const inRuns = new Set(data.study.runs.flatMap((run) => Object.keys(run.metrics)));
  const first = data.study.metrics.map((metric) => metric.name);
  return [...new Set([...first, ...[...inRuns].sort()])].filter((name) => name !== "cut_through" && !name.startsWith("validity."));
}

function varies(data: StudyData, metric: string): boolean {
  const values = data.study.runs.map((run) => numberOf(run, metric)).filter((value) => value !== undefined);
  return values.length > 1 && Math.max(...values) > Math.min(...values);
}

function firstMetric(data: StudyData): string {
  const { search, calibration, model } = data.study;
  // The margin changes its sign where a cut begins.
  const wanted = [search?.metric, search?.key === undefined ? undefined : "kerf.margin", calibration?.metric, model?.metric, "kerf.depth", "front_depth", "kerf.middle.width"];
  const known = metricsOf(data);
  return wanted.find((name) => name !== undefined && known.includes(name) && varies(data, name)) ?? "kerf.depth";
}

function firstView(data: StudyData): View {
  const { study } = data;
  const keys = numericKeys(data).map((key) => key.key);
  const leading = [study.model?.drive, study.calibration?.key, study.search?.key, ...keys].filter((key) => key !== undefined);
  const x = leading.find((key) => keys.includes(key)) ?? leading[0] ?? study.keys[0]?.key ?? "";
  const y = keys.find((key) => key !== x) ?? "";
  const hasFine = study.runs.some((run) => run.refinement === study.refinement);
  const fixed: Record<string, string> = {};
  for (const { key } of study.keys) {
    const values = valuesOf(data, key);
    // A projection of many values tells more than one of them, a slice more than a projection of few.
    fixed[key] = values.length > 1 && values.length <= 9 ? String(values[0]) : all;
  }
  return { metric: firstMetric(data), x, y, style: "contours", refinement: y !== "" && hasFine ? String(study.refinement) : all, repeat: all, fixed };
}

export function viewFromAddress(data: StudyData): View {
  const view = firstView(data);
  const asked = new URLSearchParams(location.hash.slice(1));
  const names = new Set([...data.study.keys.map((key) => key.key), ...metricsOf(data), "cut_through", ""]);
  const take = (name: "metric" | "x" | "y") => {
    const value = asked.get(name);
    if (value !== null && names.has(value)) view[name] = value;
  };
  take("metric");
  take("x");
  take("y");
  if (asked.get("style") === "cells") view.style = "cells";
  for (const name of ["refinement", "repeat"] as const) view[name] = asked.get(name) ?? view[name];
  for (const key of Object.keys(view.fixed)) view.fixed[key] = asked.get(`at.${key}`) ?? view.fixed[key];
  return view;
}

export function rememberView(view: View) {
  const { fixed, ...plain } = view;
  const words = new URLSearchParams(plain);
  for (const [key, value] of Object.entries(fixed)) words.set(`at.${key}`, value);
  history.replaceState(null, "", `#${words}`);
}

export function chosenRuns(data: StudyData, view: View): StudyRun[] {
  const agrees = (chosen: string, value: Value | undefined) => chosen === all || value === undefined || chosen === String(value);
  const others = Object.entries(view.fixed).filter(([key]) => key !== view.x && key !== view.y);
  return data.study.runs.filter(
    (run) =>
      agrees(view.refinement, run.refinement) &&
      agrees(view.repeat, run.repeat) &&
      others.every(([key, value]) => agrees(value, run.setting[key])),
  );
}

export function pointsOf(runs: StudyRun[], view: View): Point[] {
  const places = new Map<string, StudyRun[]>();
  for (const run of runs) {
    const [x, y] = [numberOf(run, view.x), numberOf(run, view.y)];
    if (x === undefined || y === undefined) continue;
    const place = `${x} ${y}`;
    places.set(place, [...(places.get(place) ?? []), run]);
  }
  return [...places.values()].map((here) => ({
    x: numberOf(here[0], view.x)!,
    y: numberOf(here[0], view.y)!,
    runs: here,
    value: meanOf(here, view.metric),
    verdict: verdictOfAll(here),
  }));
}

export function meanOf(runs: StudyRun[], metric: string): number {
  const values = runs.map((run) => numberOf(run, metric)).filter((value) => value !== undefined);
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}
