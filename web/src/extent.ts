// SPDX-License-Identifier: Apache-2.0
// Where the particles are, without the few that fly far ahead.

import type { Particles } from "./frames.ts";
import type { Point, Run } from "./run.ts";

export interface Box {
  minimum: Point;
  maximum: Point;
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
  if (particles.count === 0) return box;
  const present = [...new Set(particles.categories)];
  particles.places.forEach((places, axis) => {
    const ends = present.map((category) => quantiles(places, particles.categories, category)!);
    const scale = (run.maximum[axis] - run.minimum[axis]) / 65535;
    const low = Math.min(...ends.map(([first]) => first));
    const high = Math.max(...ends.map(([, last]) => last));
    box.minimum[axis] = run.minimum[axis] + scale * low;
    box.maximum[axis] = run.minimum[axis] + scale * high;
  });
  return box;
}
