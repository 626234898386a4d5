// SPDX-License-Identifier: Apache-2.0
// All runs, sorted by the column that is clicked on.

import { element } from "../dom.ts";
import { formatNumber } from "../quantities.ts";
import type { Quantities } from "./quantity.ts";
import { numberOf, type StudyData, type StudyRun } from "./study_data.ts";
import { inlineSymbol, verdictOf, verdictOrder, verdictWords } from "./verdict.ts";

interface Column {
  name: string; // in study.json
  title: string;
  unit: string;
  help?: string;
  isNumber: boolean;
  value: (run: StudyRun) => number | string | undefined; // to sort by; SI
  show: (run: StudyRun) => Node | string;
}

function quantityColumn(name: string, quantities: Quantities, value: Column["value"]): Column {
  const { factor } = quantities.get(name);
  const show = (run: StudyRun) => {
    const found = value(run);
    return typeof found === "number" ? formatNumber(found / factor, 4) : (found ?? "–");
  };
  const { label, unit, help } = quantities.get(name);
  return { name, title: label, unit, help, isNumber: true, value, show };
}

function verdictColumn(): Column {
  const show = (run: StudyRun) => element("span", { className: "kerf-verdict" }, inlineSymbol(verdictOf(run)), ` ${verdictWords[verdictOf(run)]}`);
  return { name: "state", title: "verdict", unit: "", isNumber: false, value: (run) => verdictOrder.indexOf(verdictOf(run)), show };
}

function reportLink(run: StudyRun): Node | string {
  if (!run.report) return "";
  return element("a", { href: run.report, attributes: { "aria-label": `Report of run ${run.id}` } }, "report");
}

function columnsOf(data: StudyData, quantities: Quantities): Column[] {
  const { study } = data;
  const columns = [verdictColumn()];
  columns.push({ name: "report", title: "run", unit: "", isNumber: false, value: (run) => run.id, show: reportLink });
  for (const { key } of study.keys) columns.push(quantityColumn(key, quantities, (run) => run.setting[key]));
  columns.push(quantityColumn("spacing", quantities, (run) => numberOf(run, "spacing")));
  if (study.runs.some((run) => run.repeat > 0)) {
    columns.push({ name: "repeat", title: "layout", unit: "", isNumber: true, value: (run) => run.repeat, show: (run) => String(run.repeat + 1) });
  }
  for (const { name } of study.metrics) {
    const isKnown = name !== "cut_through" && study.runs.some((run) => numberOf(run, name) !== undefined);
    if (isKnown) columns.push(quantityColumn(name, quantities, (run) => numberOf(run, name)));
  }
  if (study.runs.some((run) => run.error !== "")) {
    const show = (run: StudyRun) => element("span", { className: "kerf-error-text" }, run.error);
    columns.push({ name: "error", title: "error", unit: "", isNumber: false, value: (run) => run.error, show });
  }
  return columns;
}

function compare(a: number | string | undefined, b: number | string | undefined): number {
  if (typeof a === "number" && typeof b === "number") return a - b;
  return String(a).localeCompare(String(b));
}

export class RunTable {
  readonly root: HTMLElement;
  private readonly columns: Column[];
  private readonly body = element("tbody");
  private readonly heads: HTMLTableCellElement[];
  private readonly rows: { run: StudyRun; row: HTMLTableRowElement }[];
  private sorted: { by: number; descending: boolean } | undefined;

  constructor(data: StudyData, quantities: Quantities) {
    this.columns = columnsOf(data, quantities);
    this.heads = this.columns.map((column, at) => this.head(column, at));
    this.rows = data.study.runs.map((run) => ({ run, row: this.row(run) }));
    this.body.append(...this.rows.map(({ row }) => row));
    const table = element("table", { id: "kerf-runs" }, element("thead", {}, element("tr", {}, ...this.heads)), this.body);
    this.root = element("div", { className: "kerf-scroll", tabIndex: 0, attributes: { role: "region", "aria-label": "All runs" } }, table);
  }

  private head(column: Column, at: number): HTMLTableCellElement {
    const button = element("button", { type: "button", title: column.help ? `${column.help} Click to sort.` : "Sort" }, column.title, element("i", { attributes: { "aria-hidden": "true" } }));
    if (column.unit !== "") button.append(element("span", { className: "kerf-soft" }, column.unit));
    button.addEventListener("click", () => this.sort(at));
    const cell = element("th", { scope: "col", className: column.isNumber ? "kerf-number" : "" }, button);
    cell.dataset.column = column.name;
    return cell;
  }

  private row(run: StudyRun): HTMLTableRowElement {
    const row = element("tr");
    row.dataset.run = run.id;
    for (const column of this.columns) {
      const cell = element("td", { className: column.isNumber ? "kerf-number" : "" }, column.show(run));
      cell.dataset.column = column.name;
      const value = column.value(run);
      if (value !== undefined && column.isNumber) cell.dataset.value = String(value);
      row.append(cell);
    }
    return row;
  }

  private sort(by: number) {
    const descending = this.sorted?.by === by && !this.sorted.descending;
    this.sorted = { by, descending };
    const { value } = this.columns[by];
    const none = (run: StudyRun) => value(run) === undefined;
    // What has no value stands last, whichever way.
    this.rows.sort((a, b) => Number(none(a.run)) - Number(none(b.run)) || (descending ? -1 : 1) * compare(value(a.run), value(b.run)));
    this.body.append(...this.rows.map(({ row }) => row));
    this.heads.forEach((head, at) => {
      if (at === by) head.setAttribute("aria-sort", descending ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
  }
}
