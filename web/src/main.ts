// SPDX-License-Identifier: Apache-2.0
// Finds its places in the page and fills them. What fails leaves its fallback and a line that says why.

import "./style.css";

import { Comparison } from "./comparison.ts";
import { readCurves } from "./curve_data.ts";
import { Curves } from "./curves.ts";
import { note, setFallbackAside } from "./dom.ts";
import { follow } from "./live.ts";
import { list, object, readJson, readRun } from "./run.ts";
import { NoWebGl } from "./stage.ts";
import { Viewer } from "./viewer.ts";

type Json = Record<string, unknown>;

function message(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

class Page {
  private viewer: Viewer | undefined;
  private curves: Curves | undefined;

  constructor(
    private readonly viewerPlace: HTMLElement | null,
    private readonly curvesPlace: HTMLElement | null,
  ) {
    if (viewerPlace) setFallbackAside(viewerPlace);
    if (curvesPlace) setFallbackAside(curvesPlace);
  }

  start(json: Json) {
    this.attempt(this.viewerPlace, "The particles cannot be shown", (place) => this.startViewer(place, json));
    if (json.curves === undefined) return;
    this.attempt(this.curvesPlace, "The curves cannot be shown", (place) => this.showCurves(place, json.curves));
  }

  update(json: Json) {
    this.attempt(this.viewerPlace, "The new frames cannot be shown", () => this.viewer?.update(readRun(json)));
    if (json.curves === undefined) return;
    this.attempt(this.curvesPlace, "The new curves cannot be shown", (place) => this.showCurves(place, json.curves));
  }

  complain(words: string) {
    const place = this.viewerPlace ?? this.curvesPlace;
    if (place) note(place, words);
  }

  private startViewer(place: HTMLElement, json: Json) {
    const run = readRun(json);
    let viewer: Viewer;
    try {
      viewer = new Viewer(run);
    } catch (error) {
      if (!(error instanceof NoWebGl)) throw error;
      note(place, "This browser has no WebGL, so the particles are shown as still pictures.", "note");
      return;
    }
    this.viewer = viewer;
    place.append(viewer.root);
    place.classList.add("kerf-enhanced");
    viewer.start();
  }

  private showCurves(place: HTMLElement, json: unknown) {
    const data = readCurves(json);
    if (this.curves) return this.curves.update(data);
    this.curves = new Curves(data, this.viewer?.player);
    place.append(this.curves.root);
    place.classList.add("kerf-enhanced");
  }

  // Neither part may take the other with it.
  private attempt(place: HTMLElement | null, failure: string, action: (place: HTMLElement) => void) {
    if (!place) return;
    try {
      action(place);
    } catch (error) {
      note(place, `${failure}: ${message(error)}.`);
    }
  }
}

function compare(place: HTMLElement) {
  setFallbackAside(place);
  const source = document.getElementById("kerf-compared-runs")?.textContent ?? "";
  try {
    const runs = list(JSON.parse(source), "the data").map((one, at) => object(one, `run ${at + 1}`));
    const [first, second] = runs;
    if (!first || !second) throw new Error("there are not two runs");
    const comparison = new Comparison([readRun(first), readRun(second)]);
    place.append(comparison.root);
    place.classList.add("kerf-enhanced");
    comparison.start();
    for (const at of [0, 1] as const) if (runs[at]!.live === true) followOne(place, comparison, at);
  } catch (error) {
    if (error instanceof NoWebGl) note(place, "This browser has no WebGL, so the particles are not shown.", "note");
    else note(place, `The runs cannot be shown: ${message(error)}.`);
  }
}

function followOne(place: HTMLElement, comparison: Comparison, at: 0 | 1) {
  const name = ["first", "second"][at];
  follow(
    (text) => {
      const next = readJson(text);
      note(place, "");
      comparison.update(at, readRun(next));
      return next.live === true;
    },
    (reason) => note(place, `No news of the ${name} run (${reason}).`),
    `${name}/run.json`,
  );
}

function start() {
  const compared = document.getElementById("kerf-compared");
  if (compared) return compare(compared);
  const source = document.getElementById("kerf-run");
  if (!source) return;
  const page = new Page(document.getElementById("kerf-viewer"), document.getElementById("kerf-curves"));
  let json: Json;
  try {
    json = readJson(source.textContent ?? "");
  } catch (error) {
    page.complain(`The run cannot be shown: ${message(error)}.`);
    return;
  }
  page.start(json);
  if (json.live !== true) return;
  follow(
    (text) => {
      const next = readJson(text);
      page.complain("");
      page.update(next);
      return next.live === true;
    },
    (reason) => page.complain(`No news of the run (${reason}).`),
  );
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
