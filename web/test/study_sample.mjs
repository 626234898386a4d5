// SPDX-License-Identifier: Apache-2.0
// Made-up studies as study.json has them (docs/studies.md), in pages as the simulator writes them:
//   node test/study_sample.mjs [FOLDER]
// Writes a folder for each with study.html and the reports that it links to, and says where.

import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { inline, reportStyle } from "./make_sample.mjs";

const beside = (path) => new URL(path, import.meta.url);
const metrics = [
  { name: "cut_through", unit: "" },
  { name: "kerf.depth", unit: "m" },
  { name: "kerf.middle.width", unit: "m" },
  { name: "kerf.specific_energy", unit: "J/m3" },
];
const settings = {
  "machine.pressure": ["pressure", "Pressure at the orifice, above that of the air."],
  "machine.traverse_speed": ["traverse speed", "Speed of the nozzle over the workpiece."],
  spacing: ["spacing", "Distance of neighbouring particles, d."],
  "materials.gel.fracture_energy": ["fracture energy of gel", "Energy that a unit of area of a crack takes."],
};
const units = { ...Object.fromEntries(metrics.map(({ name, unit }) => [name, unit])), spacing: "m", steps: "" };
const labels = { cut_through: "cut through", "kerf.depth": "depth of the kerf", "kerf.middle.width": "width of the kerf in the middle", "kerf.specific_energy": "specific energy", steps: "steps" };
for (const [name, [label]] of Object.entries(settings)) labels[name] = label;
const help = Object.fromEntries(Object.entries(settings).map(([name, [, words]]) => [name, words]));

const key = (name, unit, shown_unit, shown_factor, values, scale = "linear") => ({ key: name, unit, shown_unit, shown_factor, kind: "range", scale, values });
const pressure = (values) => key("machine.pressure", "Pa", "MPa", 1e6, values);
const traverse = (values) => key("machine.traverse_speed", "m/s", "mm/s", 1e-3, values, "log");

// Depth in a plate of 20 mm: linear in the pressure above 5 MPa, less for a faster traverse.
const depthAt = (p, u) => (2.4e-9 * Math.max(0, p - 5e6)) / (u / 0.01) ** 0.4;

let number = 0;
function run(setting, { state = "done", repeat = 0, refinement = 1 } = {}) {
  const id = (++number).toString(16).padStart(15, "0");
  const p = setting["machine.pressure"];
  const depth = Math.min(0.02, depthAt(p, setting["machine.traverse_speed"] ?? 0.01) * (1 + 0.02 * Math.sin(7 * number)));
  const through = depth >= 0.02 ? 1 : 0;
  const measured = { cut_through: through, "kerf.depth": depth, "kerf.middle.width": 8e-4 + 0.01 * depth, steps: 1000 + number };
  if (depth > 0) measured["kerf.specific_energy"] = 3e9 + (50 * p) / (0.1 + 100 * depth);
  return {
    id,
    state,
    setting,
    repeat,
    refinement,
    spacing: 1e-4 / refinement,
    attempts: state === "waiting" ? 0 : 1,
    started: "",
    ended: "",
    error: state === "failed" ? 'kerf: error: "time.end" is\nout of <range>' : "",
    report: state === "done" ? `runs/${id}/report.html` : null,
    metrics: state === "done" ? measured : {},
  };
}

const data = (study, more = {}) => ({
  state: "ended",
  written: "2026-01-01 00:00:00 UTC",
  units,
  labels,
  help,
  model_points: [],
  study: { format: 1, name: "sample", base: "sample", version: "0", refinement: 1, repeats: 1, metrics, boundary: [], ...study },
  ...more,
});

const steps = (low, high, count) => Array.from({ length: count }, (_, at) => low + ((high - low) * at) / (count - 1));
const logSteps = (low, high, count) => steps(Math.log(low), Math.log(high), count).map(Math.exp);

/** A grid, on its way: one run failed, some are still to come. */
export function gridStudy() {
  const keys = [pressure(steps(5e6, 40e6, 6)), traverse(logSteps(1e-3, 0.1, 5))];
  const settings = keys[0].values.flatMap((p) => keys[1].values.map((u) => ({ "machine.pressure": p, "machine.traverse_speed": u })));
  const states = { 12: "failed", 27: "running", 28: "waiting", 29: "waiting" };
  const runs = settings.map((setting, at) => run(setting, { state: states[at] ?? "done" }));
  return data({ title: "A made-up grid", keys, runs }, { state: "running" });
}

