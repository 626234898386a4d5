// SPDX-License-Identifier: Apache-2.0
// Uses a report as a reader would:
//   node test/page.mjs REPORT.html [--result result.json] [--screenshot FILE.png]
// Fails on the first thing that does not do what it should, on any error or network request, and on any
// number that is not that of the result.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";

import { isAccessible } from "./accessible.mjs";
import { openBrowser, openPage } from "./browser.mjs";
import { checkNumbers } from "./numbers.mjs";

const hash = (bytes) => createHash("sha256").update(bytes).digest("hex");

/** The particles alone. */
function snapshot(page) {
  const style = ".kerf-scale, .kerf-axes, .kerf-hint, .kerf-value { visibility: hidden }";
  return page.locator("#kerf-stage canvas").screenshot({ style });
}

/** Of the picture, once nothing is drawn any more. */
async function picture(page) {
  let last = hash(await snapshot(page));
  for (let tries = 0; tries < 20; ++tries) {
    await page.waitForTimeout(60);
    const next = hash(await snapshot(page));
    if (next === last) return next;
    last = next;
  }
  throw new Error("the picture does not come to rest");
}

/** Counts colours in the page itself, from a picture of the canvas. */
async function colourCount(page) {
  const bytes = await snapshot(page);
  return page.evaluate(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, `data:image/png;base64,${bytes.toString("base64")}`);
}

const frameIs = (page, index) => page.waitForSelector(`#kerf-stage[data-frame="${index}"]`);
const text = (page, selector) => page.locator(selector).textContent();

async function draws(page) {
  await page.waitForSelector("#kerf-stage[data-frame]");
  assert.ok((await colourCount(page)) > 3, "the canvas is all but uniform");
  assert.ok(await page.locator("#kerf-viewer > .kerf-fallback").isHidden(), "the still pictures are still there");
}

async function plays(page) {
  const last = Number(await page.locator("#kerf-frame").getAttribute("max"));
  if (last < 1) return;
  await page.locator("#kerf-frame").fill("0");
  await frameIs(page, 0);
  const [before, drawnBefore] = [await text(page, "#kerf-time"), await picture(page)];
  await page.locator("#kerf-play").click();
  await page.waitForFunction((old) => document.querySelector("#kerf-time").textContent !== old, before);
  assert.equal(await page.locator("#kerf-play").getAttribute("aria-label"), "Pause");
  if (last > 2) await page.locator("#kerf-play").click();
  await page.locator("#kerf-frame").fill(String(last));
  await frameIs(page, last);
  assert.notEqual(await picture(page), drawnBefore, "scrubbing does not change the picture");
  await page.locator("#kerf-stage").focus();
  await page.keyboard.press("ArrowLeft");
  await frameIs(page, last - 1);
  await page.keyboard.press("End");
  await frameIs(page, last);
  await page.keyboard.press(" ");
  assert.equal(await page.locator("#kerf-play").getAttribute("aria-label"), "Pause", "space does not play");
  await page.keyboard.press(" ");
  await page.locator("#kerf-frame").fill(String(last));
  await frameIs(page, last);
}

async function colours(page) {
  const keys = await page.locator("#kerf-colour option").evaluateAll((options) => options.map((one) => one.value));
  const material = await picture(page);
  let legend = await text(page, "#kerf-legend");
  for (const key of keys.slice(1)) {
    await page.locator("#kerf-colour").selectOption(key);
    const [nextDrawn, nextLegend] = [await picture(page), await text(page, "#kerf-legend")];
    assert.notEqual(nextDrawn, material, `colouring by ${key} does not change the picture`);
    assert.notEqual(nextLegend, legend, `colouring by ${key} does not change the legend`);
    legend = nextLegend;
  }
  await page.locator("#kerf-colour").selectOption(keys[0]);
}

async function namesGroups(page) {
  await page.locator("#kerf-colour").selectOption("body");
  assert.ok(await page.locator("#kerf-range").isHidden(), "names have a range");
  const names = await page.locator("#kerf-legend li").allTextContents();
  assert.ok(names.length > 1, "the bodies have no names");
  const colours = await page.locator("#kerf-legend li i").evaluateAll((all) => all.map((one) => one.style.background));
  assert.equal(new Set(colours).size, names.length, "bodies share a colour");
}

async function narrowsColours(page) {
  await page.locator("#kerf-colour").selectOption("speed");
  const [whole, words] = [await picture(page), await text(page, "#kerf-legend")];
  await page.locator("#kerf-range").selectOption("0.05");
  assert.notEqual(await text(page, "#kerf-legend"), words, "percentiles do not change the legend");
  assert.notEqual(await picture(page), whole, "percentiles do not change the picture");
  await page.locator("#kerf-range").selectOption("0");
  assert.equal(await picture(page), whole, "the range of the run does not come back");
}

// Looks along a line, as a single place may be empty.
async function tellsValues(page) {
  await page.locator("#kerf-colour").selectOption("speed");
  const box = await page.locator("#kerf-stage").boundingBox();
  const told = new Set();
  for (let part = 0.2; part < 0.8; part += 0.05) {
    await page.mouse.move(box.x + part * box.width, box.y + 0.6 * box.height);
    await page.waitForTimeout(40);
    if (await page.locator("#kerf-value").isVisible()) told.add(await text(page, "#kerf-value"));
  }
  await page.mouse.move(1, 1);
  assert.ok([...told].some((words) => /, speed [\d.]+\u202fm\/s$/.test(words)), `under the pointer: ${[...told]}`);
  await page.locator("#kerf-colour").selectOption("category");
}

