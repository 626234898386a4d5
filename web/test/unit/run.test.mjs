// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";

import { readCurves } from "../../.unit/curve_data.js";
import { extentOf, imagesOf, withImages } from "../../.unit/extent.js";
import { readJson, readRun } from "../../.unit/run.js";
import { sampleRun } from "../sample_run.mjs";

const sample = sampleRun(3);
const changed = (change) => {
  const copy = structuredClone(sample);
  change(copy);
  return copy;
};

test("the samples are runs", () => {
  const run = readRun(sample);
  assert.equal(run.frames.length, 12);
  assert.equal(run.live, false);
  readCurves(sample.curves);
});

test("rigid bodies are ghosts in 3D, unless the run says otherwise", () => {
  const faint = (run) => readRun(run).categories.map((category) => category.faint);
  assert.deepEqual(faint(sample), [false, false, false, true]);
  assert.deepEqual(faint(sampleRun(2)), [false, false, false, false]);
  assert.deepEqual(faint(changed((run) => (run.categories[3].faint = false))), [false, false, false, false]);
});

test("what is wrong is named", () => {
  const cases = [
    [(run) => (run.dimension = 4), /dimension should be 2 or 3/],
    [(run) => delete run.title, /title should be a text/],
    [(run) => (run.minimum = [0, 0]), /minimum should be three numbers/],
    [(run) => (run.maximum[1] = run.minimum[1]), /maximum\[1\] should be above the minimum/],
    [(run) => (run.categories[1].colour = "red"), /categories\[1\]\.colour should be like/],
    [(run) => (run.spacings[0] = null), /spacings\[0\] should be a finite number/],
    [(run) => (run.fields[2].unit = 1), /fields\[2\]\.unit should be a text/],
    [(run) => (run.fields[0].maximum = -1), /fields\[0\]\.maximum should be no less/],
    [(run) => (run.frames[5].count = 1.5), /frames\[5\]\.count should be a whole number/],
    [(run) => delete run.frames[3].data, /frames\[3\]\.data or \.url should be a text/],
    [(run) => (run.frames[3].ranges = []), /frames\[3\]\.ranges should be one for each of 4 fields/],
  ];
  for (const [change, words] of cases) assert.throws(() => readRun(changed(change)), words);
});

test("wrong curves are named", () => {
  const cases = [
    [(run) => run.curves.groups[1].series[2].values.pop(), /groups\[1\]\.series\[2\]\.values \(lost to fracture\) should be 400 values/],
    [(run) => (run.curves.groups[0].series[0].values[7] = "x"), /values\[7\] should be a finite number/],
    [(run) => (run.curves.time[3] = -1), /time\[3\] should be no less than the time before/],
    [(run) => delete run.curves.marks[0].label, /marks\[0\]\.label should be a text/],
  ];
  for (const [change, words] of cases) assert.throws(() => readCurves(changed(change).curves), words);
});

test("text that is no JSON is named", () => {
  assert.throws(() => readJson("{"), /no JSON/);
  assert.throws(() => readJson("[]"), /an object/);
});

test("the extent leaves out what flies ahead, but no category as a whole", () => {
  const count = 1000;
  const x = new Uint16Array(count).fill(30000);
  const categories = new Uint8Array(count);
  x[0] = 65535; // one stray particle of many
  x[1] = 0; // all there is of another category
  categories[1] = 1;
  const particles = { count, places: [x, x], categories };
  const box = extentOf(particles, { minimum: [0, 0, 0], maximum: [65535, 65535, 0], mirrors: [] });
  assert.ok(Math.abs(box.minimum[0]) < 1e-6 && Math.abs(box.maximum[0] - 30000) < 1e-6);
});

test("planes of symmetry give a half its other half, a quarter its other three", () => {
  const half = [{ axis: 0, place: 1 }];
  const quarter = [...half, { axis: 2, place: 5 }];
  const box = { minimum: [1, 0, 3], maximum: [4, 2, 5] };
  assert.deepEqual(withImages(box, half), { minimum: [-2, 0, 3], maximum: [4, 2, 5] });
  assert.deepEqual(withImages(box, quarter), { minimum: [-2, 0, 3], maximum: [4, 2, 7] });
  assert.deepEqual(imagesOf([]), [[0, 0, 0]]);
  assert.deepEqual(imagesOf(half), [[0, 0, 0], [1, 0, 0]]);
  assert.deepEqual(imagesOf(quarter), [[0, 0, 0], [1, 0, 0], [0, 0, 1], [1, 0, 1]]);
});
