// SPDX-License-Identifier: Apache-2.0
// All charts of a run: one time, one zoom.

import "uplot/dist/uPlot.min.css";

import { Chart } from "./chart.ts";
import type { Interval } from "./chart.ts";
import type { CurveData } from "./curve_data.ts";
import { element } from "./dom.ts";
import type { Player } from "./player.ts";

export class Curves {
  readonly root = element("div", { className: "kerf-charts" });
  private charts: Chart[] = [];
  private shape = "";
  private interval: Interval | undefined;

  constructor(
    data: CurveData,
    private readonly player: Player | undefined,
  ) {
    this.update(data);
    player?.onChange(() => this.markTime());
    new ResizeObserver(() => this.charts.forEach((chart) => chart.fitWidth())).observe(this.root);
  }

  update(data: CurveData) {
    const shape = JSON.stringify(data.groups.map((group) => [group.label, group.unit, group.series.map((one) => one.key)]));
    if (shape === this.shape) {
      for (const chart of this.charts) chart.setData(data, this.interval);
    } else {
      for (const chart of this.charts) chart.destroy();
      this.charts = data.groups.map((_, at) => this.add(data, at));
      this.shape = shape;
    }
    this.markTime();
  }

  private add(data: CurveData, at: number): Chart {
    const chart = new Chart(data, at, {
      zoomed: (interval) => this.zoom(interval, chart),
      clicked: (time) => this.player?.goToTime(time),
    });
    this.root.append(chart.root);
    chart.fitWidth();
    return chart;
  }

  private zoom(interval: Interval | undefined, origin: Chart) {
    // Those that are told to zoom tell of it in turn.
    if (interval?.from === this.interval?.from && interval?.to === this.interval?.to) return;
    this.interval = interval;
    for (const chart of this.charts) if (chart !== origin) chart.zoom(interval);
  }

  private markTime() {
    for (const chart of this.charts) chart.setTime(this.player?.time);
  }
}
