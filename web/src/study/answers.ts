// SPDX-License-Identifier: Apache-2.0
// What the study found, in words.

import { element } from "../dom.ts";
import { formatNumber } from "../quantities.ts";
import type { Quantities } from "./quantity.ts";
import type { Bracket, Calibration, Model, Search, StudyData } from "./study_data.ts";

type Line = string | Node;

function box(kind: "yes" | "no" | "none", sentence: Line[], remarks: string[]): HTMLElement {
  const sign = kind === "yes" ? [element("b", {}, "✓")] : [];
  const root = element("div", { className: `kerf-answer verdict ${kind}` }, element("p", {}, ...sign, ...sentence));
  if (remarks.length > 0) root.append(element("ul", {}, ...remarks.map((remark) => element("li", {}, remark))));
  return root;
}

const strong = (words: string) => element("strong", {}, words);
const capital = (words: string) => words.charAt(0).toUpperCase() + words.slice(1);

function runWords(runs: number, drafts: number): string {
  return `${runs} run${runs === 1 ? "" : "s"}${drafts > 0 ? `, ${drafts} of them drafts` : ""}.`;
}

function thresholdAnswer(search: Search, quantities: Quantities): HTMLElement {
  const key = search.key!;
  const what = `${capital(search.find)} ${quantities.get(key).label} with ${search.condition}`;
  if (search.problem !== "" || search.value === null) return box("no", [`${what}: not found. ${search.problem}.`], []);
  const remarks: string[] = [];
  const { bracket, layouts = [], draft } = search;
  if (bracket) {
    const verdicts = search.find === "least" ? "not up to the first, always from the second on" : "always up to the first, not from the second on";
    const where = layouts.length > 1 ? `in all ${layouts.length} layouts` : "in one layout";
    remarks.push(`Observed between ${quantities.showRange(key, bracket.low, bracket.high, "and")} ${where}: ${verdicts}.`);
  }
  if (draft) remarks.push(`Drafts: between ${quantities.showRange(key, draft.low, draft.high, "and")}; both resolutions together make ${quantities.show(key, search.extrapolated)} for a spacing of zero.`);
  if (search.within_tolerance === false) remarks.push(`The bracket is wider than the tolerance of ±${formatNumber(100 * (search.tolerance ?? 0))}%.`);
  remarks.push(runWords(search.runs, search.draft_runs));
  const sentence = [`${what}: `, strong(quantities.show(key, search.value)), `, between ${quantities.showRange(key, search.low!, search.high!, "and")}.`];
  return box("yes", sentence, remarks);
}

// Where the optimum lies, what was searched, and the other optima that the runs show.
function surroundings(search: Search, quantities: Quantities): string[] {
  const shown = (brackets: Record<string, Bracket>) => Object.entries(brackets).map(([key, { low, high }]) => `${quantities.get(key).label} ${quantities.showRange(key, low, high)}`).join(", ");
  const remarks: string[] = [];
  const { neighbours = {}, ranges = {}, others = [] } = search;
  const better = search.find === "minimum" ? "lower" : "higher";
  if (Object.keys(neighbours).length > 0) remarks.push(`Between the neighbouring runs: ${shown(neighbours)}.`);
  if (Object.keys(ranges).length > 0) remarks.push(`Searched: ${shown(ranges)}. A ${better} value between the runs is not excluded.`);
  for (const other of others) remarks.push(`Another local ${search.find}: ${quantities.show(search.metric!, other.value)} at ${quantities.showSetting(other.setting)}.`);
  return remarks;
}

function optimumAnswer(search: Search, quantities: Quantities): HTMLElement {
  const metric = search.metric!;
  const others = search.others ?? [];
  const extreme = search.find === "minimum" ? "minimum" : "maximum";
  const kind = others.length > 0 ? `Local ${extreme} of the` : search.find === "minimum" ? "Least" : "Greatest";
  const what = `${kind} ${quantities.get(metric).label} with ${search.condition}`;
  const remarks = [...surroundings(search, quantities), runWords(search.runs, search.draft_runs)];
  const extrapolated = search.extrapolated ?? null;
  if (extrapolated !== null) remarks.unshift(`The same setting as a draft: ${quantities.show(metric, search.draft_value)}; both resolutions together make ${quantities.show(metric, extrapolated)} for a spacing of zero.`);
  else if (search.problem === "" && search.draft_runs > 0) remarks.unshift(`As a draft the same setting is not one with ${search.condition}.`);
  if (search.low !== null && search.high !== null && search.low !== search.high) {
    const causes = extrapolated === null ? "the neighbouring runs and the layouts" : "the neighbouring runs, the layouts and the change to a spacing of zero";
    remarks.unshift(`Over ${causes}: ${quantities.showRange(metric, search.low, search.high)}.`);
  }
  if (search.problem !== "") remarks.unshift(`But ${search.problem}.`);
  const setting = search.setting ?? {};
  if (Object.keys(setting).length === 0) return box("no", [`${what}: not found.`], remarks);
  const sentence = [`${what}: `, strong(quantities.show(metric, search.value)), " at ", strong(quantities.showSetting(setting)), "."];
  return box(search.problem === "" ? "yes" : "none", sentence, remarks);
}

