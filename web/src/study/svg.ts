// SPDX-License-Identifier: Apache-2.0
// Drawings as elements: sharp on paper, read out by screen readers, and links are links.

type Attributes = Record<string, string | number | undefined>;

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): SVGElementTagNameMap[K] {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes))
    if (value !== undefined) made.setAttribute(name, typeof value === "number" ? String(Number(value.toFixed(2))) : value);
  made.append(...children);
  return made;
}

export const ink = "#22272e";
export const soft = "#5b6470";
export const faint = "#dfe3e8";

export function text(x: number, y: number, words: string, attributes: Attributes = {}): SVGTextElement {
  return svg("text", { x, y, fill: ink, "font-size": 13, ...attributes }, words);
}

/** Text that can be read on any colour. */
export function haloText(x: number, y: number, words: string, attributes: Attributes = {}): SVGTextElement {
  return text(x, y, words, {
    "paint-order": "stroke",
    stroke: "#fff",
    "stroke-width": 3.5,
    "stroke-linejoin": "round",
    ...attributes,
  });
}

let context: CanvasRenderingContext2D | null = null;

/** About how wide it is, in px. */
export function widthOf(words: string, size = 13): number {
  context ??= document.createElement("canvas").getContext("2d");
  if (!context) return words.length * size * 0.55;
  context.font = `${size}px ${getComputedStyle(document.body).fontFamily}`;
  return context.measureText(words).width;
}

/** A pattern of lines at 45°, to be put into <defs>. */
export function hatch(id: string, colour: string, gap: number, width: number): SVGPatternElement {
  return svg(
    "pattern",
    { id, width: gap, height: gap, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
    svg("line", { x1: 0, y1: 0, x2: 0, y2: gap, stroke: colour, "stroke-width": width }),
  );
}
