// SPDX-License-Identifier: Apache-2.0
// The frame around the canvas: its keys, and when the wheel is its own.

import { element } from "./dom.ts";

const keysInWords =
  "Drag to move, wheel or plus and minus to zoom, left and right arrows to step, space to play, R to reset the view.";

export interface Keys {
  step: (by: number) => void;
  ends: (last: boolean) => void;
  toggle: () => void;
  reset: () => void;
  zoom: (factor: number) => void;
}

/** `name` says whose particles the picture shows. */
export function stageFrame(canvas: HTMLCanvasElement, id = "kerf-stage", name = "Particles"): HTMLElement {
  const frame = element("div", { className: "kerf-stage", id, tabIndex: 0 }, canvas);
  frame.setAttribute("role", "group");
  frame.setAttribute("aria-label", `${name}. ${keysInWords}`);
  canvas.addEventListener("pointerdown", () => frame.focus({ preventScroll: true }));
  leaveWheelToPage(frame);
  return frame;
}

// A reader who scrolls past must not be caught: the wheel zooms only in a picture that was clicked.
function leaveWheelToPage(frame: HTMLElement) {
  const hint = element("div", { className: "kerf-hint" }, "click the picture, then the wheel zooms");
  hint.setAttribute("aria-hidden", "true");
  frame.append(hint);
  let timer = 0;
  const onWheel = (event: WheelEvent) => {
    if (frame.contains(document.activeElement) || event.ctrlKey) return;
    event.stopPropagation();
    hint.classList.add("kerf-visible");
    clearTimeout(timer);
    timer = window.setTimeout(() => hint.classList.remove("kerf-visible"), 1200);
  };
  frame.addEventListener("wheel", onWheel, { capture: true, passive: true });
  frame.addEventListener("pointerdown", () => hint.classList.remove("kerf-visible"));
}

// Fields, lists and buttons have keys of their own.
function usesKey(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (key === "r" || key === "+" || key === "-" || key === "=") return target.tagName === "SELECT";
  if (key === " ") return target.matches("button, select, input[type=checkbox]");
  return target.matches("select, input");
}

export function listenToKeys(root: HTMLElement, keys: Keys) {
  const actions: Record<string, () => void> = {
    ArrowLeft: () => keys.step(-1),
    ArrowRight: () => keys.step(1),
    Home: () => keys.ends(false),
    End: () => keys.ends(true),
    " ": keys.toggle,
    r: keys.reset,
    "+": () => keys.zoom(1.25),
    "=": () => keys.zoom(1.25),
    "-": () => keys.zoom(0.8),
  };
  root.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key === "R" ? "r" : event.key;
    const action = actions[key];
    if (!action || usesKey(event.target, key)) return;
    event.preventDefault();
    action();
  });
}
