// SPDX-License-Identifier: Apache-2.0
// Starts the run of the case, shows it as kerf view does, and stops it.

import { element, selection } from "../dom.ts";
import { ask, tell, type RunState } from "./protocol.ts";

const interval = 700; // ms

const sentencesOf: Record<RunState["state"], string> = {
  none: "The case has not been run from this page.",
  running: "The run is in progress.",
  completed: "The run is complete.",
  stopped: "The run was stopped. Its checkpoint is in the folder, so that it can be continued.",
  failed: "The run failed.",
};

export class RunTab {
  private readonly folder = element("input", { id: "kerf-folder", type: "text", spellcheck: false });
  private readonly existing = selection(
    "kerf-existing",
    [
      ["refuse", "keep it and refuse"],
      ["resume", "continue it"],
      ["replace", "replace it"],
    ],
    "refuse",
  );
  private readonly start = element("button", { id: "kerf-start", type: "button" }, "Save and run");
  private readonly stop = element("button", { id: "kerf-stop", type: "button", disabled: true }, "Stop");
  private readonly state = element("p", { id: "kerf-run-state", attributes: { role: "status" } });
  private readonly output = element("pre", { id: "kerf-run-output", hidden: true });
  private readonly frame = element("iframe", { id: "kerf-run-view", title: "The run", hidden: true });
  private shown = "";
  readonly root = element(
    "div",
    { className: "kerf-run" },
    element(
      "div",
      { className: "kerf-run-controls" },
      element("label", {}, "Folder for the results ", this.folder),
      element("label", {}, "A run that is there ", this.existing),
      this.start,
      this.stop,
    ),
    this.state,
    this.output,
    this.frame,
  );

  constructor(private readonly save: () => Promise<boolean>) {
    this.start.addEventListener("click", () => void this.begin());
    this.stop.addEventListener("click", () => void this.attempt(() => tell<RunState>("stop", {})));
  }

  /** Shows the run that this server has made last, if there is one. */
  async look() {
    await this.attempt(() => ask<RunState>("run"));
  }

  private async begin() {
    if (!(await this.save())) return this.say("The case was not saved, so it was not run.");
    const order = { folder: this.folder.value.trim(), existing: this.existing.value };
    await this.attempt(() => tell<RunState>("run", order));
  }

  /** Starts a short, coarse run of a text, which need not be saved. */
  async pilot(text: string) {
    await this.attempt(() => tell<RunState>("pilot", { text }));
  }

  private say(words: string) {
    if (this.state.textContent !== words) this.state.textContent = words;
  }

  private async attempt(question: () => Promise<RunState>) {
    try {
      this.show(await question());
    } catch (error) {
      this.say((error as Error).message);
    }
  }

  private show(run: RunState) {
    const runs = run.state === "running";
    const folder = run.results ? ` Its folder is ${run.results}.` : "";
    const changes = run.changes?.length ? ` This is a pilot run. ${run.changes.join(" ")}` : "";
    this.say(sentencesOf[run.state] + folder + changes);
    this.root.dataset.state = run.state;
    this.start.disabled = runs;
    this.stop.disabled = !runs;
    this.root.dataset.folder = run.results ?? "";
    this.folder.placeholder = run.folder;
    this.output.hidden = run.state !== "failed";
    this.output.textContent = run.output ?? "";
    // The page of a run follows it to its end, and is then the report.
    const page = run.view ? `${run.view}?${run.state}` : "";
    if (page !== "" && page !== this.shown) this.frame.src = this.shown = page;
    this.frame.hidden = page === "";
    if (runs) setTimeout(() => void this.look(), interval);
  }
}
