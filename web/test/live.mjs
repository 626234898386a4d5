// SPDX-License-Identifier: Apache-2.0
// A page of a run that goes on, served from this computer: new frames come in, choices stay.

import assert from "node:assert/strict";
import { createServer } from "node:http";

import { openBrowser } from "./browser.mjs";
import { page as makePage } from "./make_sample.mjs";
import { sampleRun } from "./sample_run.mjs";

function upTo(run, frames, live) {
  const end = run.frames[frames - 1].time;
  const known = run.curves.time.filter((time) => time <= end).length;
  const groups = run.curves.groups.map((group) => ({
    ...group,
    series: group.series.map((series) => ({ ...series, values: series.values.slice(0, known) })),
  }));
  const told = run.frames.slice(0, frames).map(({ time, count }, at) => ({ time, count, url: `frames/${at}.bin` }));
  return { ...run, live, frames: told, curves: { ...run.curves, time: run.curves.time.slice(0, known), groups } };
}

function serve(run, state) {
  const server = createServer((request, response) => {
    const frame = /^\/frames\/(\d+)\.bin$/.exec(request.url);
    if (frame) response.end(Buffer.from(run.frames[Number(frame[1])].data, "base64"));
    else if (request.url === "/run.json") response.end(JSON.stringify(upTo(run, state.frames, state.live)));
    else if (request.url === "/") response.setHeader("content-type", "text/html").end(makePage(upTo(run, state.frames, true)));
    else response.writeHead(404).end();
    state.asked.push(request.url);
  });
  return new Promise((ready) => server.listen(0, "127.0.0.1", () => ready(server)));
}

async function followed(page, state) {
  const frameIs = (index) => page.waitForSelector(`#kerf-stage[data-frame="${index}"]`);
  await frameIs(2);
  await page.locator("#kerf-colour").selectOption("speed");
  await page.locator("#kerf-category-3").uncheck();
  state.frames = 6;
  await frameIs(5); // was at the end, so it follows
  assert.equal(await page.locator("#kerf-colour").inputValue(), "speed");
  assert.equal(await page.locator("#kerf-category-3").isChecked(), false);
  await page.locator("#kerf-frame").fill("1");
  await frameIs(1);
  state.frames = 9;
  await page.waitForFunction(() => document.querySelector("#kerf-frame").max === "8");
  assert.equal(await page.locator("#kerf-stage").getAttribute("data-frame"), "1", "follows though not at the end");
  const end = await page.locator(".kerf-chart").first().getAttribute("data-to");
  assert.ok(Number(end) > 1.9e-3, "the curves have not grown");
  Object.assign(state, { frames: 12, live: false });
  await page.waitForFunction(() => document.querySelector("#kerf-frame").max === "11");
  const asked = state.asked.length;
  await page.waitForTimeout(2600);
  assert.equal(state.asked.length, asked, "asks on after the end");
}

export async function checkLive() {
  const state = { frames: 3, live: true, asked: [] };
  const server = await serve(sampleRun(2), state);
  const browser = await openBrowser();
  try {
    const page = await browser.newPage();
    const faults = [];
    page.on("pageerror", (error) => faults.push(error.message));
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await followed(page, state);
    assert.equal(state.asked.filter((url) => url === "/frames/5.bin").length, 1, "a frame was fetched twice");
    assert.deepEqual(faults, []);
  } finally {
    await browser.close();
    server.close();
  }
}
