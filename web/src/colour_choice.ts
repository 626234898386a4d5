// SPDX-License-Identifier: Apache-2.0
// What the colours show: the material, or one field.

import { element, selection } from "./dom.ts";
import { legendOf } from "./legend.ts";
import type { Field } from "./run.ts";

const byMaterial = "material";

export class ColourChoice {
  readonly root: HTMLElement;
  private fields: Field[] = [];
  private key = byMaterial;
  private readonly select = selection("kerf-colour", [[byMaterial, "material"]], byMaterial);
  private readonly legend = element("div", { id: "kerf-legend" });

  constructor(fields: Field[], changed: () => void) {
    this.select.onchange = () => {
      this.key = this.select.value;
      this.refresh();
      changed();
    };
    this.root = element(
      "div",
      { className: "kerf-group" },
      element("label", { htmlFor: "kerf-colour" }, "Colour by"),
      this.select,
      this.legend,
    );
    this.setFields(fields);
  }

  /** The number of the field; -1 for the material. */
  get index(): number {
    return this.fields.findIndex((field) => field.key === this.key);
  }

  get field(): Field | undefined {
    return this.fields[this.index];
  }

  setFields(fields: Field[]) {
    this.fields = fields;
    const options: [string, string][] = fields.map((field) => [field.key, field.label]);
    this.select.replaceChildren(...selection("", [[byMaterial, "material"], ...options], "").options);
    if (this.index < 0) this.key = byMaterial;
    this.select.value = this.key;
    this.refresh();
  }

  private refresh() {
    const { field } = this;
    this.legend.replaceChildren(...(field ? [legendOf(field)] : []));
  }
}
