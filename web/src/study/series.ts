// SPDX-License-Identifier: Apache-2.0
// The runs of a curve, parted by the other key and by their resolution.

import type { Quantities } from "./quantity.ts";
import { numberOf, type ModelPoint, type StudyData, type StudyRun } from "./study_data.ts";
import { all, type View } from "./view.ts";

// Okabe and Ito, 2008.
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#7a6a00", "#56b4e9", "#e69f00", "#444b54"];
const dashes = ["", "6 3", "2 3", "9 3 2 3"];

export interface Series {
  label: string; // "" = all there is
  other: number | undefined; // value of the other key, SI
  isDraft: boolean;
  runs: StudyRun[];
  colour: string;
  dash: string;
}

function otherLabel(view: View, other: number | undefined, quantities: Quantities): string {
  return other === undefined ? "" : `${quantities.get(view.y).label} ${quantities.show(view.y, other)}`;
}

export function seriesOf(data: StudyData, runs: StudyRun[], view: View, quantities: Quantities): Series[] {
  const others = [...new Set(runs.map((run) => (view.y === "" ? undefined : numberOf(run, view.y))))];
  const isParted = view.y !== "" && others.length <= colours.length;
  const groups = new Map<string, StudyRun[]>();
  for (const run of runs) {
    const name = `${isParted ? numberOf(run, view.y) : ""} ${run.refinement}`;
    groups.set(name, [...(groups.get(name) ?? []), run]);
  }
  const list = [...groups.values()].map((group) => ({ group, other: isParted ? numberOf(group[0], view.y) : undefined, refinement: group[0].refinement }));
  list.sort((a, b) => (a.other ?? 0) - (b.other ?? 0) || b.refinement - a.refinement);
  const levels = [...new Set(list.map((one) => one.other))];
  const hasDrafts = view.refinement === all && new Set(runs.map((run) => run.refinement)).size > 1;
  return list.map(({ group, other, refinement }) => {
    const isDraft = refinement !== data.study.refinement;
    const spacing = hasDrafts ? `${isDraft ? "draft, " : ""}spacing ${quantities.show("spacing", group[0].spacing)}` : "";
    const at = levels.indexOf(other);
    return {
      label: [otherLabel(view, other, quantities), spacing].filter(Boolean).join(", "),
      other,
      isDraft,
      runs: group,
      colour: isDraft && levels.length === 1 ? "#7b848f" : colours[at % colours.length],
      dash: isDraft ? "2 4" : dashes[at % dashes.length],
    };
  });
}

const near = (a: number, b: number) => Math.abs(a - b) <= 1e-6 * Math.max(Math.abs(a), Math.abs(b));

/** What the model says along the horizontal axis for one series; empty where it says nothing of what is shown. */
export function modelOf(data: StudyData, view: View, series: Series): ModelPoint[] {
  const { model } = data.study;
  if (!model || model.metric !== view.metric || series.isDraft) return [];
  const points = data.model_points.filter(({ at, along }) => {
    if (along !== view.x) return false;
    if (series.other !== undefined && at[view.y] !== undefined && !near(at[view.y], series.other)) return false;
    return Object.entries(view.fixed).every(([key, value]) => key === view.x || key === view.y || value === all || at[key] === undefined || near(at[key], Number(value)));
  });
  const sorted = points.sort((a, b) => a.at[view.x] - b.at[view.x]);
  const isOneCurve = sorted.every((point, at) => at === 0 || point.at[view.x] > sorted[at - 1].at[view.x]);
  return isOneCurve ? sorted : [];
}