// The value with its interval or, where the measurement leaves an end of the range open, what it does determine.
function calibratedWords(calibration: Calibration, value: number, low: number, high: number, quantities: Quantities) {
  const { key, open_below, open_above } = calibration;
  const agrees = "of the range, agrees with the measurement, too.";
  const [from, to] = [quantities.show(key, low), quantities.show(key, high)];
  if (open_below && open_above) return [`not determined: runs at both ends of the range, ${from} and ${to}, agree with the measurement.`];
  if (open_above) return [strong(`at least ${from}`), `, determined only from below: ${to}, the end ${agrees}`];
  if (open_below) return [strong(`at most ${to}`), `, determined only from above: ${from}, the start ${agrees}`];
  return [strong(quantities.show(key, value)), `, between ${quantities.showRange(key, low, high, "and")}.`];
}

function calibrationAnswer(calibration: Calibration, quantities: Quantities): HTMLElement {
  const { key, metric, value, low, high, problem } = calibration;
  const at = Object.keys(calibration.at).length > 0 ? ` at ${quantities.showSetting(calibration.at)}` : "";
  if (problem !== "" || value === null) return box("no", [`${capital(quantities.get(key).label)}: not calibrated. ${problem}.`], []);
  const { label } = quantities.get(metric);
  const measured = metric === "cut_through" ? `Cutting just begins${at}.` : `Measured: ${label} ${quantities.show(metric, calibration.measured)} ± ${quantities.show(metric, calibration.uncertainty)}${at}.`;
  const predictions = calibration.predictions.map(
    (cut) => `Predicted at ${quantities.showSetting(cut.setting)}: ${label} ${quantities.show(metric, cut.value)}, between ${quantities.showRange(metric, cut.low, cut.high, "and")}.`,
  );
  const { jump } = calibration;
  const jumps = jump ? [`Jumps from ${quantities.show(metric, jump.at_low)} at ${quantities.show(key, jump.low)} to ${quantities.show(metric, jump.at_high)} at ${quantities.show(key, jump.high)} across the measured value: no value gives it.`] : [];
  const sentence = [`${capital(quantities.get(key).label)}: `, ...calibratedWords(calibration, value, low!, high!, quantities)];
  const open = calibration.open_below || calibration.open_above ? [`The metric is as measured at ${quantities.show(key, value)}; predictions cover only the range that was searched.`] : [];
  return box("yes", sentence, [measured, ...open, ...jumps, ...predictions, runWords(calibration.runs, 0)]);
}

// A parameter has the unit of its name, where it has one.
function parameterWords(model: Model, name: string, value: number, low: number, high: number, quantities: Quantities): string {
  if (name === "threshold") return `threshold ${quantities.show(model.drive, value)} (${quantities.showRange(model.drive, low, high)})`;
  return `${name} ${formatNumber(value)} (${formatNumber(low)} to ${formatNumber(high)}, SI)`;
}

function modelAnswer(model: Model, quantities: Quantities): HTMLElement {
  const what = `Reduced model of the ${quantities.get(model.metric).label}`;
  if (model.problem !== "") return box("none", [`${what}: none. ${model.problem}.`], []);
  const parameters = (model.parameters ?? []).map((one) => parameterWords(model, one.name, one.value, one.low, one.high, quantities));
  const valid = Object.entries(model.valid ?? {}).map(([name, range]) => `${quantities.get(name).label} ${quantities.showRange(name, range.low, range.high)}`);
  return box("yes", [`${what}: `, element("code", {}, model.formula), "."], [
    `With ${parameters.join("; ")}. In brackets the intervals that cover them with 95%.`,
    `${model.used_runs} runs, R² = ${formatNumber(model.explained ?? NaN, 4)}. Valid for ${valid.join(", ")}.`,
  ]);
}

export function answersOf({ study }: StudyData, quantities: Quantities): HTMLElement[] {
  const { search, calibration, model } = study;
  const boxes: HTMLElement[] = [];
  if (search) boxes.push(search.key !== undefined ? thresholdAnswer(search, quantities) : optimumAnswer(search, quantities));
  if (calibration) boxes.push(calibrationAnswer(calibration, quantities));
  if (model) boxes.push(modelAnswer(model, quantities));
  return boxes;
}
