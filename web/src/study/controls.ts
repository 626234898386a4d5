// SPDX-License-Identifier: Apache-2.0
// What is shown, over what, and of which runs.

import { element, selection } from "../dom.ts";
import type { Quantities } from "./quantity.ts";
import type { StudyData } from "./study_data.ts";
import { all, distinctOf, metricsOf, numericKeys, valuesOf, type View } from "./view.ts";

type Options = [value: string, label: string][];

function labelled(words: string, select: HTMLSelectElement): HTMLLabelElement {
  return element("label", {}, element("span", {}, words), select);
}

export class Controls {
  readonly root = element("form", { className: "kerf-controls", attributes: { "aria-label": "What is shown" } });

  constructor(
    private readonly data: StudyData,
    private readonly view: View,
    private readonly quantities: Quantities,
    private readonly changed: () => void,
  ) {
    this.root.addEventListener("submit", (event) => event.preventDefault());
    this.fill();
  }

  private fill() {
    const { data, view } = this;
    const keys = this.keyOptions();
    const parts = [this.metricChoice()];
    if (keys.length > 1) {
      parts.push(this.choice("kerf-x", "over", keys, view.x, (value) => this.setAxis("x", value)));
      parts.push(this.choice("kerf-y", "and", keys, view.y, (value) => this.setAxis("y", value)));
    }
    if (keys.length > 1) {
      const styles: Options = [["contours", "contours"], ["cells", "cells"]];
      parts.push(this.choice("kerf-style", "as", styles, view.style, (value) => (view.style = value)));
    }
    for (const { key } of data.study.keys) {
      const values = valuesOf(data, key);
      if (key === view.x || key === view.y || values.length < 2) continue;
      const show = (value: number | string) => (typeof value === "number" ? this.quantities.show(key, value) : value);
      const options: Options = [[all, "all"], ...values.map((value): [string, string] => [String(value), show(value)])];
      parts.push(this.choice(`kerf-at-${key}`, this.quantities.get(key).label, options, view.fixed[key], (value) => (view.fixed[key] = value)));
    }
    const layouts = distinctOf(data, "repeat");
    if (layouts.length > 1) {
      const options: Options = [[all, "mean of all"], ...layouts.map((layout): [string, string] => [String(layout), String(layout + 1)])];
      parts.push(this.choice("kerf-repeat", "layout", options, view.repeat, (value) => (view.repeat = value)));
    }
    const resolutions = distinctOf(data, "refinement");
    if (resolutions.length > 1) {
      const spacing = (refinement: number) => this.quantities.show("spacing", data.study.runs.find((run) => run.refinement === refinement)?.spacing);
      const options: Options = [[all, "all"], ...resolutions.reverse().map((one): [string, string] => [String(one), spacing(one)])];
      parts.push(this.choice("kerf-refinement", "spacing", options, view.refinement, (value) => (view.refinement = value)));
    }
    this.root.replaceChildren(...parts);
  }

  private keyOptions(): Options {
    const { data, quantities } = this;
    const { model } = data.study;
    const names = [...numericKeys(data).map((key) => key.key), model?.drive, ...(model?.variables ?? [])];
    const distinct = [...new Set(names.filter((name) => name !== undefined && name !== ""))] as string[];
    return distinct.map((name) => [name, quantities.get(name).label]);
  }

  private metricChoice(): HTMLElement {
    const { data, view, quantities } = this;
    const known = metricsOf(data);
    const columns = known.filter((name) => data.study.metrics.some((metric) => metric.name === name));
    const group = (label: string, names: string[]) => element("optgroup", { label }, ...names.map((value) => element("option", { value }, quantities.get(value).label)));
    const select = element("select", { id: "kerf-metric" }, element("option", { value: "cut_through" }, "verdict"), group("of the table", columns));
    const further = known.filter((name) => !columns.includes(name));
    if (further.length > 0) select.append(group("further numbers of a result", further));
    select.value = view.metric;
    select.addEventListener("change", () => {
      view.metric = select.value;
      this.changed();
    });
    return labelled("Show", select);
  }

  private choice(id: string, words: string, options: Options, chosen: string, set: (value: string) => void): HTMLElement {
    const select = selection(id, options, chosen);
    select.addEventListener("change", () => {
      set(select.value);
      this.fill();
      this.root.querySelector<HTMLElement>(`#${CSS.escape(id)}`)?.focus();
      this.changed();
    });
    return labelled(words, select);
  }

  // The same key is not on both axes: they change places.
  private setAxis(axis: "x" | "y", value: string) {
    const { view } = this;
    const other = axis === "x" ? "y" : "x";
    if (view[other] === value) view[other] = view[axis];
    view[axis] = value;
  }
}
