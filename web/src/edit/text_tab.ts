// SPDX-License-Identifier: Apache-2.0
// The case as TOML text, which holds also what the form cannot show.

import { element } from "../dom.ts";

export class TextTab {
  readonly area = element("textarea", {
    id: "kerf-text",
    spellcheck: false,
    wrap: "off",
    attributes: { "aria-label": "The case as TOML text", autocapitalize: "off" },
  });
  readonly root = element(
    "div",
    { className: "kerf-text" },
    element("p", { className: "kerf-help" }, "The form and this text are one: a change in the one shows in the other. ",
      "What has no field, such as the corners of a polygon, is written here."),
    this.area,
  );

  constructor(changed: (text: string, delay: number) => void) {
    const typingDelay = 500; // ms
    this.area.addEventListener("input", () => changed(this.area.value, typingDelay));
  }

  /** Shows a text; the cursor stays where it is. */
  show(text: string) {
    if (this.area.value === text) return;
    const { selectionStart, selectionEnd, scrollTop } = this.area;
    this.area.value = text;
    this.area.setSelectionRange(selectionStart, selectionEnd);
    this.area.scrollTop = scrollTop;
  }

  goTo(line: number) {
    const lines = this.area.value.split("\n");
    const start = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
    this.area.focus();
    this.area.setSelectionRange(start, start + (lines[line - 1]?.length ?? 0));
    this.area.scrollTop = (this.area.scrollHeight / Math.max(lines.length, 1)) * Math.max(0, line - 6);
  }
}
