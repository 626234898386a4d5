// SPDX-License-Identifier: Apache-2.0
// axe-core finds nothing serious in a page: in light and dark colours, and on a phone, where nothing is wider than it.

import assert from "node:assert/strict";
import { createRequire } from "node:module";

const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
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

export async function isAccessible(page) {
  await page.addScriptTag({ path: axe });
  const size = page.viewportSize();
  assert.deepEqual(await findings(page), [], "in light colours");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.setViewportSize(phone);
  const paper = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.ok(paper.match(/\d+/g).every((part) => Number(part) < 64), `dark paper is ${paper}`);
  assert.deepEqual(await findings(page), [], "in dark colours, on a phone");
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= phone.width, `the page is ${wide} px wide on a phone of ${phone.width} px`);
  await page.emulateMedia({ colorScheme: "light" });
  await page.setViewportSize(size);
}
