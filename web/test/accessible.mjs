// SPDX-License-Identifier: Apache-2.0
// axe-core finds nothing serious in a page: in light colours on a desk, and in dark ones on a phone, where nothing is
// wider than it.

import assert from "node:assert/strict";
import { createRequire } from "node:module";

const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const desk = { width: 1400, height: 900 };
const phone = { width: 390, height: 844 };

/** Contrast is judged once the page has its colours: transitions take a moment. */
async function findings(page) {
  return page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
    return violations
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html }) => html.slice(0, 160)).join(" | ")}`);
  });
}

/** The colour of most of the left edge as the page paints it: red, green, blue and opacity from 0 to 255. What the page leaves to the browser is transparent. */
export async function paperOf(page) {
  const { height } = page.viewportSize();
  const picture = await page.screenshot({ clip: { x: 0, y: 0, width: 1, height }, omitBackground: true });
  return page.evaluate(async (address) => {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const counts = new Map();
    for (let at = 0; at < data.length; at += 4) {
      const colour = data.slice(at, at + 4).join(" ");
      counts.set(colour, (counts.get(colour) ?? 0) + 1);
    }
    const [[colour]] = [...counts].sort((a, b) => b[1] - a[1]);
    return colour.split(" ").map(Number);
  }, `data:image/png;base64,${picture.toString("base64")}`);
}

export const isDark = ([red, green, blue, opacity]) => opacity === 255 && Math.max(red, green, blue) < 64;

export async function isAccessible(page) {
  await page.addScriptTag({ path: axe });
  const size = page.viewportSize();
  await page.setViewportSize(desk);
  assert.deepEqual(await findings(page), [], "in light colours");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.setViewportSize(phone);
  const paper = await paperOf(page);
  assert.ok(isDark(paper), `dark paper is ${paper}`);
  assert.deepEqual(await findings(page), [], "in dark colours, on a phone");
  // The drawings follow the width, on a loaded machine after a moment.
  const fits = (width) => document.documentElement.scrollWidth <= width;
  await page.waitForFunction(fits, phone.width, { timeout: 10000 }).catch(() => {});
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= phone.width, `the page is ${wide} px wide on a phone of ${phone.width} px`);
  await page.emulateMedia({ colorScheme: "light" });
  await page.setViewportSize(size);
}
