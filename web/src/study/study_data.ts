// SPDX-License-Identifier: Apache-2.0
// What the page holds: study.json as docs/studies.md has it, and what the program adds for the page.

import { list, object, refuse } from "../run.ts";

export type Value = number | string;
export type Setting = Record<string, Value>;

export interface Key {
  key: string;
  unit: string;
  shown_unit: string;
  shown_factor: number;
  kind: "list" | "range" | "words";
  scale: "linear" | "log";
  values: Value[];
}

export interface StudyRun {
  id: string;
  state: "waiting" | "running" | "done" | "failed";
  setting: Setting;
  repeat: number;
  refinement: number;
  spacing: number;
  attempts: number;
  error: string;
  report: string | null;
  metrics: Record<string, number | null>;
}

export interface Bracket {
  low: number;
  high: number;
}

export interface Search {
  find: "least" | "greatest" | "minimum" | "maximum";
  condition: string;
  problem: string;
  value: number | null;
  low: number | null;
  high: number | null;
  runs: number;
  draft_runs: number;
  unit: string;
  // of least and greatest
  key?: string;
  bracket?: Bracket;
  layouts?: Bracket[];
  draft?: Bracket | null;
  extrapolated?: number | null;
  tolerance?: number;
  within_tolerance?: boolean;
  // of minimum and maximum
  metric?: string;
  setting?: Setting;
  draft_value?: number | null;
  local?: boolean;
  ranges?: Record<string, Bracket>;
  neighbours?: Record<string, Bracket>;
  others?: { setting: Setting; value: number; refinement: number }[];
}

export interface Calibration {
  key: string;
  at: Setting;
  metric: string;
  measured: number;
  uncertainty: number;
  problem: string;
  value: number | null;
  low: number | null;
  high: number | null;
  open_below?: boolean;
  open_above?: boolean;
  jump?: { low: number; high: number; at_low: number; at_high: number } | null;
  runs: number;
  predictions: { setting: Setting; value: number; low: number; high: number }[];
}

export interface Model {
  form: string;
  formula: string;
  metric: string;
  drive: string;
  variables: string[];
  problem: string;
  used_runs: number;
  explained?: number;
  parameters?: { name: string; value: number; low: number; high: number }[];
  valid?: Record<string, Bracket>;
}

export interface Study {
  format: number;
  title: string;
  refinement: number;
  repeats: number;
  keys: Key[];
  metrics: { name: string; unit: string }[];
  runs: StudyRun[];
  search?: Search;
  calibration?: Calibration;
  model?: Model;
}

/** What the reduced model says of one place, with the interval in which 95% of runs are expected. */
export interface ModelPoint {
  along: string; // the variable that its curve goes along
  at: Record<string, number>;
  value: number;
  low: number;
  high: number;
}

export interface StudyData {
  study: Study;
  state: "running" | "stopped" | "ended";
  written: string; // UTC
  units: Record<string, string>; // of metrics and of the spacing, SI
  labels: Record<string, string>; // of keys and metrics
  help: Record<string, string>; // what the keys mean, a sentence each
  model_points: ModelPoint[];
}

export function readStudyData(text: string): StudyData {
  const data = object(JSON.parse(text), "the data");
  const study = object(data.study, "study");
  if (study.format !== 1) refuse("study.format", "1");
  for (const name of ["keys", "metrics", "runs"]) list(study[name], `study.${name}`);
  object(data.units, "units");
  object(data.labels, "labels");
  object(data.help, "help");
  list(data.model_points, "model_points");
  for (const run of study.runs as unknown[]) {
    const { setting, metrics } = object(run, "a run");
    object(setting, "the setting of a run");
    object(metrics, "the metrics of a run");
  }
  return data as unknown as StudyData;
}

/** Of a key, of a metric or the "spacing", SI. */
export function numberOf(run: StudyRun, name: string): number | undefined {
  const value = name === "spacing" ? run.spacing : (run.setting[name] ?? run.metrics[name]);
  return typeof value === "number" && Number.isFinite(value) ? value : undefined;
}
