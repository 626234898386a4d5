// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";

import { formatCount, formatNumber, formatQuantity, roundLength, roundTicks, timeFormat } from "../../.unit/quantities.js";

const thin = "\u202f";

test("prefixes are chosen by size", () => {
  const cases = [
    [0, "s", `0${thin}s`],
    [0.00123, "s", `1.23${thin}ms`],
    [4.5e-8, "s", `45${thin}ns`],
    [-2.5e-6, "m", `−2.5${thin}µm`],
    [1.25e6, "Pa", `1.25${thin}MPa`],
    [3e9, "Pa", `3${thin}GPa`],
    [999.96, "N", `1${thin}kN`],
    [4200, "J/m", `4.2${thin}kJ/m`],
    [0.5, "N s", `500${thin}mN s`],
    [59, "s", `59${thin}s`],
    [200, "s", `3${thin}min 20${thin}s`],
    [3900, "s", `1${thin}h 05${thin}min`],
    [12.3 * 86400, "s", `12${thin}days`],
    [2.5 * 365.25 * 86400, "s", `2.5${thin}years`],
  ];
  for (const [value, unit, words] of cases) assert.equal(formatQuantity(value, unit), words);
});

test("units that bear no prefix keep the number", () => {
  const cases = [
    [1500, "m/s", `1500${thin}m/s`],
    [0.012, "kg", `0.012${thin}kg`],
    [0.012, "mm", `0.012${thin}mm`],
    [2000, "Pa²", `2000${thin}Pa²`],
    [0.25, "1", "0.25"],
    [0.25, "", "0.25"],
    [0.02, "%", `0.02${thin}%`],
  ];
  for (const [value, unit, words] of cases) assert.equal(formatQuantity(value, unit), words);
});

test("very large and very small numbers are written as powers", () => {
  assert.equal(formatNumber(1.234e-7), "1.23·10⁻⁷");
  assert.equal(formatNumber(-9.999e9), "−1·10¹⁰");
  assert.equal(formatNumber(Number.NaN), "—");
});

test("counts are set in groups of three", () => {
  assert.equal(formatCount(999), "999");
  assert.equal(formatCount(1234567), `1${thin}234${thin}567`);
});

test("all times of a run are written alike, and differ", () => {
  const times = Array.from({ length: 12 }, (_, at) => at * 0.25e-3);
  const format = timeFormat(times);
  assert.equal(format(0), `0.00${thin}ms`);
  assert.equal(format(2.75e-3), `2.75${thin}ms`);
  const even = Array.from({ length: 41 }, (_, at) => at * 5e-6);
  assert.equal(new Set(even.map(timeFormat(even))).size, 41);
  assert.equal(timeFormat([])(0), `0${thin}s`);
});

test("round lengths do not exceed the limit", () => {
  const cases = [[0.0173, 0.01], [0.02, 0.02], [7, 5], [0.00099, 0.0005]];
  for (const [limit, length] of cases) assert.ok(Math.abs(roundLength(limit) / length - 1) < 1e-12);
});

test("ticks are round, inside, and hold zero", () => {
  assert.deepEqual(roundTicks(0, 52.3, 4), [0, 10, 20, 30, 40, 50]);
  assert.deepEqual(roundTicks(-0.4e6, 1.25e6, 4), [0, 500000, 1000000]);
  assert.deepEqual(roundTicks(0, 1, 4), [0, 0.2, 0.4, 0.6, 0.8, 1]);
  assert.deepEqual(roundTicks(3, 3, 4), [3]);
  for (const maximum of [1e-9, 0.37, 1, 99, 4.7e8]) {
    const ticks = roundTicks(-maximum, maximum, 4);
    assert.ok(ticks.includes(0) && ticks.length >= 2 && ticks.length <= 6, `${maximum}: ${ticks}`);
  }
});
