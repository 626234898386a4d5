// SPDX-License-Identifier: Apache-2.0
// The form of a case: a part that folds for each table, with a field for each key that applies.

import { element } from "../dom.ts";
import { Adder } from "./adder.ts";
import { Field, type Material } from "./field.ts";
import type { Answer, Change, Key, Problem, Schema, Table } from "./protocol.ts";

// What an operator sets. Its parts are open at first, and show these keys besides those that are
// required or written.
const mainKeys: Record<string, string[]> = {
  machine: ["orifice_type", "lead_angle", "traverse_speed"],
  workpiece: [],
  "": ["quality"],
};

class Part {
  readonly root = element("details", { className: "kerf-part" });
  private readonly main = element("div");
  private readonly others = element("details", { className: "kerf-others" });
  private readonly heading = element("span");
  private readonly state = element("span", { className: "kerf-soft" });
  private readonly remover = element("button", { type: "button", className: "kerf-remove" }, "Remove");
  private table: Table | undefined;
  private wasWritten = false;

  constructor(sentence: string, remove: (table: Table) => void) {
    this.root.append(element("summary", {}, this.heading, " ", this.state));
    this.root.append(element("p", { className: "kerf-help" }, sentence), this.main, this.others, this.remover);
    this.others.append(element("summary", {}, "More keys"));
    this.remover.addEventListener("click", () => this.table && remove(this.table));
  }

  /** Opens the part and puts the cursor into its first field. */
  open() {
    this.root.open = true;
    this.root.querySelector<HTMLElement>(".kerf-field input, .kerf-field select")?.focus();
    this.root.scrollIntoView({ block: "center" });
  }

  show(table: Table, fields: Field[], isMain: (field: Field) => boolean) {
    this.table = table;
    this.heading.textContent = table.heading;
    this.remover.hidden = table.removable !== true;
    this.remover.textContent = `Remove ${table.heading}`;
    this.state.textContent = table.written ? "" : "not in the case";
    if (table.written && !this.wasWritten && table.section in mainKeys) this.root.open = true;
    this.wasWritten = table.written;
    for (const field of fields) {
      const wanted = isMain(field) ? this.main : this.others;
      if (field.root.parentElement !== wanted) wanted.append(field.root);
    }
    const kept = new Set<Element>(fields.map((field) => field.root));
    for (const root of this.root.querySelectorAll(".kerf-field")) if (!kept.has(root)) root.remove();
    this.others.hidden = this.others.childElementCount === 1;
  }
}

/** What the form asks for, besides changes of values. */
export interface TableActions {
  add(section: string, name: string): void;
  remove(table: Table): void;
}

export class Form {
  readonly root = element("form", { className: "kerf-form", autocomplete: "off" });
  private readonly parts = new Map<string, Part>();
  private readonly fields = new Map<string, Field>();
  private readonly adders = new Map<string, Adder>();

  constructor(
    private readonly schema: Schema,
    private readonly changed: (change: Change, delay: number) => void,
    private readonly actions: TableActions,
  ) {
    this.root.addEventListener("submit", (event) => event.preventDefault());
  }

  show(answer: Answer) {
    const tables = answer.tables;
    this.root.toggleAttribute("inert", tables === null);
    if (tables === null) return;
    const written = tables.filter((table) => !table.adds);
    const materials = this.materialsOf(written);
    const problems = new Map(answer.problems.map((problem) => [problem.path, problem]));
    for (const table of written) this.showTable(table, materials, problems);
    const known = new Set(written.map((table) => table.path));
    for (const [path, part] of this.parts)
      if (!known.has(path)) {
        part.root.remove();
        this.parts.delete(path);
      }
    this.order(tables.map((table) => (table.adds ? this.adder(table).root : this.parts.get(table.path)!.root)));
  }

  /** Opens a table and puts the cursor into its first field. */
  goToTable(path: string) {
    this.parts.get(path)?.open();
  }

  /** Puts the cursor on the button that adds another table of a section. */
  goToAdder(section: string) {
    this.adders.get(section)?.button.focus();
  }

  /** Shows the field of a key and puts the cursor there. Returns false where there is none. */
  goTo(path: string): boolean {
    const field = this.fields.get(path);
    if (!field?.root.isConnected) return false;
    for (let around = field.root.closest("details"); around; around = around.parentElement!.closest("details"))
      around.open = true;
    field.input.focus();
    field.root.scrollIntoView({ block: "center" });
    return true;
  }

  private showTable(table: Table, materials: Material[], problems: Map<string, Problem>) {
    const section = this.schema.sections.find((one) => one.name === table.section)!;
    let part = this.parts.get(table.path);
    if (!part) this.parts.set(table.path, (part = new Part(section.sentence, this.actions.remove)));
    const values = new Map(table.keys.map((key) => [key.path, key.value]));
    const fields = table.keys.map(({ row, path }) => this.field(table, section.keys[row]!, path));
    for (const field of fields) {
      field.setMaterials(materials);
      field.setValue(values.get(field.path)!);
      field.setProblem(problems.get(field.path));
    }
    const main = mainKeys[table.section] ?? [];
    part.show(table, fields, (field) => {
      const key = section.keys[table.keys.find((one) => one.path === field.path)!.row]!;
      const isAtWork = field.root.isConnected && field.input === document.activeElement;
      if (isAtWork) return field.root.parentElement!.tagName === "DIV";
      return key.required || main.includes(key.name) || values.get(field.path) !== "" || problems.has(field.path);
    });
  }

  private field(table: Table, key: Key, path: string): Field {
    // Rows of one name have other defaults and ranges.
    const known = this.fields.get(path);
    if (known && known.key === key) return known;
    known?.root.remove();
    const made = new Field(path, key, (value, delay) => this.changed({ section: table.section, path, value }, delay));
    this.fields.set(path, made);
    return made;
  }

  private materialsOf(tables: Table[]): Material[] {
    const own = tables
      .filter((table) => table.section === "materials")
      .map((table) => ({ name: table.path.slice("materials.".length), kind: "", title: "of this case" }));
    const names = new Set(own.map((one) => one.name));
    return [...own, ...this.schema.materials.filter((one) => !names.has(one.name))];
  }

  private adder(table: Table): Adder {
    let adder = this.adders.get(table.section);
    if (!adder) {
      adder = new Adder(table.section, table.heading, table.asks_name === true, this.actions.add);
      this.adders.set(table.section, adder);
    }
    return adder;
  }

  // Moves only what is not in its place, as a field that is moved loses the cursor.
  private order(wanted: HTMLElement[]) {
    wanted.forEach((root, at) => {
      if (this.root.children[at] !== root) this.root.insertBefore(root, this.root.children[at] ?? null);
    });
    while (this.root.children.length > wanted.length) this.root.lastElementChild!.remove();
  }
}
