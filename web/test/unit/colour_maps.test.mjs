// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";

import { colourOf, colourTable, groupColour, isSigned, parseColour } from "../../.unit/colour_maps.js";

// Relative luminance, as for the contrast of text (WCAG 2).
function luminance(colour) {
  const [red, green, blue] = colour.map((part) => {
    const share = part / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
const along = (range, steps = 64) =>
  Array.from({ length: steps + 1 }, (_, at) =>
    luminance(colourOf(range.minimum + (at / steps) * (range.maximum - range.minimum), range)),
  );
const grows = (values) => values.every((value, at) => at === 0 || value > values[at - 1]);

test("one-sided: lightness alone tells the order", () => {
  assert.ok(grows(along({ minimum: 0, maximum: 52.3 })));
});

test("signed: darker away from zero, blue below and red above", () => {
  const values = along({ minimum: -1, maximum: 1 });
  assert.ok(grows(values.slice(0, 33)) && grows(values.slice(32).reverse()));
  const range = { minimum: -2, maximum: 2 };
  const [low, high] = [colourOf(-2, range), colourOf(2, range)];
  assert.ok(low[2] > 2 * low[0] && high[0] > 2 * high[2]);
  // The green parts are alike, so that it does not matter whether they are seen.
  assert.ok(Math.abs(low[1] - high[1]) < 40);
});

test("signed: zero is in the middle of the map, however uneven the range", () => {
  for (const range of [{ minimum: -1, maximum: 100 }, { minimum: -50, maximum: 2 }]) {
    assert.ok(isSigned(range));
    const [red, green, blue] = colourOf(0, range);
    assert.ok(red === green && green === blue);
  }
  assert.ok(!isSigned({ minimum: 0, maximum: 1 }));
});

test("a table holds the colours of what its bytes mean", () => {
  const shown = { minimum: 0, maximum: 10 };
  const own = colourTable(shown, shown);
  assert.equal(own.length, 1024);
  assert.deepEqual([...own.slice(0, 4)], [...colourOf(0, shown), 255]);
  assert.deepEqual([...own.slice(-4)], [...colourOf(10, shown), 255]);
  const half = colourTable({ minimum: 0, maximum: 5 }, shown);
  assert.deepEqual([...half.slice(-4, -1)], colourOf(5, shown));
});

test("values beyond the range take the colours of its ends; an empty range is no error", () => {
  const range = { minimum: 0, maximum: 1 };
  assert.deepEqual(colourOf(7, range), colourOf(1, range));
  assert.deepEqual(colourOf(-7, range), colourOf(0, range));
  assert.ok(colourOf(3, { minimum: 3, maximum: 3 }).every(Number.isFinite));
});

test("colours are read", () => assert.deepEqual(parseColour("#5cc48a"), [0x5c, 0xc4, 0x8a]));

test("groups have colours of their own", () => {
  const names = ["block", "plate", "jet"];
  const shown = { minimum: 0, maximum: 2, names };
  const table = colourTable({ minimum: 0, maximum: 2 }, shown);
  const at = (byte) => [...table.slice(4 * byte, 4 * byte + 3)];
  assert.deepEqual([at(0), at(128), at(255)], names.map((_, number) => groupColour(number)));
  assert.equal(new Set(names.map((_, number) => String(groupColour(number)))).size, 3);
});
