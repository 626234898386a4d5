// SPDX-License-Identifier: Apache-2.0
// How many runs there are of each kind, and how to see more of a study that goes on.

import { element } from "../dom.ts";
import type { StudyData } from "./study_data.ts";
import { inlineSymbol, verdictOf, verdictOrder, verdictWords } from "./verdict.ts";

const pause = 10; // s
const name = "kerf-follow";

function follow(): HTMLElement {
  const box = element("input", { type: "checkbox", id: name });
  let waiting: ReturnType<typeof setTimeout> | undefined;
  const set = (on: boolean) => {
    clearTimeout(waiting);
    if (on) waiting = setTimeout(() => location.reload(), 1000 * pause);
  };
  box.addEventListener("change", () => {
    sessionStorage.setItem(name, box.checked ? "on" : "");
    set(box.checked);
  });
  box.checked = sessionStorage.getItem(name) === "on";
  set(box.checked);
  return element("label", { className: "kerf-follow" }, box, ` load again every ${pause} s`);
}

export function stateOf(data: StudyData): HTMLElement {
  const verdicts = data.study.runs.map(verdictOf);
  const root = element("div", { className: "kerf-state", attributes: { role: "status" } });
  for (const verdict of verdictOrder) {
    const count = verdicts.filter((one) => one === verdict).length;
    if (count > 0) root.append(element("span", {}, inlineSymbol(verdict), ` ${count} ${verdictWords[verdict]}`));
  }
  if (data.state === "ended") return root;
  const words = data.state === "running" ? "The study goes on" : "The study was stopped";
  root.append(element("strong", {}, `${words}; this is how it stood at ${data.written}.`));
  if (data.state === "running") root.append(follow());
  return root;
}
