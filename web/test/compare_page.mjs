// SPDX-License-Identifier: Apache-2.0
// Compares two runs as a user of `kerf view FIRST --compare SECOND` would.
//
//     node test/compare_page.mjs KERF FIRST SECOND [--screenshot FILE.png]

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";

import { isAccessible } from "./accessible.mjs";
import { openBrowser } from "./browser.mjs";
import { serve } from "./serve.mjs";

const [kerf, first, second, option, picture] = process.argv.slice(2);
const stages = ["#kerf-stage-first", "#kerf-stage-second"];

async function runsOf(address) {
  const runs = [];
  for (const name of ["first", "second"]) runs.push(await (await fetch(`${address}${name}/run.json`)).json());
  return runs;
}

const nearest = (run, time) => run.frames.reduce((best, frame, at) => (Math.abs(frame.time - time) < Math.abs(run.frames[best].time - time) ? at : best), 0);

async function movesBoth(page, runs) {
  const times = [...new Set(runs.flatMap((run) => run.frames.map(({ time }) => time)))].sort((a, b) => a - b);
  assert.equal(await page.locator("#kerf-frame").getAttribute("max"), String(times.length - 1));
  for (const at of [0, Math.floor(times.length / 2), times.length - 1]) {
    await page.locator("#kerf-frame").fill(String(at));
    for (const [side, stage] of stages.entries()) await page.waitForSelector(`${stage}[data-frame="${nearest(runs[side], times[at])}"]`);
  }
  const ends = runs.map((run) => run.frames.at(-1).time);
  const states = await page.locator(".kerf-of-two figcaption .kerf-soft").allTextContents();
  states.forEach((words, side) => assert.match(words, ends[side] < Math.max(...ends) ? /^ended at / : /^at /));
}

async function coloursMeanTheSame(page, runs) {
  const key = "speed";
  await page.locator("#kerf-colour").selectOption(key);
  const range = runs.map((run) => run.fields.find((field) => field.key === key));
  const highest = Math.max(...range.map(({ maximum }) => maximum));
  const words = await page.locator("#kerf-legend .kerf-bar").getAttribute("aria-label");
  const told = Number(/ to ([\d.]+)/.exec(words)[1]);
  assert.ok(Math.abs(told - highest) < 6e-3 * highest, `the colours end at ${words}, where the runs reach ${highest} m/s`);
  assert.ok(await page.locator("#kerf-range").isHidden(), "a range of one frame would differ between the runs");
}

async function tellsTheDifference(page) {
  const results = [first, second].map((folder) => JSON.parse(readFileSync(join(folder, "result.json"), "utf8")));
  const cells = await page.locator('#kerf-numbers tr[data-key="particles"] td').allTextContents();
  const [one, two, difference] = cells.map((text) => Number(text.replace(/\(.*/, "").replace("−", "-").replace(/[^\d.-]/g, "")));
  assert.deepEqual([one, two], results.map((result) => result.particles));
  assert.equal(difference, two - one);
}

const { server, address } = serve(kerf, ["view", first, "--compare", second]);
const browser = await openBrowser();
try {
  const page = await browser.newPage({ viewport: { width: 1400, height: 1000 } });
  const faults = [];
  page.on("pageerror", (error) => faults.push(error.message));
  page.setDefaultTimeout(60000); // a loaded machine
  await page.goto(await address);
  const runs = await runsOf(await address);
  await movesBoth(page, runs);
  await coloursMeanTheSame(page, runs);
  await tellsTheDifference(page);
  if (option === "--screenshot") await page.screenshot({ path: picture, fullPage: true });
  await isAccessible(page);
  assert.deepEqual(faults, []);
  console.log("ok  two runs were compared");
} finally {
  await browser.close();
  server.removeAllListeners("exit");
  server.kill("SIGINT");
}
