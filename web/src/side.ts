// SPDX-License-Identifier: Apache-2.0
// Buttons that look from somewhere else, and that keep what is seen.

import { element } from "./dom.ts";
import { formatQuantity } from "./quantities.ts";
import { directions } from "./view.ts";
import type { Run } from "./run.ts";
import type { Direction } from "./view.ts";

interface Actions {
  look: (direction?: Direction) => void;
  save?: () => void;
}

function button(id: string, label: string, action: () => void): HTMLButtonElement {
  return element("button", { id, type: "button", onclick: action }, label);
}

export function viewButtons(dimension: 2 | 3, actions: Actions): HTMLElement {
  const sides = dimension === 3 ? Object.entries(directions) : [];
  const looks = sides.map(([name, direction]) => button(`kerf-look-${name}`, name, () => actions.look(direction)));
  const group = element("div", { className: "kerf-group" });
  if (looks.length > 0) group.append(element("div", { className: "kerf-buttons" }, ...looks));
  const reset = button("kerf-reset", "reset view", () => actions.look());
  const save = actions.save ? [button("kerf-save", "save picture", actions.save)] : [];
  group.append(element("div", { className: "kerf-buttons" }, reset, ...save));
  return group;
}

/** What of the picture was not computed. */
export function mirrorNote(run: Run): HTMLElement[] {
  if (run.mirrors.length === 0) return [];
  const planes = run.mirrors.map(({ axis, place }) => `${"xyz"[axis]} = ${formatQuantity(place, "m")}`);
  const part = run.mirrors.length === 1 ? "One half" : run.mirrors.length === 2 ? "One quarter" : "One eighth";
  const text = `${part} was computed; the rest are its images in ${planes.join(" and ")}.`;
  return [element("div", { className: "kerf-group kerf-soft", id: "kerf-mirrors" }, text)];
}
