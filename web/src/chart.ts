// SPDX-License-Identifier: Apache-2.0
// One chart: its marks, the line at the shown frame, clicks and the shared zoom.

import uPlot from "uplot";

import { chartOptions, font } from "./chart_options.ts";
import type { CurveData, Group, Mark } from "./curve_data.ts";
import { element } from "./dom.ts";

export interface Interval {
  from: number;
  to: number;
}

export interface ChartEvents {
  zoomed: (interval: Interval | undefined) => void; // undefined: all
  clicked: (time: number) => void;
}

const height = 260;
const clickReach = 4; // px, further is a drag

export class Chart {
  readonly root: HTMLElement;
  private readonly now = element("div", { className: "kerf-now" });
  private readonly plot: uPlot;
  private time: number | undefined;

  constructor(
    private data: CurveData,
    private readonly at: number,
    private readonly events: ChartEvents,
  ) {
    const group = data.groups[at];
    this.root = element("figure", { className: "kerf-chart" }, element("figcaption", {}, group.label));
    this.root.dataset.group = String(at);
    const options = chartOptions(group, { width: 560, height });
    options.hooks = {
      draw: [(plot) => this.drawMarks(plot)],
      setScale: [(plot, key) => key === "x" && this.scaled(plot)],
      setSize: [() => this.placeNow()],
      setLegend: [(plot) => plot.legend.idx == null && this.showValues()],
    };
    this.plot = new uPlot(options, columns(data, group), this.root);
    this.plot.over.append(this.now);
    this.plot.over.setAttribute("role", "img");
    this.plot.over.setAttribute("aria-label", `Curves over time: ${group.label}`);
    this.listenToClicks();
    this.nameLegend();
  }

  fitWidth() {
    const width = this.root.clientWidth;
    if (width > 0 && width !== this.plot.width) this.plot.setSize({ width, height });
  }

  setData(data: CurveData, interval: Interval | undefined) {
    this.data = data;
    this.plot.setData(columns(data, data.groups[this.at]), interval === undefined);
    if (interval) this.plot.setScale("x", { min: interval.from, max: interval.to });
  }

  zoom(interval: Interval | undefined) {
    const { time } = this.data;
    const whole = { from: time[0] ?? 0, to: time[time.length - 1] ?? 1 };
    const { from, to } = interval ?? whole;
    this.plot.setScale("x", { min: from, max: to });
  }

  setTime(time: number | undefined) {
    this.time = time;
    this.placeNow();
    this.showValues();
  }

  /** Without a pointer over the chart, its legend tells the values at the shown frame. */
  private showValues() {
    const { time, plot } = this;
    if (time === undefined || !plot || plot.cursor.left! >= 0) return;
    plot.setLegend({ idx: plot.valToIdx(time) }, false);
  }

  destroy() {
    this.plot.destroy();
    this.root.remove();
  }

  private scaled(plot: uPlot) {
    const { min, max } = plot.scales.x;
    if (min == null || max == null) return;
    this.root.dataset.from = String(min);
    this.root.dataset.to = String(max);
    this.placeNow();
    const { time } = this.data;
    const all = time.length === 0 || (min <= time[0] && max >= time[time.length - 1]);
    this.events.zoomed(all ? undefined : { from: min, to: max });
  }

  private placeNow() {
    if (!this.plot) return; // the library calls while it is being made
    const { min, max } = this.plot.scales.x;
    const { time } = this;
    const inside = time !== undefined && min != null && max != null && time >= min && time <= max;
    this.now.hidden = !inside;
    if (inside) this.now.style.left = `${this.plot.valToPos(time, "x")}px`;
  }

  private drawMarks(plot: uPlot) {
    const { ctx, bbox } = plot;
    const ratio = uPlot.pxRatio;
    const { min, max } = plot.scales.x;
    if (min == null || max == null) return;
    ctx.save();
    ctx.font = font.replace("12px", `${12 * ratio}px`);
    ctx.textBaseline = "top";
    ctx.textAlign = "left";
    const marks = this.data.marks.filter((mark) => mark.time >= min && mark.time <= max);
    const ends: number[] = []; // of the text in each row
    for (const mark of marks) {
      const x = Math.round(plot.valToPos(mark.time, "x", true));
      ctx.strokeStyle = ctx.fillStyle = "#22272e";
      ctx.lineWidth = ratio;
      ctx.setLineDash([2 * ratio, 3 * ratio]);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      const width = ctx.measureText(mark.label).width + 5 * ratio;
      const left = x + width < bbox.left + bbox.width ? x : x - width;
      const free = ends.findIndex((end) => end < left);
      const row = free < 0 ? ends.length : free;
      ends[row] = left + width;
      this.writeMark(mark, left + (left < x ? 0 : 5 * ratio), bbox.top + (4 + 15 * row) * ratio);
    }
    ctx.restore();
  }

  private writeMark(mark: Mark, x: number, y: number) {
    const { ctx } = this.plot;
    ctx.setLineDash([]);
    ctx.strokeStyle = "#fff";
    ctx.lineWidth = 4 * uPlot.pxRatio;
    ctx.lineJoin = "round";
    ctx.strokeText(mark.label, x, y);
    ctx.fillText(mark.label, x, y);
  }

  private listenToClicks() {
    const { over } = this.plot;
    let pressed = 0;
    over.addEventListener("mousedown", (event) => (pressed = event.clientX));
    over.addEventListener("click", (event) => {
      if (Math.abs(event.clientX - pressed) > clickReach) return;
      this.events.clicked(this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
    });
  }

  // The library's legend hides a curve on a click; this makes it do so for the keyboard as well.
  private nameLegend() {
    for (const entry of this.root.querySelectorAll<HTMLElement>(".u-series:not(:first-child) > th")) {
      entry.tabIndex = 0;
      entry.setAttribute("role", "button");
      entry.title = "Show or hide";
      entry.addEventListener("keydown", (event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        entry.click();
      });
    }
  }
}

function columns(data: CurveData, group: Group): uPlot.AlignedData {
  return [data.time, ...group.series.map((series) => series.values)];
}
