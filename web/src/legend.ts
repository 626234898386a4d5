// SPDX-License-Identifier: Apache-2.0
// What the colours of a field mean.

import { colourOf, cssColour, groupColour } from "./colour_maps.ts";
import { element } from "./dom.ts";
import { formatNumber, join, plainUnit, prefixFor, roundTicks } from "./quantities.ts";
import type { Field } from "./run.ts";

export interface LegendText {
  title: string; // with the unit
  range: string;
  ticks: { share: number; label: string }[]; // 0..1 along the bar
}

export function legendText(field: Field): LegendText {
  const { minimum, maximum } = field;
  const prefix = prefixFor(Math.max(Math.abs(minimum), Math.abs(maximum)), field.unit);
  const unit = prefix.symbol + plainUnit(field.unit);
  const write = (value: number) => formatNumber(value * prefix.factor);
  const span = maximum - minimum;
  return {
    title: unit === "" ? field.label : `${field.label} / ${unit}`,
    range: `${write(minimum)} to ${join(write(maximum), unit)}`,
    ticks: roundTicks(minimum, maximum, 4).map((value) => ({
      share: span > 0 ? (value - minimum) / span : 0.5,
      label: write(value),
    })),
  };
}

export function paintBar(canvas: HTMLCanvasElement, field: Field) {
  const context = canvas.getContext("2d")!;
  for (let x = 0; x < canvas.width; ++x) {
    const share = x / (canvas.width - 1);
    const colour = colourOf(field.minimum + share * (field.maximum - field.minimum), field);
    context.fillStyle = cssColour(colour);
    context.fillRect(x, 0, 1, canvas.height);
  }
}

function legendOfGroups(names: string[]): HTMLElement {
  const rows = names.map((name, at) => {
    const dot = element("i", { className: "kerf-group-dot" });
    dot.style.background = cssColour(groupColour(at));
    return element("li", {}, dot, name);
  });
  return element("ul", { className: "kerf-groups" }, ...rows);
}

export function legendOf(field: Field): HTMLElement {
  if (field.names) return legendOfGroups(field.names);
  const words = legendText(field);
  const bar = element("canvas", { width: 256, height: 1 });
  paintBar(bar, field);
  const ticks = element("div", { className: "kerf-ticks" });
  for (const tick of words.ticks) {
    const label = element("span", {}, tick.label);
    label.style.left = `${100 * tick.share}%`;
    ticks.append(label);
  }
  return element(
    "div",
    { className: "kerf-bar", attributes: { role: "img", "aria-label": `${words.title}: ${words.range}` } },
    element("div", { className: "kerf-bar-title" }, words.title),
    bar,
    ticks,
    element("div", { className: "kerf-soft" }, words.range),
  );
}
