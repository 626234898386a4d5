// SPDX-License-Identifier: Apache-2.0
// Uses the page of a study as a reader would:
//   node test/study_page.mjs STUDY.html [--screenshot FILE.png]
//   node test/study_page.mjs --samples
// Fails on the first thing that does not do what it should, and on any error or network request.

import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { isAccessible } from "./accessible.mjs";
import { openBrowser, openPage } from "./browser.mjs";
import { studies, writeStudy } from "./study_sample.mjs";

/** What the page was given. */
function dataOf(path) {
  const text = readFileSync(path, "utf8").match(/id="kerf-study-data">(.*?)<\/script>/s)?.[1];
  assert.ok(text, "the page holds no data");
  return JSON.parse(text);
}

async function tableIsRight(page, { study }) {
  const rows = await page.locator("#kerf-runs tbody tr").evaluateAll((list) =>
    list.map((row) => ({ id: row.dataset.run, cells: Object.fromEntries([...row.cells].map((cell) => [cell.dataset.column, cell.dataset.value])) })),
  );
  assert.deepEqual(rows.map((row) => row.id), study.runs.map((run) => run.id));
  const names = await page.locator("#kerf-runs thead th").evaluateAll((list) => list.map((cell) => cell.dataset.column));
  study.runs.forEach((run, at) => {
    const expected = { ...run.metrics, ...run.setting };
    for (const name of names.filter((one) => one in expected && one !== "cut_through")) {
      const value = expected[name];
      assert.equal(rows[at].cells[name], value === null ? undefined : String(value), `${name} of ${run.id}`);
    }
  });
  // What is read is that number in the unit of the head.
  for (const key of study.keys.filter((one) => one.kind !== "words")) {
    const cell = page.locator(`#kerf-runs tbody tr:first-child [data-column="${key.key}"]`);
    const shown = Number((await cell.textContent()).replace("−", "-"));
    const value = study.runs[0].setting[key.key] / key.shown_factor;
    if (Number.isFinite(shown)) assert.ok(Math.abs(shown - value) <= 1e-3 * Math.abs(value), `${key.key}: ${shown} is not ${value}`);
  }
}

async function readsWords(page) {
  const labels = await page.locator("#kerf-x option, #kerf-y option, #kerf-metric option, .kerf-controls label > span").allTextContents();
  const keys = labels.filter((label) => /[a-z]{2,}[._][a-z]/.test(label)); // a symbol such as ρ_s is no key
  assert.deepEqual(keys, [], "menus have keys instead of words");
}

// The words are those that the program has made from the schema of keys.
async function explainsItsSettings(page, { study, labels, help }) {
  const terms = await page.locator("#kerf-meanings dt").allTextContents();
  const words = await page.locator("#kerf-meanings dd").allTextContents();
  study.keys.forEach(({ key }, at) => {
    assert.ok(terms[at].startsWith(labels[key]), `${key} is called ${terms[at]}`);
    assert.ok(help[key].length > 10 && words[at].startsWith(help[key]), `${key}: ${words[at]}`);
  });
  const heads = await page.locator("#kerf-runs th").evaluateAll((list) => list.map((one) => [one.dataset.column, one.textContent]));
  for (const { key } of study.keys) assert.ok(heads.some(([column, title]) => column === key && title.startsWith(labels[key])), key);
}

async function sorts(page, { study }) {
  const key = study.keys.find((one) => one.kind !== "words");
  const head = page.locator(`#kerf-runs th[data-column="${key.key}"]`);
  const numbers = () => page.locator(`#kerf-runs td[data-column="${key.key}"]`).evaluateAll((cells) => cells.map((cell) => Number(cell.dataset.value)));
  const ascending = [...(await numbers())].sort((a, b) => a - b);
  await head.locator("button").click();
  assert.equal(await head.getAttribute("aria-sort"), "ascending");
  assert.deepEqual(await numbers(), ascending);
  await head.locator("button").focus();
  await page.keyboard.press("Enter");
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  assert.deepEqual(await numbers(), ascending.reverse());
}

async function linksLead(page, { study }, path) {
  const links = await page.locator(".kerf-study a").evaluateAll((list) => list.map((link) => link.getAttribute("href")));
  const done = study.runs.filter((run) => run.report);
  for (const { report } of done) assert.ok(links.includes(report), `nothing leads to ${report}`);
  for (const link of links) assert.ok(existsSync(join(dirname(path), link)), `${link} is not there`);
}

const look = (page, place) => page.locator(`${place} svg path, ${place} svg rect`).evaluateAll((list) => list.map((one) => `${one.getAttribute("d")} ${one.getAttribute("fill")}`).join());

