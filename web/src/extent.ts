// SPDX-License-Identifier: Apache-2.0
// Where the particles are, without the few that fly far ahead.

import type { Particles } from "./frames.ts";
import type { Mirror, Point, Run } from "./run.ts";

export interface Box {
  minimum: Point;
  maximum: Point;
}

/** With its images in the planes of symmetry. */
export function withImages(box: Box, mirrors: Mirror[]): Box {
  const whole: Box = { minimum: [...box.minimum], maximum: [...box.maximum] };
  for (const { axis, place } of mirrors) {
    whole.minimum[axis] = Math.min(box.minimum[axis], 2 * place - box.maximum[axis]);
    whole.maximum[axis] = Math.max(box.maximum[axis], 2 * place - box.minimum[axis]);
  }
  return whole;
}

/** Which images to draw: none, in each plane, and in those images' planes; three flags for each. */
export function imagesOf(mirrors: Mirror[]): number[][] {
  let images = [[0, 0, 0]];
  for (const { axis } of mirrors)
    images = images.concat(images.map((image) => image.map((flag, at) => (at === axis ? 1 : flag))));
  return images;
}

const stray = 0.02; // share of each category left out at either end

// Of each category apart: a jet may be less than the stray share of all particles.
function quantiles(places: Uint16Array, categories: Uint8Array, wanted: number): [number, number] | undefined {
  const histogram = new Uint32Array(65536);
  let count = 0;
  for (let i = 0; i < places.length; ++i) {
    if (categories[i] !== wanted) continue;
    ++histogram[places[i]];
    ++count;
  }
  if (count === 0) return undefined;
  const leftOut = Math.floor(stray * count);
  const walk = (from: number, step: number) => {
    let at = from;
    for (let seen = histogram[at]; seen <= leftOut; seen += histogram[at]) at += step;
    return at;
  };
  return [walk(0, 1), walk(65535, -1)];
}

export function extentOf(particles: Particles, run: Run): Box {
  const box: Box = { minimum: [...run.minimum], maximum: [...run.maximum] };
  if (particles.count === 0) return withImages(box, run.mirrors);
  const present = [...new Set(particles.categories)];
  particles.places.forEach((places, axis) => {
    const ends = present.map((category) => quantiles(places, particles.categories, category)!);
    const scale = (run.maximum[axis] - run.minimum[axis]) / 65535;
    const low = Math.min(...ends.map(([first]) => first));
    const high = Math.max(...ends.map(([, last]) => last));
    box.minimum[axis] = run.minimum[axis] + scale * low;
    box.maximum[axis] = run.minimum[axis] + scale * high;
  });
  return withImages(box, run.mirrors);
}
