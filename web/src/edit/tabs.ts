// SPDX-License-Identifier: Apache-2.0
// Tabs, by the pattern of the ARIA practices: arrow keys move between them.

import { element } from "../dom.ts";

export class Tabs {
  readonly bar = element("div", { className: "kerf-tabs", attributes: { role: "tablist", "aria-label": "Views of the case" } });
  private readonly tabs: { name: string; button: HTMLButtonElement; panel: HTMLElement }[] = [];

  constructor(private readonly opened: (name: string) => void) {
    this.bar.addEventListener("keydown", (event) => this.move(event));
  }

  add(name: string, label: string, panel: HTMLElement) {
    const button = element("button", { id: `kerf-tab-${name}`, type: "button" }, label);
    button.setAttribute("role", "tab");
    button.setAttribute("aria-controls", `kerf-panel-${name}`);
    button.addEventListener("click", () => this.open(name));
    panel.id = `kerf-panel-${name}`;
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", button.id);
    this.bar.append(button);
    this.tabs.push({ name, button, panel });
    if (this.tabs.length === 1) this.open(name);
    else panel.hidden = true;
  }

  open(name: string) {
    for (const tab of this.tabs) {
      const isOpen = tab.name === name;
      tab.panel.hidden = !isOpen;
      tab.button.setAttribute("aria-selected", String(isOpen));
      tab.button.tabIndex = isOpen ? 0 : -1;
    }
    this.opened(name);
  }

  private move(event: KeyboardEvent) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const at = this.tabs.findIndex((tab) => tab.button === document.activeElement);
    if (step === undefined || at < 0) return;
    const next = this.tabs[(at + step + this.tabs.length) % this.tabs.length]!;
    this.open(next.name);
    next.button.focus();
    event.preventDefault();
  }
}
