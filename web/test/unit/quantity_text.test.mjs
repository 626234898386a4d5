// SPDX-License-Identifier: Apache-2.0

import assert from "node:assert/strict";
import { test } from "node:test";

import { readQuantity, shows } from "../quantity_text.mjs";

const near = (value, expected) => assert.ok(Math.abs(value - expected) <= 1e-12 * Math.abs(expected), `${value}`);

test("what the report writes is read back", () => {
  near(readQuantity("4.32\u202fmm"), 4.32e-3);
  near(readQuantity("0.5\u202fm"), 0.5);
  near(readQuantity("9.8\u202fm/s"), 9.8);
  near(readQuantity("100\u202fmm/s"), 0.1);
  near(readQuantity("12\u202fms"), 0.012);
  near(readQuantity("-8 · 10<sup>-15</sup>\u202fm"), -8e-15);
  near(readQuantity("1\u202f234\u202f567"), 1234567);
  near(readQuantity("-0.0774\u202f%"), -0.000774);
  near(readQuantity("718.6\u202fL/min/m"), 718.6 / 6e4);
  near(readQuantity("15°"), Math.PI / 12);
  near(readQuantity("117.1\u202fkJ/m³"), 117100);
  near(readQuantity("12.4\u202fmm²"), 1.24e-5);
  near(readQuantity("1\u202fmin 08\u202fs"), 68);
  near(readQuantity("2\u202fh 05\u202fmin"), 7500);
  assert.equal(readQuantity("—"), null);
  assert.throws(() => readQuantity("11.98\u202fmm²²"));
  assert.throws(() => readQuantity("none"));
});

test("a shown number is the rounded one and no other", () => {
  assert.ok(shows("4.32\u202fmm", 0.004322846, 3));
  assert.ok(!shows("4.33\u202fmm", 0.004322846, 3));
  assert.ok(!shows("4.32\u202fm", 0.004322846, 3));
  assert.ok(shows("19.6°", 0.34289671256284293, 3) && !shows("19.7°", 0.34289671256284293, 3));
  assert.ok(shows("1.17 · 10<sup>5</sup>", 117072.07, 4) && !shows("1.18 · 10<sup>5</sup>", 117072.07, 4));
  assert.ok(shows("1 min 08 s", 68.4, 4) && !shows("1 min 08 s", 68.6, 4));
  assert.ok(shows("2 h 05 min", 7559, 4) && !shows("2 h 05 min", 7561, 4));
  assert.ok(shows("—", null, 3) && !shows("0", null, 3) && !shows("—", 0, 3) && shows("0", 0, 3));
});
