// SPDX-License-Identifier: Apache-2.0
// The form of a case: a part that folds for each table, with a field for each key that applies.

import { element } from "../dom.ts";
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
  private wasWritten = false;

  constructor(sentence: string) {
    this.root.append(element("summary", {}, this.heading, " ", this.state));
    this.root.append(element("p", { className: "kerf-help" }, sentence), this.main, this.others);
    this.others.append(element("summary", {}, "More keys"));
  }

  show(table: Table, fields: Field[], isMain: (field: Field) => boolean) {
    this.heading.textContent = table.heading;
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

export class Form {
  readonly root = element("form", { className: "kerf-form", autocomplete: "off" });
  private readonly parts = new Map<string, Part>();
  private readonly fields = new Map<string, Field>();

  constructor(
    private readonly schema: Schema,
    private readonly changed: (change: Change, delay: number) => void,
  ) {
    this.root.addEventListener("submit", (event) => event.preventDefault());
  }

  show(answer: Answer) {
    const tables = answer.tables;
    this.root.toggleAttribute("inert", tables === null);
    if (tables === null) return;
    const materials = this.materialsOf(tables);
    const problems = new Map(answer.problems.map((problem) => [problem.path, problem]));
    for (const table of tables) this.showTable(table, materials, problems);
    const known = new Set(tables.map((table) => table.path));
    for (const [path, part] of this.parts)
      if (!known.has(path)) {
        part.root.remove();
        this.parts.delete(path);
      }
    this.order(tables);
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
    if (!part) this.parts.set(table.path, (part = new Part(section.sentence)));
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

  // Moves only what is not in its place, as a field that is moved loses the cursor.
  private order(tables: Table[]) {
    const wanted = tables.map((table) => this.parts.get(table.path)!.root);
    wanted.forEach((root, at) => {
      if (this.root.children[at] !== root) this.root.insertBefore(root, this.root.children[at] ?? null);
    });
  }
}
