// SPDX-License-Identifier: Apache-2.0
// What is said of a point while the pointer or the focus is on it.

import { element } from "../dom.ts";
import type { Quantities } from "./quantity.ts";
import { numberOf, type StudyRun } from "./study_data.ts";
import { inlineSymbol, verdictOf, verdictWords } from "./verdict.ts";

const most = 6; // runs that are told of

function metricWords(run: StudyRun, metric: string, quantities: Quantities): string {
  if (run.state === "failed") return run.error.split("\n")[0];
  if (metric === "cut_through" || numberOf(run, metric) === undefined) return "";
  return `${quantities.get(metric).label} ${quantities.show(metric, numberOf(run, metric))}`;
}

export function describe(runs: StudyRun[], metric: string, quantities: Quantities): string {
  const each = runs.map((run) => [verdictWords[verdictOf(run)], metricWords(run, metric, quantities)].filter(Boolean).join(", "));
  return `${quantities.showSetting(runs[0].setting)}: ${each.join("; ")}`;
}

export class Tooltip {
  readonly root = element("div", { className: "kerf-tooltip", hidden: true });

  constructor(
    private readonly place: HTMLElement,
    private readonly quantities: Quantities,
  ) {
    this.root.setAttribute("aria-hidden", "true"); // links say the same in their labels
    place.append(this.root);
  }

  attach(target: SVGElement, runs: StudyRun[], metric: string) {
    const show = () => this.show(target, runs, metric);
    const hide = () => (this.root.hidden = true);
    for (const name of ["pointerenter", "focus"]) target.addEventListener(name, show);
    for (const name of ["pointerleave", "blur"]) target.addEventListener(name, hide);
  }

  private show(target: SVGElement, runs: StudyRun[], metric: string) {
    const { quantities, root } = this;
    root.replaceChildren(element("strong", {}, quantities.showSetting(runs[0].setting)));
    for (const run of runs.slice(0, most)) {
      const words = [verdictWords[verdictOf(run)], metricWords(run, metric, quantities)].filter(Boolean).join(", ");
      const spacing = `spacing ${quantities.show("spacing", run.spacing)}`;
      const which = run.repeat > 0 ? `${spacing}, layout ${run.repeat + 1}` : spacing;
      root.append(element("div", {}, inlineSymbol(verdictOf(run)), ` ${words} `, element("span", { className: "kerf-soft" }, `(${which})`)));
    }
    if (runs.length > most) root.append(element("div", {}, `and ${runs.length - most} more`));
    root.hidden = false;
    const [mark, around] = [target.getBoundingClientRect(), this.place.getBoundingClientRect()];
    const left = mark.left - around.left + 0.5 * mark.width - 0.5 * root.offsetWidth;
    const above = mark.top - around.top - root.offsetHeight - 8;
    root.style.left = `${Math.max(0, Math.min(left, around.width - root.offsetWidth))}px`;
    root.style.top = `${above > 0 ? above : mark.bottom - around.top + 8}px`;
  }
}
