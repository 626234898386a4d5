// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateRawSync, deflateSync } from "node:zlib";

import { frameLength, loadFrame } from "../../.unit/frames.js";
import { pack, sampleRun } from "../sample_run.mjs";

// Two particles, written out by hand.
const bytes3d = [
  ...[0x00, 0x00, 0xff, 0xff], // x: 0, 65535
  ...[0x01, 0x00, 0x00, 0x01], // y: 1, 256
  ...[0x34, 0x12, 0x02, 0x00], // z: 0x1234, 2
  ...[3, 0], // category
  ...[1, 2], // size
  ...[255, 128], // the field
];
const run = (dimension) => ({ dimension, fields: [{ key: "speed" }] });
const zlib = (bytes, pack = deflateSync) => pack(Buffer.from(bytes)).toString("base64");

test("a frame in 3D is read as it was written", async () => {
  const particles = await loadFrame({ time: 0, count: 2, data: zlib(bytes3d) }, run(3));
  assert.deepEqual(particles.places.map((along) => [...along]), [[0, 65535], [1, 256], [0x1234, 2]]);
  assert.deepEqual([...particles.categories], [3, 0]);
  assert.deepEqual([...particles.sizes], [1, 2]);
  assert.deepEqual(particles.values.map((values) => [...values]), [[255, 128]]);
});

test("a frame in 2D has no z", async () => {
  const bytes = [...bytes3d.slice(0, 8), ...bytes3d.slice(12)];
  const particles = await loadFrame({ time: 0, count: 2, data: zlib(bytes) }, run(2));
  assert.equal(particles.places.length, 2);
  assert.deepEqual([...particles.values[0]], [255, 128]);
});

test("an empty frame is a frame", async () => {
  const particles = await loadFrame({ time: 0, count: 0, data: zlib([]) }, run(3));
  assert.equal(particles.count, 0);
});

test("wrong lengths are refused, with both numbers", async () => {
  for (const count of [1, 3]) {
    const expected = frameLength(count, 3, 1);
    const reading = loadFrame({ time: 0, count, data: zlib(bytes3d) }, run(3));
    await assert.rejects(reading, new RegExp(`18 bytes, where ${count} particles .* take ${expected}`));
  }
});

test("what is not zlib is refused", async () => {
  const raw = zlib(bytes3d, deflateRawSync);
  const torn = zlib(bytes3d).slice(0, 16);
  for (const data of [raw, torn, "AAAA"])
    await assert.rejects(loadFrame({ time: 0, count: 2, data }, run(3)), /zlib/);
});

test("the sample's frames hold what was packed", async () => {
  const sample = sampleRun(2);
  const particles = [{ place: [0.025, -0.014, 0], category: 2, size: 1, values: [52.3, 0, 0.5, 2] }];
  const data = pack(particles, sample).toString("base64");
  const read = await loadFrame({ time: 0, count: 1, data }, sample);
  assert.deepEqual(read.places.map((along) => along[0]), [65535, 0]);
  assert.deepEqual(read.values.map((values) => values[0]), [255, Math.round((255 * 0.4) / 1.65), 128, 255]);
});
