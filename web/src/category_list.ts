// SPDX-License-Identifier: Apache-2.0
// Which states of the matter are shown, and how; at the same time the legend of their colours.

import { element } from "./dom.ts";
import type { Showing } from "./points.ts";
import type { Category } from "./run.ts";

interface Row {
  shown: HTMLInputElement;
  faint: HTMLInputElement;
}

export class CategoryList {
  readonly root = element("div", { className: "kerf-group", id: "kerf-categories" });
  private rows: Row[] = [];
  private categories: Category[] = [];

  /** Ghosts are of use where something is behind them: in 3D. */
  constructor(
    categories: Category[],
    private readonly withFaint: boolean,
    private readonly changed: () => void,
  ) {
    this.root.setAttribute("role", "group");
    this.root.setAttribute("aria-label", "State of the matter");
    this.setCategories(categories);
  }

  get showing(): Showing[] {
    return this.rows.map(({ shown, faint }) => (!shown.checked ? "hidden" : faint.checked ? "faint" : "full"));
  }

  setCategories(categories: Category[]) {
    if (JSON.stringify(categories) === JSON.stringify(this.categories)) return;
    this.categories = categories;
    this.root.replaceChildren();
    this.rows = categories.map((category, at) => this.add(category, at));
  }

  private add(category: Category, at: number): Row {
    const shown = element("input", { type: "checkbox", checked: true, id: `kerf-category-${at}` });
    const faint = element("input", { type: "checkbox", checked: category.faint });
    faint.setAttribute("aria-label", `${category.label} faint`);
    const dot = element("i", { className: "kerf-dot" });
    dot.style.background = category.colour;
    const aside = element("label", { className: "kerf-soft", hidden: !this.withFaint }, faint, "faint");
    const refresh = () => {
      faint.disabled = !shown.checked;
      dot.classList.toggle("kerf-dot-faint", faint.checked);
    };
    shown.onchange = faint.onchange = () => {
      refresh();
      this.changed();
    };
    refresh();
    this.root.append(element("div", { className: "kerf-line" }, element("label", {}, shown, dot, category.label), aside));
    return { shown, faint };
  }
}
