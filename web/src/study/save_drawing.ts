// SPDX-License-Identifier: Apache-2.0
// A drawing as a file of its own, with its caption: it is its own vector graphics already.

import { svg, text } from "./svg.ts";

const room = 34; // px for the caption

export function saveDrawing(place: HTMLElement, caption: string, name: string) {
  const shown = place.querySelector("svg[id]");
  if (!(shown instanceof SVGSVGElement)) return;
  const { width, height } = shown.viewBox.baseVal;
  const copy = shown.cloneNode(true) as SVGSVGElement;
  for (const link of copy.querySelectorAll("a")) link.removeAttribute("href"); // they lead nowhere from elsewhere
  const whole = svg(
    "svg",
    { xmlns: "http://www.w3.org/2000/svg", viewBox: `0 0 ${width} ${height + room}`, width, height: height + room, "font-family": "system-ui, 'Noto Sans', 'DejaVu Sans', sans-serif" },
    svg("rect", { width, height: height + room, fill: "#fff" }),
    text(14, 22, caption, { "font-size": 16, "font-weight": 650 }),
    svg("g", { transform: `translate(0 ${room})` }, copy),
  );
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(whole)], { type: "image/svg+xml" }));
  link.download = `${name.replaceAll(/[^\p{L}\p{N}]+/gu, "-").toLowerCase()}.svg`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
