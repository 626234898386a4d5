// SPDX-License-Identifier: Apache-2.0
// What a report says is what result.json and case.used.toml beside it say.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";

import { shows } from "./quantity_text.mjs";

const valueAt = (result, key) => key.split(".").reduce((part, name) => part?.[name], result);

function checkNumber(shown, value, digits, what) {
  assert.ok(shows(shown, value, digits), `${what}: the page says ${shown}, result.json ${value}`);
}

async function verdict(page, result) {
  assert.equal(await page.locator("h1").textContent(), result.title);
  assert.equal(await page.locator(".verdict span").textContent(), result.verdict);
  const through = await page.locator(".verdict").evaluate((one) => one.classList.contains("yes"));
  assert.equal(through, result.cut_through);
}

// Every number that names its key. Shares and angles have three digits everywhere.
async function keys(page, result) {
  const shown = await page.locator("[data-key]").evaluateAll((all) =>
    all.map((one) => ({ key: one.dataset.key, html: one.innerHTML, text: one.textContent, isTable: one.tagName === "TD" })),
  );
  for (const { key, html, text, isTable } of shown) {
    const value = valueAt(result, key);
    assert.notEqual(value, undefined, `result.json has no ${key}`);
    if (typeof value === "string") assert.equal(text, value, key);
    else checkNumber(html, value, isTable && !/[%°]$/.test(html) ? 4 : 3, key);
  }
  const levels = ["depth", "top.width", "middle.width", "bottom.width", "taper"];
  const wanted = ["cut_through_time", "front_speed", "front_depth", "kerf_width", "regime", "energy_drift", "pieces"]
    .concat(["kerf", "opening"].flatMap((shape) => levels.map((level) => `${shape}.${level}`)))
    .concat(Object.entries(result.machine ?? {}).filter(([, one]) => typeof one === "number").map(([name]) => `machine.${name}`));
  const found = new Set(shown.map((one) => one.key));
  assert.deepEqual(wanted.filter((key) => !found.has(key)), [], "numbers that the page does not show");
}

async function flags(page, result) {
  const shown = await page.locator("ul.validity li").evaluateAll((all) =>
    all.map((one) => ({ state: one.className, sentence: one.querySelector("span").textContent })),
  );
  assert.deepEqual(shown, result.validity.map(({ state, sentence }) => ({ state, sentence })));
}

async function drawing(page, result) {
  const { kerf } = result;
  const isParted = result.cut_through && !kerf.through && !(kerf.through_share > 0);
  const figures = await page.locator("figure.kerf").count();
  assert.equal(figures, kerf.thickness > 0 && (kerf.depth > 0 || isParted) ? 1 : 0);
  if (figures === 0) return;
  const words = await page.locator("figure.kerf svg text").evaluateAll((all) => all.map((one) => one.textContent));
  for (const name of ["depth", "thickness"]) {
    const label = words.find((one) => one.startsWith(`${name} `));
    if (kerf[name] > 0) checkNumber(label.slice(name.length + 1), kerf[name], 3, `the drawing's ${name}`);
  }
  const shown = words.filter((one) => one.includes(" at ")).map((one) => one.split(" at "));
  const levels = [kerf.top, kerf.middle, kerf.bottom].filter(
    (level, at, all) => level.width > 0 && all.findIndex((other) => other.below === level.below) === at,
  );
  assert.equal(shown.length, levels.length, "levels of the drawing");
  levels.forEach(({ width, below }, at) => {
    checkNumber(shown[at][0], width, 3, "a width of the drawing");
    checkNumber(shown[at][1], below, 3, "its depth");
  });
  assert.equal(await page.locator("figure.kerf [data-line=crack]").count(), isParted ? 1 : 0, "cracks of the drawing");
}

async function usedCase(page, folder) {
  const part = page.locator("details.case");
  assert.equal(await part.getAttribute("open"), null, "the case is not folded");
  assert.equal(await part.locator("pre").textContent(), readFileSync(join(folder, "case.used.toml"), "utf8"));
  await page.pdf();
  assert.ok(await part.locator("pre").isVisible(), "the case is not printed");
}

export async function checkNumbers(page, resultPath) {
  const result = JSON.parse(readFileSync(resultPath, "utf8"));
  for (const part of [verdict, keys, flags, drawing]) await part(page, result);
  await usedCase(page, dirname(resultPath));
}
