// SPDX-License-Identifier: Apache-2.0
// What lies over the picture: a scale bar in 2D, the axes of space in 3D.

import { element } from "./dom.ts";
import { formatQuantity, roundLength } from "./quantities.ts";
import type { Point } from "./run.ts";

const svgSpace = "http://www.w3.org/2000/svg";

export interface Overlay {
  root: HTMLElement | SVGSVGElement;
  refresh: () => void;
}

export interface Scale {
  pixels: number;
  label: string;
}

/** A round length that takes at most a fifth of the picture's width. */
export function scaleFor(metresPerPixel: number, width: number): Scale {
  const length = roundLength(Math.max(0.2 * width, 50) * metresPerPixel);
  return { pixels: length / metresPerPixel, label: formatQuantity(length, "m") };
}

export function scaleBar(canvas: HTMLCanvasElement, metresPerPixel: () => number): Overlay {
  const label = element("span");
  const bar = element("i");
  const root = element("div", { className: "kerf-scale" }, label, bar);
  const refresh = () => {
    const scale = scaleFor(metresPerPixel(), canvas.clientWidth);
    bar.style.width = `${scale.pixels}px`;
    label.textContent = scale.label;
  };
  return { root, refresh };
}

export function axesSign(axes: () => Point[]): Overlay {
  const root = document.createElementNS(svgSpace, "svg");
  root.setAttribute("class", "kerf-axes");
  root.setAttribute("viewBox", "-32 -32 64 64");
  root.setAttribute("aria-hidden", "true");
  const parts = ["x", "y", "z"].map((name) => {
    const line = document.createElementNS(svgSpace, "path");
    const label = document.createElementNS(svgSpace, "text");
    label.textContent = name;
    root.append(line, label);
    return { line, label };
  });
  const refresh = () => {
    axes().forEach(([right, up], axis) => {
      parts[axis].line.setAttribute("d", `M0 0L${18 * right} ${-18 * up}`);
      parts[axis].label.setAttribute("x", String(25 * right));
      parts[axis].label.setAttribute("y", String(-25 * up));
    });
  };
  return { root, refresh };
}
