// SPDX-License-Identifier: Apache-2.0
// Pages with something wrong in them say so, and what is right in them still works.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

import { openBrowser, openPage } from "./browser.mjs";
import { page as makePage } from "./make_sample.mjs";
import { pack, sampleRun } from "./sample_run.mjs";

const line = (page, place) => page.locator(`${place} > .kerf-message`).textContent();
const curvesWork = (page) => page.locator(".kerf-chart .u-over").first().waitFor();
const stillPictures = (page) => page.locator("#kerf-viewer > .kerf-fallback").waitFor();

const cases = {
  async badJson(page) {
    assert.match(await line(page, "#kerf-viewer"), /no JSON/);
    await stillPictures(page);
  },
  async badRun(page) {
    assert.match(await line(page, "#kerf-viewer"), /fields\[1\]\.unit should be a text/);
    await stillPictures(page);
    await curvesWork(page);
  },
  async badCurves(page) {
    assert.match(await line(page, "#kerf-curves"), /40 values/);
    await page.waitForSelector('#kerf-stage[data-frame="11"]');
    assert.ok(await page.locator("#kerf-curves > .kerf-fallback").isVisible());
  },
  async badFrames(page) {
    await page.waitForSelector('#kerf-stage[data-frame="11"]');
    await page.locator("#kerf-frame").fill("4");
    await page.waitForSelector("#kerf-stage > .kerf-message");
    assert.match(await line(page, "#kerf-stage"), /Frame 5: 10 bytes, where 2 particles in 2D with 4 fields take 20/);
    await page.locator("#kerf-frame").fill("5");
    await page.waitForFunction(() => /Frame 6: .*zlib/.test(document.querySelector("#kerf-stage > .kerf-message")?.textContent));
    await page.locator("#kerf-frame").fill("6");
    await page.waitForSelector('#kerf-stage[data-frame="6"]');
    assert.equal(await page.locator("#kerf-stage > .kerf-message").count(), 0);
    await curvesWork(page);
  },
  async noFrames(page) {
    assert.match(await page.locator("#kerf-status").textContent(), /no frames yet/);
    await curvesWork(page);
  },
};

function pageFor(name) {
  const run = sampleRun(2);
  if (name === "badJson") return makePage(run, '{"title": ');
  if (name === "badRun") delete run.fields[1].unit;
  if (name === "badCurves") run.curves.time.length = 40;
  if (name === "noFrames") run.frames = [];
  if (name === "badFrames") {
    const one = { place: [0, 0, 0], category: 0, size: 0, values: [1, 2, 3] };
    run.frames[4] = { ...run.frames[4], count: 2, data: pack([one], run).toString("base64") };
    run.frames[5].data = Buffer.from("no zlib").toString("base64");
  }
  return makePage(run);
}

async function withoutWebGl(folder) {
  const browser = await openBrowser({ webGl: false });
  try {
    const path = join(folder, "no_webgl.html");
    writeFileSync(path, makePage(sampleRun(3)));
    const { page, faults } = await openPage(browser, path);
    assert.match(await line(page, "#kerf-viewer"), /no WebGL/);
    await stillPictures(page);
    await curvesWork(page);
    assert.deepEqual(faults, []);
  } finally {
    await browser.close();
  }
}

export async function checkFailures(folder) {
  const browser = await openBrowser();
  try {
    for (const [name, check] of Object.entries(cases)) {
      const path = join(folder, `${name}.html`);
      writeFileSync(path, pageFor(name));
      const { page, faults } = await openPage(browser, path);
      await check(page);
      assert.deepEqual(faults, [], name);
      await page.context().close();
    }
  } finally {
    await browser.close();
  }
  await withoutWebGl(folder);
}