/** Points of a Latin hypercube, two layouts of each, and an optimum. */
export function scatteredStudy() {
  const keys = [pressure([5e6, 40e6]), traverse([1e-3, 0.1])];
  const settings = Array.from({ length: 24 }, (_, at) => ({
    "machine.pressure": 5e6 + 35e6 * ((at * 7 + 3) % 24) / 23,
    "machine.traverse_speed": 1e-3 * 100 ** (((at * 11 + 5) % 24) / 23),
  }));
  const runs = settings.flatMap((setting) => [0, 1].map((repeat) => run(setting, { repeat })));
  const best = runs.filter((one) => one.metrics.cut_through).sort((a, b) => a.metrics["kerf.specific_energy"] - b.metrics["kerf.specific_energy"])[0];
  const value = best.metrics["kerf.specific_energy"];
  const search = { find: "minimum", metric: "kerf.specific_energy", unit: "J/m3", condition: "cut-through", problem: "", setting: best.setting, value, low: value, high: 1.02 * value, draft_value: null, runs: 48, draft_runs: 0 };
  return data({ title: "A made-up hypercube", keys, runs, search, repeats: 2 });
}

/** A search in one key with drafts, and a reduced model. */
export function searchStudy() {
  const place = (p, refinement) => run({ "machine.pressure": p }, { refinement });
  const runs = [...[5e6, 40e6, 22e6, 13e6, 17e6].map((p) => place(p, 0.5)), ...[10e6, 15e6, 12e6, 13.5e6, 14e6].map((p) => place(p, 1))];
  const search = {
    find: "least", key: "machine.pressure", unit: "Pa", condition: "cut-through", problem: "", value: 13.25e6, low: 12.5e6, high: 14e6,
    bracket: { low: 13e6, high: 13.5e6 }, layouts: [{ low: 13e6, high: 13.5e6 }], draft: { low: 13e6, high: 17e6 }, draft_refinement: 0.5,
    resolution_change: -1.75e6, extrapolated: 12.5e6, tolerance: 0.05, within_tolerance: true, runs: 10, draft_runs: 5,
  };
  const model = {
    form: "threshold_linear", formula: "kerf.depth = slope (machine.pressure - threshold)", metric: "kerf.depth", unit: "m", drive: "machine.pressure", variables: [],
    problem: "", used_runs: 5, freedom: 3, residual: 1e-4, explained: 0.998, parameters: [{ name: "slope", value: 2.4e-9, low: 2.2e-9, high: 2.6e-9 }, { name: "threshold", value: 5e6, low: 4.6e6, high: 5.4e6 }],
    valid: { "machine.pressure": { low: 10e6, high: 15e6 } },
  };
  const model_points = steps(10e6, 15e6, 21).map((p) => {
    const value = depthAt(p, 0.01);
    return { along: "machine.pressure", at: { "machine.pressure": p }, value, low: 0.94 * value, high: 1.06 * value };
  });
  return data({ title: "A made-up search", keys: [pressure([5e6, 40e6])], runs, search, model }, { model_points });
}

/** A material's key from one test cut. */
export function calibrationStudy() {
  const name = "materials.gel.fracture_energy";
  const runs = logSteps(1, 100, 6).map((energy) => {
    const made = run({ [name]: energy, "machine.pressure": 10e6 });
    made.metrics["kerf.depth"] = 0.02 - 0.0035 * Math.log(energy);
    made.metrics.cut_through = 0;
    return made;
  });
  const calibration = {
    key: name, unit: "J/m2", at: { "machine.pressure": 10e6 }, metric: "kerf.depth", metric_unit: "m", measured: 0.012, uncertainty: 5e-4, problem: "",
    value: 9.83, low: 7.4, high: 13.1, sensitivity: -0.0035, scatter: 1e-5, runs: 6,
    predictions: [{ setting: { "machine.pressure": 20e6 }, value: 0.016, low: 0.015, high: 0.017 }],
  };
  return data({ title: "A made-up calibration", keys: [key(name, "J/m2", "J/m2", 1, [1, 100], "log"), pressure([10e6])], runs, calibration });
}

export const studies = { grid: gridStudy, scattered: scatteredStudy, search: searchStudy, calibration: calibrationStudy };

export function studyPage(content, json = inline(content)) {
  const bundle = readFileSync(beside("../dist/study.js"), "utf8");
  const style = readFileSync(beside("../dist/study.css"), "utf8");
  const { title } = content.study;
  return `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${title}</title><style>${reportStyle()}${style}</style></head>
<body><main><header><h1>${title}</h1><p class="meta">A made-up study</p></header>
<section id="kerf-study"><p>static part</p></section>
<script type="application/json" id="kerf-study-data">${json}</script>
<script>${bundle}</script></main></body></html>
`;
}

/** The folder of a study as the simulator leaves it, with reports that say nothing. */
export function writeStudy(folder, content, json) {
  for (const { id, report } of content.study.runs) {
    if (!report) continue;
    mkdirSync(join(folder, "runs", id), { recursive: true });
    writeFileSync(join(folder, report), `<!DOCTYPE html><title>${id}</title>`);
  }
  mkdirSync(folder, { recursive: true });
  const path = join(folder, "study.html");
  writeFileSync(path, studyPage(content, json));
  return path;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const folder = process.argv[2] ?? mkdtempSync(join(tmpdir(), "kerf-studies-"));
  for (const [name, make] of Object.entries(studies)) console.log(writeStudy(join(folder, name), make()));
}
