// SPDX-License-Identifier: Apache-2.0
// The check of dark paper sees what is painted: it finds no dark paper in a page that has none.
//
//     node test/dark_paper.mjs

import assert from "node:assert/strict";

import { isDark, paperOf } from "./accessible.mjs";
import { openBrowser } from "./browser.mjs";

const pages = [
  { name: "a page without a background", style: "", dark: false },
  { name: "a transparent page", style: "body { background: rgba(0, 0, 0, 0) }", dark: false },
  { name: "a page that stays light", style: "body { background: #fff }", dark: false },
  { name: "a page with a dark background", style: "@media (prefers-color-scheme: dark) { body { background: #14181d } }", dark: true },
  { name: "a transparent page on dark paper", style: "html { background: #14181d } body { background: none }", dark: true },
];

const browser = await openBrowser({ webGl: false });
try {
  const page = await browser.newPage({ viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  for (const { name, style, dark } of pages) {
    await page.setContent(`<style>${style}</style><p>Words on the paper</p>`);
    assert.equal(isDark(await paperOf(page)), dark, `${name}: ${await paperOf(page)}`);
  }
  console.log("ok  dark paper is seen as it is painted");
} finally {
  await browser.close();
}
