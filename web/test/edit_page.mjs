// SPDX-License-Identifier: Apache-2.0
// Edits, saves and runs a case as a user of `kerf view --edit` would.
//
//     node test/edit_page.mjs KERF FOLDER [--screenshots]

import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { isAccessible } from "./accessible.mjs";
import { openBrowser } from "./browser.mjs";
import { serve } from "./serve.mjs";

const [kerf, folder, option] = process.argv.slice(2);
const file = join(folder, "my.toml");
const written = `# a case of the tests
title = "Soft gel"
dimension = 2
quality = "draft"

[machine]
pressure = "50 kPa"       # at the orifice
orifice_diameter = "2 mm"
standoff = "6 mm"
position = ["0 mm", "6 mm"]

[time]
end = "0.1 ms"            # a tiny run

[[body]]
name = "gel"
material = "agar"
spacing = "0.25 mm"
shape = { type = "box", minimum = ["-10 mm", "0 mm"], maximum = ["10 mm", "6 mm"] }
`;

const state = (page, words) => page.waitForFunction((pattern) => new RegExp(pattern).test(document.querySelector("#kerf-state")?.textContent ?? ""), words);
const field = (page, path) => page.locator(`[id="kerf-key-${path}"]`);

async function fact(page, name) {
  const text = await page.locator("#kerf-facts tr", { hasText: name }).locator("td").textContent();
  const [number, unit] = text.split(" ");
  return Number(number) * { Pa: 1, kPa: 1e3, MPa: 1e6 }[unit];
}

async function changesThePressure(page) {
  await state(page, "^The case is valid");
  const before = await fact(page, "Stagnation pressure");
  await field(page, "machine.pressure").fill("200 kPa");
  await page.waitForFunction((old) => !document.querySelector("#kerf-facts").textContent.includes(old), String(before / 1e3));
  // By Bernoulli's equation it is proportional to the pressure; it is shown with four digits.
  assert.ok(Math.abs((await fact(page, "Stagnation pressure")) / before / 4 - 1) < 1e-3);
}

async function refusesAWrongUnit(page) {
  const input = field(page, "machine.pressure");
  await input.fill("200 mm");
  await state(page, "^The case has 1 problem");
  const fault = page.locator('[id="kerf-key-machine.pressure-fault"]');
  assert.match(await fault.textContent(), /Allowed: a pressure with its unit/);
  assert.equal(await input.getAttribute("aria-invalid"), "true");
  await page.locator("#kerf-tab-text").click();
  await page.locator("#kerf-problems button").click();
  assert.equal(await page.evaluate(() => document.activeElement.id), "kerf-key-machine.pressure");
  await input.fill("0.2 MPa");
  await state(page, "^The case is valid");
  assert.equal(await input.getAttribute("aria-invalid"), null);
}

async function savesTheText(page) {
  await page.locator("#kerf-save-case").click();
  await page.waitForFunction(() => document.querySelector("#kerf-saved").textContent === "saved");
  assert.equal(readFileSync(file, "utf8"), written.replace("50 kPa", "0.2 MPa"));
}

async function keepsFormAndTextAlike(page) {
  await page.locator("#kerf-tab-text").click();
  const area = page.locator("#kerf-text");
  await area.fill((await area.inputValue()).replace("Soft gel", "Gel"));
  await page.waitForFunction(() => document.getElementById("kerf-key-title").value === "Gel");
  await page.locator("#kerf-tab-form").click();
  await field(page, "quality").selectOption("");
  await page.waitForFunction(() => !document.querySelector("#kerf-text").value.includes("quality"));
}

// The file is changed by another program: nothing is lost.
async function keepsTheFileOfOthers(page) {
  const other = written.replace("a case", "another case");
  const mine = readFileSync(file, "utf8");
  writeFileSync(file, other);
  await page.locator("#kerf-save-case").click();
  await page.locator(".kerf-head .kerf-error", { hasText: "changed by another program" }).waitFor();
  assert.equal(readFileSync(file, "utf8"), other);
  writeFileSync(file, mine);
  await field(page, "quality").selectOption("draft");
  await page.waitForFunction(() => document.querySelector("#kerf-text").value.includes("quality"));
}

const textOf = (page) => page.locator("#kerf-text").inputValue();
const holds = (page, words) => page.waitForFunction((part) => document.querySelector("#kerf-text").value.includes(part), words);