async function hides(page) {
  const boxes = page.locator("#kerf-categories input[id]");
  const before = await picture(page);
  for (const box of await boxes.all()) await box.uncheck();
  // Paper, and at most the rim of the frame where it falls between two pixels.
  assert.ok((await colourCount(page)) < 5, "hidden particles are still seen");
  for (const box of await boxes.all()) await box.check();
  assert.equal(await picture(page), before, "hiding and showing again changes the picture");
}

async function moves(page) {
  const before = await picture(page);
  const box = await page.locator("#kerf-stage").boundingBox();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.55 * box.height, { steps: 4 });
  await page.mouse.up();
  const dragged = await picture(page);
  assert.notEqual(dragged, before, "dragging does not move the picture");
  await page.mouse.wheel(0, -240);
  assert.notEqual(await picture(page), dragged, "the wheel does not zoom");
  await page.keyboard.press("r");
  assert.equal(await picture(page), before, "R does not reset the view");
}

async function cuts(page) {
  if ((await page.locator("#kerf-clip-on").count()) === 0) return;
  const before = await picture(page);
  await page.locator("#kerf-clip-position").fill("400");
  const slid = await picture(page);
  assert.notEqual(slid, before, "the slider of the cut does not change the picture");
  await page.locator("#kerf-clip-flip").click();
  assert.notEqual(await picture(page), slid, "flipping the cut does not change the picture");
  await page.locator("#kerf-clip-flip").click();
  await page.locator("#kerf-clip-axis").selectOption("0");
  assert.notEqual(await picture(page), slid, "the axis of the cut does not change the picture");
  await page.locator("#kerf-clip-axis").selectOption("2");
  await page.locator("#kerf-clip-position").fill("500");
  assert.equal(await picture(page), before, "the cut does not come back");
}

async function saves(page) {
  const waiting = page.waitForEvent("download");
  await page.locator("#kerf-save").click();
  const file = await waiting;
  assert.match(file.suggestedFilename(), /\.png$/);
}

async function zoomsCurves(page) {
  const charts = page.locator(".kerf-chart");
  const count = await charts.count();
  if (count === 0) return;
  const range = (at) => charts.nth(at).evaluate((chart) => [Number(chart.dataset.from), Number(chart.dataset.to)]);
  const over = charts.first().locator(".u-over");
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  const whole = await range(0);
  const middle = box.y + 0.5 * box.height;
  await page.mouse.move(box.x + 0.25 * box.width, middle);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.75 * box.width, middle, { steps: 5 });
  await page.mouse.up();
  const near = (value, expected) => Math.abs(value - expected) < 0.02 * (whole[1] - whole[0]);
  const share = (part) => whole[0] + part * (whole[1] - whole[0]);
  for (const at of [0, count - 1]) {
    await page.waitForFunction(([index, to]) => Number(document.querySelectorAll(".kerf-chart")[index].dataset.to) < to, [at, whole[1]]);
    const [from, to] = await range(at);
    assert.ok(near(from, share(0.25)) && near(to, share(0.75)), `curve ${at} is not zoomed to the dragged times`);
  }
  await over.dblclick();
  await page.waitForFunction((to) => [...document.querySelectorAll(".kerf-chart")].every((chart) => Number(chart.dataset.to) === to), whole[1]);
  await page.mouse.click(box.x + 2, middle);
  const shown = () => page.locator("#kerf-frame").inputValue().then(Number);
  const last = Number(await page.locator("#kerf-frame").getAttribute("max"));
  assert.ok((await shown()) <= Math.ceil(0.05 * last), "a click on a curve does not set the frame");
}

async function prints(page) {
  await page.emulateMedia({ media: "print" });
  for (const name of ["viewer", "curves"]) {
    const fallback = page.locator(`#kerf-${name}:not(.kerf-alone) > .kerf-fallback`);
    if ((await fallback.count()) > 0) assert.ok(await fallback.isVisible(), `the ${name} is not printed as still pictures`);
  }
  await page.emulateMedia({ media: "screen" });
}

export async function usePage(path, { result, screenshot } = {}) {
  const browser = await openBrowser();
  try {
    // Small, because a processor draws each picture, twice.
    const { page, faults } = await openPage(browser, resolve(path), { viewport: { width: 1024, height: 720 } });
    for (const part of [draws, plays, colours, namesGroups, narrowsColours, tellsValues, hides, moves, cuts, saves, zoomsCurves, prints, isAccessible]) {
      await part(page);
      assert.deepEqual(faults, [], `after "${part.name}"`);
    }
    if (result) await checkNumbers(page, result);
    assert.deepEqual(faults, [], "after its numbers");
    if (screenshot) await page.screenshot({ path: screenshot, fullPage: true });
  } finally {
    await browser.close();
  }
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const usage = "usage: node test/page.mjs REPORT.html [--result result.json] [--screenshot FILE.png]";
  try {
    const options = { result: { type: "string" }, screenshot: { type: "string" } };
    const { values, positionals } = parseArgs({ options, allowPositionals: true });
    assert.equal(positionals.length, 1, usage);
    await usePage(positionals[0], values);
    console.log(`${positionals[0]}: as it should be`);
  } catch (error) {
    console.error(error);
    process.exit(1);
  }
}
