// SPDX-License-Identifier: Apache-2.0
// What lies under the pointer: the particle in front, and its value of the field that is shown.

import { Matrix4, type Camera } from "three";

import { element } from "./dom.ts";
import { imagesOf } from "./extent.ts";
import type { Particles } from "./frames.ts";
import { valueOf } from "./percentiles.ts";
import type { Showing } from "./points.ts";
import { formatQuantity } from "./quantities.ts";
import type { Field, Range, Run } from "./run.ts";

export interface Scene {
  run: Run;
  particles: Particles;
  camera: Camera;
  showing: Showing[]; // of the categories
  clip: [number, number, number, number]; // keeps places with clip.xyz . place <= clip.w
}

/** The particle at a place of the picture, in pixels from its upper left corner; -1 = none. */
export function particleAt(scene: Scene, x: number, y: number, width: number, height: number): number {
  const { run, particles, camera, showing, clip } = scene;
  const m = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  const scale = [0, 1, 2].map((axis) => (run.maximum[axis] - run.minimum[axis]) / 65535);
  const halfHeight = 0.5 * height;
  const place = [0, 0, 0];
  let found = -1;
  let nearest = Infinity; // depth in 3D, distance in 2D
  for (const image of imagesOf(run.mirrors)) {
    for (let i = 0; i < particles.count; ++i) {
      if (showing[particles.categories[i]] !== "full") continue;
      for (let axis = 0; axis < run.dimension; ++axis) place[axis] = run.minimum[axis] + scale[axis] * particles.places[axis][i];
      for (const mirror of run.mirrors) if (image[mirror.axis]) place[mirror.axis] = 2 * mirror.place - place[mirror.axis];
      const [px, py, pz] = place;
      if (clip[0] * px + clip[1] * py + clip[2] * pz > clip[3]) continue;
      const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
      if (w <= 0) continue;
      const across = (0.5 + (0.5 * (m[0] * px + m[4] * py + m[8] * pz + m[12])) / w) * width - x;
      const down = (0.5 - (0.5 * (m[1] * px + m[5] * py + m[9] * pz + m[13])) / w) * height - y;
      const diameter = run.spacings[particles.sizes[i]] ?? 0;
      const radius = Math.max(1.5, 0.5 * ((diameter * camera.projectionMatrix.elements[5] * halfHeight) / w));
      const distance = Math.hypot(across, down);
      if (distance > radius * 1.2) continue;
      const rank = run.dimension === 2 ? distance : m[2] * px + m[6] * py + m[10] * pz + m[14];
      if (rank < nearest) [nearest, found] = [rank, i];
    }
  }
  return found;
}

/** "solid, speed 4.2 m/s"; a value is known to a 255th of the range of its frame. */
export function wordsFor(particle: number, run: Run, particles: Particles, field: Field | undefined, coded: Range | undefined): string {
  const category = run.categories[particles.categories[particle]]?.label ?? "";
  if (!field || !coded) return category;
  const value = valueOf(particles.values[run.fields.indexOf(field)]?.[particle] ?? 0, coded);
  if (field.names) return field.names[Math.round(value)] ?? "";
  return `${category}, ${field.label} ${formatQuantity(value, field.unit)}`;
}

/** A label beside the pointer. `words` says what is at a place of the picture, "" = nothing. */
export function pointerLabel(canvas: HTMLCanvasElement, words: (x: number, y: number) => string, id: string): HTMLElement {
  const label = element("div", { className: "kerf-value", id, hidden: true });
  label.setAttribute("aria-hidden", "true");
  let waiting = false;
  const show = (event: PointerEvent) => {
    waiting = false;
    const text = event.buttons === 0 ? words(event.offsetX, event.offsetY) : "";
    label.hidden = text === "";
    label.textContent = text;
    const isRight = event.offsetX > 0.6 * canvas.clientWidth;
    label.style.left = isRight ? "" : `${event.offsetX + 12}px`;
    label.style.right = isRight ? `${canvas.clientWidth - event.offsetX + 12}px` : "";
    label.style.top = `${Math.max(0, event.offsetY - 30)}px`;
  };
  canvas.addEventListener("pointermove", (event) => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => show(event));
  });
  canvas.addEventListener("pointerleave", () => (label.hidden = true));
  return label;
}
