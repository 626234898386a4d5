// SPDX-License-Identifier: Apache-2.0
// How a chart looks: axes with round numbers under a common prefix, curves as in the printed plots.

import type uPlot from "uplot";

import type { Group } from "./curve_data.ts";
import { formatQuantity, plainUnit, prefixFor } from "./quantities.ts";

// Okabe and Ito, 2008; the order is that of the printed plots.
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a6a00", "#444b54"];
const soft = "#5b6470";
const line = "#e3e6ea";
export const font = '12px system-ui, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif';

function prefixOf(chart: uPlot, scale: string, unit: string) {
  const { min, max } = chart.scales[scale];
  return prefixFor(Math.max(Math.abs(min ?? 0), Math.abs(max ?? 0)), unit);
}

function axis(name: string, scale: string, unit: string): uPlot.Axis {
  const title = (chart: uPlot) => {
    const whole = prefixOf(chart, scale, unit).symbol + plainUnit(unit);
    return whole === "" ? name : name === "" ? whole : `${name} / ${whole}`;
  };
  const tick = (value: number) => String(Number(value.toPrecision(10))).replace("-", "−");
  return {
    scale,
    stroke: soft,
    font,
    labelFont: font,
    label: title as unknown as string,
    labelSize: 18,
    grid: { stroke: line, width: 1 },
    ticks: { stroke: line, width: 1, size: 4 },
    gap: 4,
    values: (chart, splits) => {
      const { factor } = prefixOf(chart, scale, unit);
      return splits.map((value) => tick(value * factor));
    },
  };
}

function widestTick(_chart: uPlot, values: string[] | null): number {
  return 16 + 7 * Math.max(3, ...(values ?? []).map((value) => value.length));
}

function readout(unit: string, digits: number) {
  return (_chart: uPlot, value: number | null) => (value === null ? "–" : formatQuantity(value, unit, digits));
}

function curves(group: Group): uPlot.Series[] {
  return group.series.map((series, at) => ({
    label: series.label,
    scale: "y",
    stroke: colours[at % colours.length],
    width: 1.75,
    // Every other line is dashed, so that neighbours differ without their colours as well.
    dash: at % 2 === 1 ? [5, 3] : undefined,
    points: { show: false },
    pxAlign: 0, // rounded to pixels, slow curves look like stairs
    value: readout(group.unit, 4),
  }));
}

export function chartOptions(group: Group, size: { width: number; height: number }): uPlot.Options {
  return {
    ...size,
    scales: { x: { time: false }, y: {} },
    axes: [
      { ...axis("time", "x", "s"), size: 24, space: 60 },
      { ...axis("", "y", group.unit), size: widestTick as uPlot.Axis.Size, space: 36 },
    ],
    series: [{ label: "time", value: readout("s", 4) }, ...curves(group)],
    legend: { live: true, markers: { width: 3 } },
    cursor: {
      sync: {
        key: "kerf",
        // The zoom is shared by hand: the charts would pass it on as pixels, not as times.
        filters: { pub: (type) => type === "mousemove" || type === "mouseleave" },
      },
      drag: { x: true, y: false, setScale: true },
      points: { size: 6 },
    },
  };
}
