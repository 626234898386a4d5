// SPDX-License-Identifier: Apache-2.0
// A metric between the runs: bilinear in the cells of a grid, linear in Delaunay's triangles elsewhere.
// Places count from 0 to 1 along both axes as they are drawn.

import { Delaunay } from "d3-delaunay";

export interface Node {
  u: number;
  v: number;
  value: number;
}

/** Three corners, or the four of a rectangle: low left, low right, high right, high left. */
export type Patch = Node[];

function levels(values: number[]): number[] {
  const sorted = [...values].sort((a, b) => a - b);
  const least = 1e-6 * (sorted[sorted.length - 1] - sorted[0]);
  return sorted.filter((value, at) => at === 0 || value - sorted[at - 1] > least);
}

function nearestLevel(all: number[], value: number): number {
  return all.reduce((best, level, at) => (Math.abs(level - value) < Math.abs(all[best] - value) ? at : best), 0);
}

/** Whether there is an area at all: places of a grid, or scattered both ways. */
export function spreadsOut(places: { u: number; v: number }[]): boolean {
  const [columns, rows] = [levels(places.map((place) => place.u)).length, levels(places.map((place) => place.v)).length];
  const isGrid = columns > 1 && rows > 1 && places.length > 0.6 * columns * rows;
  return isGrid || (columns > 2 && rows > 2);
}

/** Cells of the grid that the nodes stand on, whole or half where a corner is missing; undefined: no grid. */
function gridPatches(nodes: Node[], places: { u: number; v: number }[]): Patch[] | undefined {
  const columns = levels(places.map((place) => place.u));
  const rows = levels(places.map((place) => place.v));
  const isGrid = columns.length > 1 && rows.length > 1 && places.length > 0.6 * columns.length * rows.length;
  if (!isGrid) return undefined;
  const at = new Map(nodes.map((node) => [nearestLevel(columns, node.u) + columns.length * nearestLevel(rows, node.v), node]));
  const patches: Patch[] = [];
  for (let row = 0; row + 1 < rows.length; ++row)
    for (let column = 0; column + 1 < columns.length; ++column) {
      const place = column + columns.length * row;
      const corners = [place, place + 1, place + 1 + columns.length, place + columns.length].map((one) => at.get(one));
      const present = corners.filter((corner) => corner !== undefined);
      if (present.length >= 3) patches.push(present);
    }
  return patches;
}

function trianglePatches(nodes: Node[]): Patch[] {
  const { triangles } = Delaunay.from(nodes, (node) => node.u, (node) => node.v);
  const patches: Patch[] = [];
  for (let at = 0; at < triangles.length; at += 3) {
    const [a, b, c] = [nodes[triangles[at]], nodes[triangles[at + 1]], nodes[triangles[at + 2]]];
    const area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    if (Math.abs(area) > 1e-9) patches.push(area > 0 ? [a, b, c] : [a, c, b]);
  }
  return patches;
}

/** `places` are those of all runs, also of those that have no value. */
export function patchesOf(nodes: Node[], places: { u: number; v: number }[]): Patch[] {
  if (!spreadsOut(places)) return [];
  return gridPatches(nodes, places) ?? (nodes.length >= 3 ? trianglePatches(nodes) : []);
}

function inRectangle([low, right, high, left]: Patch, u: number, v: number): number {
  const [s, t] = [(u - low.u) / (high.u - low.u), (v - low.v) / (high.v - low.v)];
  const over = 1 + 1e-9;
  if (s < 1 - over || s > over || t < 1 - over || t > over) return NaN;
  return (1 - t) * ((1 - s) * low.value + s * right.value) + t * ((1 - s) * left.value + s * high.value);
}

function inTriangle([a, b, c]: Patch, u: number, v: number): number {
  const area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
  const second = ((u - a.u) * (c.v - a.v) - (v - a.v) * (c.u - a.u)) / area;
  const third = ((b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u)) / area;
  const first = 1 - second - third;
  const least = -1e-9;
  if (first < least || second < least || third < least) return NaN;
  return first * a.value + second * b.value + third * c.value;
}

/** Values at size x size places from 0 to 1, rows upwards; NaN where no patch is. */
export function raster(patches: Patch[], size: number): Float64Array {
  const values = new Float64Array(size * size).fill(NaN);
  const steps = size - 1;
  for (const patch of patches) {
    const [us, vs] = [patch.map((node) => node.u * steps), patch.map((node) => node.v * steps)];
    const inside = patch.length === 4 ? inRectangle : inTriangle;
    for (let row = Math.ceil(Math.min(...vs) - 1e-9); row <= Math.max(...vs) + 1e-9; ++row)
      for (let column = Math.ceil(Math.min(...us) - 1e-9); column <= Math.max(...us) + 1e-9; ++column) {
        const value = inside(patch, Math.min(1, column / steps), Math.min(1, row / steps));
        if (!Number.isNaN(value)) values[row * size + column] = value;
      }
  }
  return values;
}

/** Puts the mean of the neighbours where there is no value beside one: what is drawn is clipped to the patches. */
export function grown(values: Float64Array, size: number): Float64Array {
  const result = values.slice();
  for (let row = 0; row < size; ++row)
    for (let column = 0; column < size; ++column) {
      if (!Number.isNaN(values[row * size + column])) continue;
      let [sum, count] = [0, 0];
      for (let j = Math.max(0, row - 1); j <= Math.min(size - 1, row + 1); ++j)
        for (let i = Math.max(0, column - 1); i <= Math.min(size - 1, column + 1); ++i) {
          const value = values[j * size + i];
          if (!Number.isNaN(value)) [sum, count] = [sum + value, count + 1];
        }
      if (count > 0) result[row * size + column] = sum / count;
    }
  return result;
}
