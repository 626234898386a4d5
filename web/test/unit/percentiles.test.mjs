// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";

import { percentileRange, valueOf } from "../../.unit/percentiles.js";

const coded = { minimum: -10, maximum: 245 }; // a byte b is b - 10

test("a percentile leaves out that share at either end", () => {
  const bytes = Uint8Array.from({ length: 200 }, (_, at) => (at < 2 ? 0 : at > 197 ? 255 : 50 + (at % 100)));
  assert.deepEqual(percentileRange(bytes, coded, 0.01), { minimum: 40, maximum: 139 });
  assert.deepEqual(percentileRange(bytes, coded, 0), { minimum: -10, maximum: 245 });
});

test("what is the same everywhere keeps the whole range", () => {
  assert.deepEqual(percentileRange(new Uint8Array(50).fill(7), coded, 0.05), coded);
  assert.deepEqual(percentileRange(new Uint8Array(0), coded, 0.05), coded);
});

test("a byte is a value of the range", () => assert.equal(valueOf(12, coded), 2));