async function choosesMetric(page) {
  const map = (await page.locator("#kerf-map svg").first().isVisible()) ? "#kerf-map" : "#kerf-curve";
  const metrics = await page.locator("#kerf-metric option").evaluateAll((options) => options.map((one) => one.value));
  const first = await page.locator("#kerf-metric").inputValue();
  const before = await look(page, map);
  const other = metrics.find((name) => name !== first && name !== "cut_through");
  for (const name of [other, "cut_through"]) {
    await page.locator("#kerf-metric").selectOption(name);
    assert.notEqual(await look(page, map), before, `${name} looks like ${first}`);
  }
  if (map === "#kerf-map") assert.ok((await page.locator("#kerf-map path[fill='#8fc7ec']").count()) > 0, "there is no region of cut-through");
  await page.reload();
  assert.equal(await page.locator("#kerf-metric").inputValue(), "cut_through", "the choice is not in the address");
  await page.locator("#kerf-metric").selectOption(first);
  assert.equal(await look(page, map), before, "the first look does not come back");
}

async function choosesAxes(page) {
  if ((await page.locator("#kerf-x").count()) === 0) return;
  const [x, y] = [await page.locator("#kerf-x").inputValue(), await page.locator("#kerf-y").inputValue()];
  await page.locator("#kerf-x").selectOption(y);
  assert.equal(await page.locator("#kerf-y").inputValue(), x, "the axes do not change places");
  await page.locator("#kerf-x").selectOption(x);
  const contours = await look(page, "#kerf-map");
  await page.locator("#kerf-style").selectOption("cells");
  assert.notEqual(await look(page, "#kerf-map"), contours, "cells look like contours");
  await page.locator("#kerf-style").selectOption("contours");
}

async function tellsOfPoints(page, { study }) {
  const marks = page.locator("#kerf-curve .kerf-mark");
  assert.ok((await marks.count()) > 0, "the curve has no points");
  await marks.first().focus();
  assert.ok(await page.locator("#kerf-curve .kerf-tooltip").isVisible(), "the focus does not tell of the point");
  for (const label of await page.locator(".kerf-mark").evaluateAll((list) => list.map((one) => one.getAttribute("aria-label")))) assert.ok(label);
  const answers = (study.search ? 1 : 0) + (study.calibration ? 1 : 0) + (study.model ? 1 : 0);
  assert.equal(await page.locator(".kerf-answer").count(), answers);
}

async function printsAndSaves(page) {
  const waiting = page.waitForEvent("download");
  await page.locator(".kerf-save").first().click();
  assert.match((await waiting).suggestedFilename(), /\.svg$/);
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.locator(".kerf-controls").isHidden(), "controls are printed");
  assert.ok(await page.locator("#kerf-curve svg[id]").isVisible());
  await page.emulateMedia({ media: "screen" });
}

async function fitsNarrow(page) {
  await page.setViewportSize({ width: 360, height: 700 });
  // The drawings follow the width, on a loaded machine after a moment.
  const excess = () => document.documentElement.scrollWidth - document.documentElement.clientWidth;
  await page.waitForFunction(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth, undefined, { timeout: 10000 }).catch(() => {});
  assert.ok((await page.evaluate(excess)) <= 0, `the page is ${await page.evaluate(excess)} px too wide`);
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.waitForTimeout(150);
}

export async function useStudy(path, screenshot) {
  const browser = await openBrowser({ webGl: false });
  try {
    const data = dataOf(path);
    const { page, faults } = await openPage(browser, resolve(path));
    if (screenshot) await page.screenshot({ path: screenshot, fullPage: true });
    for (const part of [tableIsRight, linksLead, choosesMetric, choosesAxes, tellsOfPoints, printsAndSaves, fitsNarrow, sorts, readsWords, explainsItsSettings, isAccessible]) {
      await part(page, data, resolve(path));
      const unwanted = faults.filter((fault) => !fault.startsWith(`request: file://${resolve(path)}#`)); // loaded again
      assert.deepEqual(unwanted, [], `after "${part.name}"`);
    }
  } finally {
    await browser.close();
  }
}

/** What is wrong in the data is said, and the static part stays. */
async function saysWhatIsWrong(folder) {
  const browser = await openBrowser({ webGl: false });
  try {
    const content = studies.grid();
    delete content.study.runs[3].setting;
    for (const [json, words] of [['{"study": ', /JSON/], [undefined, /the setting of a run should be an object/]]) {
      const { page, faults } = await openPage(browser, writeStudy(join(folder, "wrong"), content, json));
      assert.match(await page.locator("#kerf-study > .kerf-message").textContent(), words);
      assert.ok(await page.getByText("static part").isVisible());
      assert.deepEqual(faults, []);
    }
  } finally {
    await browser.close();
  }
}

export async function useSampleStudies(folder) {
  for (const [name, make] of Object.entries(studies)) await useStudy(writeStudy(join(folder, name), make()));
  await saysWhatIsWrong(folder);
}

async function useSamplesApart() {
  const folder = mkdtempSync(join(tmpdir(), "kerf-studies-"));
  try {
    await useSampleStudies(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [path, flag, screenshot] = process.argv.slice(2);
  if (path === "--samples") {
    await useSamplesApart();
    process.exit(0);
  }
  if (!path || (flag && flag !== "--screenshot")) {
    console.error("usage: node test/study_page.mjs STUDY.html [--screenshot FILE.png]");
    process.exit(2);
  }
  await useStudy(path, screenshot);
  console.log(`${path}: as it should be`);
}
