// SPDX-License-Identifier: Apache-2.0
// The curves of a run, and the checks they go through.

import { list, number, object, refuse, text } from "./run.ts";

export interface Series {
  key: string;
  label: string;
  values: (number | null)[]; // null: nothing known at that time
}

export interface Group {
  label: string;
  unit: string;
  series: Series[];
}

export interface Mark {
  time: number; // s
  label: string;
}

export interface CurveData {
  time: number[]; // s, growing
  groups: Group[];
  marks: Mark[];
}

function readSeries(value: unknown, place: string, length: number): Series {
  const part = object(value, place);
  const label = text(part.label, `${place}.label`);
  const values = list(part.values, `${place}.values`);
  if (values.length !== length) refuse(`${place}.values (${label})`, `${length} values, as many as times`);
  values.forEach((one, at) => one === null || number(one, `${place}.values[${at}]`));
  return { key: text(part.key, `${place}.key`), label, values: values as (number | null)[] };
}

function readGroup(value: unknown, place: string, length: number): Group {
  const part = object(value, place);
  return {
    label: text(part.label, `${place}.label`),
    unit: text(part.unit, `${place}.unit`),
    series: list(part.series, `${place}.series`).map((one, at) =>
      readSeries(one, `${place}.series[${at}]`, length),
    ),
  };
}

/** Throws RunError, which says what is wrong where. */
export function readCurves(value: unknown): CurveData {
  const json = object(value, "curves");
  const time = list(json.time, "curves.time").map((one, at) => number(one, `curves.time[${at}]`));
  const back = time.findIndex((one, at) => at > 0 && one < time[at - 1]);
  if (back >= 0) refuse(`curves.time[${back}]`, "no less than the time before");
  return {
    time,
    groups: list(json.groups, "curves.groups").map((one, at) =>
      readGroup(one, `curves.groups[${at}]`, time.length),
    ),
    marks: list(json.marks ?? [], "curves.marks").map((one, at) => {
      const mark = object(one, `curves.marks[${at}]`);
      return {
        time: number(mark.time, `curves.marks[${at}].time`),
        label: text(mark.label, `curves.marks[${at}].label`),
      };
    }),
  };
}
