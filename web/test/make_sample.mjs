// SPDX-License-Identifier: Apache-2.0
// Pages as the simulator writes them, of made-up runs:
//   node test/make_sample.mjs [FOLDER]
// Writes sample_2d.html and sample_3d.html and says where.

import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { sampleRun } from "./sample_run.mjs";

const beside = (path) => new URL(path, import.meta.url);

/** The style sheet of reports. KERF_STYLE names its header where this folder is a copy without the sources of the program. */
export function reportStyle() {
  const header = process.env.KERF_STYLE ?? beside("../../src/report/style.hpp");
  const style = readFileSync(header, "utf8").split('R"css(')[1]?.split(')css"')[0];
  if (!style) throw new Error(`${header} has no style sheet`);
  return style;
}

// A "<" in a text of the run must not end the element that holds it.
export const inline = (json) => JSON.stringify(json).replaceAll("<", "\\u003c");

export function page(run, json = inline(run)) {
  const bundle = readFileSync(beside("../dist/viewer.js"), "utf8");
  const style = readFileSync(beside("../dist/viewer.css"), "utf8");
  const still = `<svg viewBox="0 0 600 200"><rect width="600" height="200" fill="#f5f6f8"/><text x="20" y="40">still picture</text></svg>`;
  return `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${run.title}</title><style>${reportStyle()}</style><style>${style}</style></head>
<body><main><header><h1>${run.title}</h1><p class="meta">A made-up run</p></header>
<section id="kerf-viewer"><h2>Particles</h2><div class="pictures"><figure>${still}</figure></div></section>
<section id="kerf-curves"><h2>Curves</h2><div class="plots"><figure>${still}</figure></div></section>
<footer>Sample</footer></main>
<script type="application/json" id="kerf-run">${json}</script>
<script>${bundle}</script></body></html>
`;
}

export function makeSamples(folder = mkdtempSync(join(tmpdir(), "kerf-sample-"))) {
  mkdirSync(folder, { recursive: true });
  return [2, 3].map((dimension) => {
    const path = join(folder, `sample_${dimension}d.html`);
    writeFileSync(path, page(sampleRun(dimension)));
    return path;
  });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  for (const path of makeSamples(process.argv[2])) console.log(path);
