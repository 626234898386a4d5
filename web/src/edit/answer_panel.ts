// SPDX-License-Identifier: Apache-2.0
// What the check says: problems, or the geometry, the cost and the warnings.

import { element } from "../dom.ts";
import { sentences, type Answer, type Problem } from "./protocol.ts";

function list(title: string, entries: (string | Node)[], className = ""): HTMLElement[] {
  if (entries.length === 0) return [];
  const items = entries.map((entry) => element("li", {}, entry));
  return [element("h3", {}, title), element("ul", { className }, ...items)];
}

// The server makes the drawings and escapes the names in them.
function drawing({ title, svg }: { title: string; svg: string }): HTMLElement {
  const figure = element("figure", { className: "kerf-drawing" });
  figure.innerHTML = svg;
  figure.append(element("figcaption", { className: "kerf-soft" }, title));
  return figure;
}

function stateOf(answer: Answer): string {
  const count = answer.problems.length;
  if (count > 0) return count === 1 ? "The case has 1 problem." : `The case has ${count} problems.`;
  const warnings = answer.check?.warnings.length ?? 0;
  const also = warnings === 0 ? "" : warnings === 1 ? " There is 1 warning." : ` There are ${warnings} warnings.`;
  return `The case is valid.${also}`;
}

export class AnswerPanel {
  // Screen readers tell the state and the problems when they change.
  readonly state = element("p", { id: "kerf-state", attributes: { role: "status", "aria-live": "polite" } });
  private readonly problems = element("div", { id: "kerf-problems", attributes: { "aria-live": "polite" } });
  private readonly pictures = element("div", { className: "kerf-drawings" });
  private readonly facts = element("table", { id: "kerf-facts" });
  private readonly remarks = element("div", { className: "kerf-remarks" });
  readonly root = element(
    "section",
    { id: "kerf-answer", tabIndex: 0, attributes: { "aria-label": "Check of the case" } },
    this.problems,
    this.pictures,
    this.facts,
    this.remarks,
  );

  constructor(private readonly goTo: (problem: Problem) => void) {}

  show(answer: Answer) {
    const words = stateOf(answer);
    if (this.state.textContent !== words) this.state.textContent = words;
    this.state.dataset.valid = String(answer.problems.length === 0);
    this.showProblems(answer.problems);
    // The last picture stays while the case is not valid.
    this.root.classList.toggle("kerf-old", answer.check === null);
    if (answer.check === null) return;
    this.pictures.replaceChildren(...(answer.drawings ?? []).map(drawing));
    const rows = (answer.facts ?? []).map(({ name, value }) =>
      element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, value)),
    );
    this.facts.replaceChildren(element("caption", {}, "Cost and regime"), ...rows);
    this.remarks.replaceChildren(
      ...list("Warnings", answer.check.warnings, "kerf-warnings"),
      ...list("What to change, as the run is long", answer.check.advice.map((one) => element("code", {}, one.keys.join("; ")))),
      ...list("What is simulated", answer.check.simulated),
    );
  }

  private showProblems(problems: Problem[]) {
    const entries = problems.map((problem) => {
      const place = problem.path || (problem.line > 0 ? `line ${problem.line}` : "");
      const link = element("button", { type: "button", className: "kerf-link", onclick: () => this.goTo(problem) }, place);
      const value = problem.path && problem.value ? ` = ${problem.value}` : "";
      return element("span", {}, ...(place ? [link, `${value}: `] : []), sentences(problem));
    });
    this.problems.replaceChildren(...list("Problems", entries));
  }
}
