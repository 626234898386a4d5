// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";

import { commonFields, commonTimes, frameAt } from "../../.unit/common_ranges.js";

const field = (key, minimum, maximum, names) => ({ key, label: key, unit: "1", minimum, maximum, ...(names && { names }) });
const run = (times, ...fields) => ({ fields, frames: times.map((time) => ({ time, count: 1 })) });

test("a field of both runs spans the values of both", () => {
  const [speed] = commonFields(run([], field("speed", 1, 5)), run([], field("speed", -2, 3)));
  assert.deepEqual([speed.minimum, speed.maximum], [-2, 5]);
});

test("a field that one run lacks is zero there", () => {
  const fields = commonFields(run([], field("speed", 1, 5), field("damage", 0.2, 1)), run([], field("speed", 1, 5), field("stress", -3, -1)));
  assert.deepEqual(fields.map(({ key, minimum, maximum }) => [key, minimum, maximum]), [["speed", 1, 5], ["damage", 0, 1], ["stress", -3, 0]]);
});

test("groups of other names are not compared", () => {
  const first = run([], field("body", 0, 1, ["gel", "table"]), field("material", 0, 1, ["a", "b"]));
  const second = run([], field("body", 0, 1, ["liver", "table"]), field("material", 0, 1, ["a", "b"]));
  assert.deepEqual(commonFields(first, second).map(({ key }) => key), ["material"]);
});

test("a moment shows the nearest frame of each run", () => {
  const first = run([0, 1, 2]), second = run([0, 0.8, 1.6, 2.4]);
  assert.deepEqual(commonTimes(first, second), [0, 0.8, 1, 1.6, 2, 2.4]);
  assert.equal(frameAt(first, 0.8), 1);
  assert.equal(frameAt(first, 2.4), 2);
  assert.equal(frameAt(second, 1), 1);
  assert.equal(frameAt(run([]), 1), -1);
});