// Each table that a case may hold several of is added with values to start from, by the keyboard, and removed again.
async function addsAndRemovesTables(page) {
  const before = await textOf(page);
  const adders = await page.locator(".kerf-adder > button").evaluateAll((list) => list.map((one) => one.id.slice("kerf-add-".length)));
  for (const section of ["body", "jet", "load", "probe", "materials"]) assert.ok(adders.includes(section), `no button adds to ${section}`);
  for (const section of adders.filter((one) => one !== "jet")) {
    const heading = section === "materials" ? "[materials.soft-gel]" : `[[${section}]]`;
    if (section === "materials") await page.locator("#kerf-name-of-new-materials").fill("soft-gel");
    await page.locator(`#kerf-add-${section}`).focus();
    await page.keyboard.press("Enter");
    await page.waitForFunction(([old, part]) => document.querySelector("#kerf-text").value.split(part).length === old.split(part).length + 1, [before, heading]);
    await state(page, "^The case is valid");
    await page.waitForFunction(() => document.activeElement.closest(".kerf-field") !== null); // in the new table
    const remove = page.locator(".kerf-part[open] > .kerf-remove:visible", { hasText: `Remove ${heading.replace(/]+$/, "")}` }).last();
    await remove.focus();
    await page.keyboard.press("Enter");
    await page.waitForFunction((old) => document.querySelector("#kerf-text").value === old, before);
    assert.equal(await page.evaluate(() => document.activeElement.id), `kerf-add-${section}`);
  }
  // The last removal is undone.
  await page.locator("#kerf-undo").click();
  await holds(page, "[[probe]]");
  await page.locator(".kerf-part", { hasText: "[[probe]]" }).locator(".kerf-remove").evaluate((button) => button.click());
  await page.waitForFunction((old) => document.querySelector("#kerf-text").value === old, before);
}

// A body may have a graded resolution: its keys are there before its table is.
async function gradesABody(page) {
  const before = await textOf(page);
  await page.locator(".kerf-part > summary", { hasText: "[[body]] gel grading" }).click();
  await field(page, "body[1].grading.levels").fill("1");
  await field(page, "body[1].grading.width").fill("3 mm");
  await holds(page, 'grading = { levels = 1, width = "3 mm" }');
  await state(page, "^The case is valid");
  await field(page, "body[1].grading.width").fill("");
  await field(page, "body[1].grading.levels").fill("");
  await page.waitForFunction((old) => document.querySelector("#kerf-text").value === old, before);
  await state(page, "^The case is valid");
}

// What cannot stand beside the rest of the case is added all the same, and the check says so.
async function saysWhatDoesNotGoTogether(page) {
  const before = await textOf(page);
  await page.locator("#kerf-add-jet").click();
  await holds(page, "[[jet]]");
  await page.waitForFunction(() => document.querySelector("#kerf-state").textContent !== "");
  await page.locator(".kerf-part", { hasText: "[[jet]]" }).last().locator(".kerf-remove").click();
  await page.waitForFunction((old) => document.querySelector("#kerf-text").value === old, before);
  await state(page, "^The case is valid");
}

async function showsTheReportOf(page, name) {
  const report = page.frameLocator("#kerf-run-view");
  await report.locator(".meta code", { hasText: new RegExp(`^${name}$`) }).first().waitFor();
  await report.locator(".verdict").waitFor();
}

async function makesAPilotRun(page) {
  await page.locator("#kerf-pilot").click();
  await page.locator('.kerf-run[data-state="completed"][data-folder="out/my-pilot"]').waitFor();
  assert.equal(await page.locator("#kerf-tab-run").getAttribute("aria-selected"), "true");
  await showsTheReportOf(page, "my-pilot");
  assert.match(readFileSync(join(folder, "out/my-pilot/case.used.toml"), "utf8"), /quality|spacing/);
  await page.locator("#kerf-tab-form").click();
}

async function runsAndShows(page) {
  await page.locator("#kerf-tab-run").click();
  await page.locator("#kerf-start").click();
  await page.locator('.kerf-run[data-state="completed"][data-folder="out/my"]').waitFor({ timeout: 60000 });
  await showsTheReportOf(page, "my");
  await page.frameLocator("#kerf-run-view").locator("#kerf-stage[data-frame]").waitFor();
  assert.ok(existsSync(join(folder, "out/my/result.json")));
  assert.match(readFileSync(join(folder, "out/my/case.used.toml"), "utf8"), /title = "Gel"/);
}

async function takePictures(page) {
  for (const [width, height] of [[1400, 900], [390, 844]]) {
    await page.setViewportSize({ width, height });
    for (const tab of ["form", "text", "run"]) {
      await page.locator(`#kerf-tab-${tab}`).click();
      await page.waitForTimeout(300);
      await page.screenshot({ path: join(folder, `${tab}_${width}.png`) });
    }
  }
}

rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
writeFileSync(file, written);
const { server, address } = serve(kerf, ["view", "--edit", file], folder);
const browser = await openBrowser();
try {
  const page = await browser.newPage({ viewport: { width: 1400, height: 900 } });
  const faults = [];
  page.on("pageerror", (error) => faults.push(error.message));
  page.setDefaultTimeout(60000); // a loaded machine
  await page.goto(await address);
  await changesThePressure(page);
  await refusesAWrongUnit(page);
  await savesTheText(page);
  await keepsFormAndTextAlike(page);
  await keepsTheFileOfOthers(page);
  await addsAndRemovesTables(page);
  await gradesABody(page);
  await saysWhatDoesNotGoTogether(page);
  await makesAPilotRun(page);
  await runsAndShows(page);
  await page.locator("#kerf-tab-form").click();
  await isAccessible(page);
  if (option === "--screenshots") await takePictures(page);
  assert.deepEqual(faults, []);
  console.log("ok  a case was edited, saved and run");
} finally {
  await browser.close();
  server.removeAllListeners("exit");
  server.kill("SIGINT");
}
