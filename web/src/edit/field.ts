// SPDX-License-Identifier: Apache-2.0
// One key of the case: its label, input, help and problem.

import { element } from "../dom.ts";
import { sentences, type Key, type Problem } from "./protocol.ts";

export interface Material {
  name: string;
  kind: string;
  title: string;
}

export const fieldId = (path: string) => `kerf-key-${path}`;

export class Field {
  readonly root: HTMLElement;
  readonly input: HTMLInputElement | HTMLSelectElement;
  private readonly fault: HTMLElement;
  private readonly materialTitle: HTMLElement | undefined;
  private materials: Material[] = [];

  constructor(
    readonly path: string,
    readonly key: Key,
    changed: (value: string, delay: number) => void,
  ) {
    const id = fieldId(path);
    const isChoice = key.choices !== undefined || key.material !== undefined;
    this.input = isChoice ? element("select", { id }) : element("input", { id, type: "text", spellcheck: false });
    this.input.setAttribute("aria-describedby", `${id}-fault ${id}-help`);
    if (key.required) this.input.setAttribute("aria-required", "true");
    this.fault = element("p", { id: `${id}-fault`, className: "kerf-fault", hidden: true });
    this.materialTitle = key.material === undefined ? undefined : element("p", { className: "kerf-material" });
    const label = element("label", { htmlFor: id }, key.label);
    if (key.required) label.append(element("span", { className: "kerf-soft" }, " required"));
    this.root = element(
      "div",
      { className: "kerf-field" },
      label,
      element("div", {}, this.input, ...(this.materialTitle ? [this.materialTitle] : []), this.fault, this.help(id)),
    );
    if (this.input instanceof HTMLInputElement) this.input.placeholder = key.default;
    if (key.choices) this.offer(key.choices.map((word) => [word, word]));
    const typingDelay = 350; // ms
    this.input.addEventListener("input", () => changed(this.input.value, isChoice ? 0 : typingDelay));
  }

  /** The materials that the key may name: those of the library and of the case. */
  setMaterials(materials: Material[]) {
    const kind = this.key.material;
    if (kind === undefined) return;
    this.materials = materials.filter((one) => kind === "" || one.kind === "" || one.kind === kind);
    this.offer(this.materials.map((one) => [one.name, one.title ? `${one.name}: ${one.title}` : one.name]));
  }

  /** Shows a value of the text, unless the user is at work on it. */
  setValue(value: string) {
    if (document.activeElement === this.input && this.input instanceof HTMLInputElement) return;
    if (this.input instanceof HTMLSelectElement && ![...this.input.options].some((one) => one.value === value))
      this.input.append(element("option", { value }, value));
    if (this.input.value !== value) this.input.value = value;
    const title = this.materials.find((one) => one.name === (value || this.key.default))?.title;
    if (this.materialTitle) this.materialTitle.textContent = title ?? "";
  }

  setProblem(problem: Problem | undefined) {
    const words = problem ? sentences(problem) : "";
    if (this.fault.textContent !== words) this.fault.textContent = words;
    this.fault.hidden = !problem;
    if (problem) this.input.setAttribute("aria-invalid", "true");
    else this.input.removeAttribute("aria-invalid");
  }

  private help(id: string): HTMLElement {
    const allowed = this.key.choices || this.key.material !== undefined ? "" : ` Allowed: ${this.key.allowed}.`;
    return element("p", { id: `${id}-help`, className: "kerf-help" }, `${this.key.help}${allowed}`);
  }

  private offer(options: [value: string, label: string][]) {
    const select = this.input as HTMLSelectElement;
    const value = select.value;
    const standard = this.key.default === "" ? "choose" : `default: ${this.key.default}`;
    const made = [["", standard], ...options].map(([one, label]) => element("option", { value: one }, label as string));
    select.replaceChildren(...made);
    select.value = value;
  }
}
