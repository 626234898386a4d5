// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";

import { grown, patchesOf, raster, spreadsOut } from "../../.unit/study/patches.js";

const size = 41;
const steps = size - 1;
const plane = (u, v) => 3 + 2 * u - 5 * v; // which both ways of interpolating keep
const nodeAt = (u, v, value = plane(u, v)) => ({ u, v, value });
const gridOf = (us, vs) => vs.flatMap((v) => us.map((u) => nodeAt(u, v)));
const known = (nodes, places = nodes) => raster(patchesOf(nodes, places), size);

function isPlane(values, whole) {
  let count = 0;
  values.forEach((value, at) => {
    if (Number.isNaN(value)) return;
    ++count;
    assert.ok(Math.abs(value - plane((at % size) / steps, Math.floor(at / size) / steps)) < 1e-9);
  });
  if (whole) assert.equal(count, size * size);
  return count;
}

test("a plane stays a plane on an uneven grid, and is known to its edges", () => {
  isPlane(known(gridOf([0, 0.3, 1], [0, 0.45, 0.7, 1])), true);
});

test("in a cell of a grid the value is bilinear", () => {
  const corners = [nodeAt(0, 0, 0), nodeAt(1, 0, 0), nodeAt(0, 1, 0), nodeAt(1, 1, 1)];
  const values = known(corners);
  assert.ok(Math.abs(values[10 * size + 20] - 0.25 * 0.5) < 1e-12);
});

test("a cell that lacks a corner is known to its half", () => {
  const places = gridOf([0, 1], [0, 1]);
  const count = isPlane(known(places.slice(0, 3), places), false);
  assert.equal(count, (size * (size + 1)) / 2);
});

test("between scattered places a plane stays a plane, and beyond them nothing is known", () => {
  const nodes = [nodeAt(0.1, 0), nodeAt(1, 0.2), nodeAt(0.4, 1), nodeAt(0.5, 0.4), nodeAt(0.2, 0.55)];
  assert.ok(spreadsOut(nodes));
  const values = known(nodes);
  assert.ok(isPlane(values, false) > 0.3 * size * size);
  assert.ok(Number.isNaN(values[0]) && Number.isNaN(values[size * size - 1]));
});

test("two places, and places in a row, make no area", () => {
  assert.equal(patchesOf([nodeAt(0, 0), nodeAt(1, 1)], []).length, 0);
  const row = [nodeAt(0, 0), nodeAt(0.5, 0), nodeAt(1, 0)];
  assert.equal(patchesOf(row, row).length, 0);
  assert.ok(!spreadsOut([...row, nodeAt(0.1, 1), nodeAt(0.7, 1), nodeAt(0.9, 1)]), "two rows that do not match are no map");
});

test("growing keeps what is known and reaches one place further", () => {
  const values = new Float64Array(9).fill(NaN);
  values[0] = 4;
  assert.deepEqual([...grown(values, 3)], [4, 4, NaN, 4, 4, NaN, NaN, NaN, NaN]);
});
