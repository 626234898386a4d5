// SPDX-License-Identifier: Apache-2.0
// Answers, map, curve and table of a study, drawn anew when the reader chooses something else.

import { element } from "../dom.ts";
import { answersOf } from "./answers.ts";
import { Controls } from "./controls.ts";
import { drawCurve } from "./curve.ts";
import { drawMap } from "./map.ts";
import { spreadsOut } from "./patches.ts";
import { Quantities, titleOf } from "./quantity.ts";
import { saveDrawing } from "./save_drawing.ts";
import { stateOf } from "./state_line.ts";
import type { StudyData } from "./study_data.ts";
import { RunTable } from "./table.ts";
import { Tooltip } from "./tooltip.ts";
import { chosenRuns, pointsOf, rememberView, viewFromAddress, type View } from "./view.ts";

export class StudyPage {
  readonly root = element("div", { className: "kerf-study" });
  private readonly quantities: Quantities;
  private readonly view: View;
  private readonly map = element("div", { className: "kerf-drawing", id: "kerf-map" });
  private readonly curve = element("div", { className: "kerf-drawing", id: "kerf-curve" });
  private readonly mapPart = element("div");
  private readonly mapCaption = element("figcaption");
  private readonly curveCaption = element("figcaption");
  private readonly hasMap: boolean;
  private width = 0;

  constructor(private readonly data: StudyData) {
    this.quantities = new Quantities(data);
    this.view = viewFromAddress(data);
    this.hasMap = this.view.y !== "";
    const { root, quantities } = this;
    root.append(...answersOf(data, quantities), stateOf(data));
    const controls = new Controls(data, this.view, quantities, () => this.choose());
    if (this.view.x !== "") root.append(controls.root);
    if (this.hasMap) root.append(this.mapPart);
    this.mapPart.append(element("h2", {}, "Map"), this.figure(this.mapCaption, this.map, "map"));
    if (this.view.x !== "") root.append(element("h2", {}, "Curve"), this.figure(this.curveCaption, this.curve, "curve"));
    root.append(element("h2", {}, "Runs"), new RunTable(data, quantities).root, this.meanings());
  }

  /** Once it is in the page. */
  start() {
    if (this.view.x === "") return;
    new ResizeObserver(() => this.curve.clientWidth !== this.width && this.draw()).observe(this.curve);
    this.draw();
  }

  /** What the varied keys mean, in the words of the reference of keys. */
  private meanings(): HTMLElement {
    const entries = this.data.study.keys.flatMap(({ key }) => {
      const quantity = this.quantities.get(key);
      return [element("dt", {}, titleOf(quantity)), element("dd", {}, quantity.help, " ", element("code", {}, key))];
    });
    return element("details", { id: "kerf-meanings" }, element("summary", {}, "What the settings mean"), element("dl", {}, ...entries));
  }

  private figure(caption: HTMLElement, place: HTMLElement, name: string): HTMLElement {
    const save = element("button", { type: "button", className: "kerf-save" }, "Save as SVG");
    save.addEventListener("click", () => saveDrawing(place, caption.textContent ?? "", `${this.data.study.title} ${name}`));
    return element("figure", { className: "kerf-figure" }, element("div", { className: "kerf-head" }, caption, save), place);
  }

  private choose() {
    rememberView(this.view);
    this.draw();
  }

  private draw() {
    this.width = this.curve.clientWidth;
    const width = Math.max(300, this.width);
    const { data, view, quantities } = this;
    const runs = chosenRuns(data, view);
    const what = view.metric === "cut_through" ? "verdict" : quantities.get(view.metric).label;
    const over = quantities.get(view.x).label;
    const title = what.charAt(0).toUpperCase() + what.slice(1);
    const tooltipIn = (place: HTMLElement) => {
      place.replaceChildren();
      return new Tooltip(place, quantities);
    };
    const points = pointsOf(runs, view);
    this.mapPart.hidden = !spreadsOut(points.map((point) => ({ u: point.x, v: point.y })));
    if (this.hasMap) {
      const tooltip = tooltipIn(this.map);
      this.mapCaption.textContent = `${title} over ${over} and ${quantities.get(view.y).label}`;
      this.map.append(drawMap(points, view, quantities, tooltip, { width, best: data.study.search?.setting }));
    }
    const tooltip = tooltipIn(this.curve);
    this.curveCaption.textContent = `${title} over ${over}`;
    this.curve.append(drawCurve(data, runs, view, quantities, tooltip, width));
  }
}
