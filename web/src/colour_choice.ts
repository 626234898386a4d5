// SPDX-License-Identifier: Apache-2.0
// What the colours show: the state of the matter, or one field, over which range.

import { element, selection } from "./dom.ts";
import type { Particles } from "./frames.ts";
import { legendOf } from "./legend.ts";
import { percentileRange } from "./percentiles.ts";
import { codedRange, type Field, type Run } from "./run.ts";

const byCategory = "category";
const ranges: [value: string, label: string][] = [
  ["0", "whole range of the run"],
  ["0.01", "1% to 99% of this frame"],
  ["0.05", "5% to 95% of this frame"],
];

export class ColourChoice {
  readonly root: HTMLElement;
  private fields: Field[] = [];
  private key = byCategory;
  private readonly select = selection("kerf-colour", [], "");
  private readonly range = selection("kerf-range", ranges, "0");
  private readonly hasRanges: boolean;
  private readonly rangeLabel = element("label", { htmlFor: "kerf-range", className: "kerf-soft" }, "Colours span");
  private readonly legend = element("div", { id: "kerf-legend" });
  private adapted: Field | undefined;

  /** Without `hasRanges`, the colours always span the whole range of the run. */
  constructor(fields: Field[], changed: () => void, hasRanges = true) {
    this.hasRanges = hasRanges;
    this.select.onchange = () => {
      this.key = this.select.value;
      this.adapted = undefined;
      this.refresh();
      changed();
    };
    this.range.onchange = changed;
    this.root = element(
      "div",
      { className: "kerf-group" },
      element("label", { htmlFor: "kerf-colour" }, "Colour by"),
      this.select,
      this.rangeLabel,
      this.range,
      this.legend,
    );
    this.setFields(fields);
  }

  /** The number of the field; -1 for the state of the matter. */
  get index(): number {
    return this.fields.findIndex((field) => field.key === this.key);
  }

  /** With the range that the colours span. */
  get field(): Field | undefined {
    return this.adapted ?? this.fields[this.index];
  }

  setFields(fields: Field[]) {
    this.fields = fields;
    const options: [string, string][] = fields.map((field) => [field.key, field.label]);
    this.select.replaceChildren(...selection("", [[byCategory, "state of the matter"], ...options], "").options);
    if (this.index < 0) this.key = byCategory;
    this.select.value = this.key;
    this.adapted = undefined;
    this.refresh();
  }

  /** Lets the colours span the chosen range in the frame that is shown. */
  adapt(run: Run, frame: number, particles: Particles) {
    const { index } = this;
    const outside = Number(this.range.value);
    const field = this.fields[index];
    const adapted = field && !field.names && outside > 0 ? { ...field, ...percentileRange(particles.values[index], codedRange(run, index, frame), outside) } : undefined;
    if (!adapted && !this.adapted) return;
    this.adapted = adapted;
    this.refresh();
  }

  private refresh() {
    const { field } = this;
    const hasRange = this.hasRanges && field !== undefined && !field.names;
    this.range.hidden = this.rangeLabel.hidden = !hasRange;
    this.legend.replaceChildren(...(field ? [legendOf(field)] : []));
  }
}
