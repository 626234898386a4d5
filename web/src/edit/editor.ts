// SPDX-License-Identifier: Apache-2.0
// The page of `kerf view --edit`: the form, the text and the run of a case, and what its check says.

import { element, note, selection } from "../dom.ts";
import { AnswerPanel } from "./answer_panel.ts";
import { Checker } from "./checker.ts";
import { Form } from "./form.ts";
import { tell, type Answer, type CaseFile, type Problem, type Schema, type Table } from "./protocol.ts";
import { RunTab } from "./run_tab.ts";
import { Tabs } from "./tabs.ts";
import { TextTab } from "./text_tab.ts";

export class Editor {
  private readonly checker = new Checker((answer) => this.arrived(answer), (reason) => this.complain(reason));
  private readonly form: Form;
  private readonly text = new TextTab((text, delay) => this.typed(() => this.checker.setText(text, delay)));
  private readonly run = new RunTab(() => this.save());
  private readonly answer = new AnswerPanel((problem) => this.goTo(problem));
  private readonly tabs = new Tabs((name) => this.root?.setAttribute("data-tab", name));
  private readonly fileName = element("input", { id: "kerf-file", type: "text", spellcheck: false });
  private readonly saveButton = element("button", { id: "kerf-save-case", type: "button" }, "Save");
  private readonly pilotButton = element("button", { id: "kerf-pilot", type: "button" }, "Pilot run");
  private readonly saved = element("span", { id: "kerf-saved", className: "kerf-soft", attributes: { role: "status" } });
  private readonly messages = element("div");
  readonly root: HTMLElement;
  private before: string | null; // what the file holds, as far as this page knows

  constructor(private readonly schema: Schema, private file: CaseFile) {
    this.before = file.text;
    const actions = {
      add: (section: string, name: string) => void this.add(section, name),
      remove: (table: Table) => void this.remove(table),
    };
    this.form = new Form(schema, (change, delay) => this.typed(() => this.checker.change(change, delay)), actions);
    const formPanel = element("div", {}, ...(file.text === null ? [this.templates()] : []), this.form.root);
    this.tabs.add("form", "Form", formPanel);
    this.tabs.add("text", "Text", this.text.root);
    this.tabs.add("run", "Run", this.run.root);
    this.saveButton.addEventListener("click", () => void this.save());
    this.pilotButton.title = "Runs the case as it stands here in draft quality for about half a minute, without saving it";
    this.pilotButton.addEventListener("click", () => void this.pilot());
    const left = element("div", { className: "kerf-left" }, formPanel, this.text.root, this.run.root);
    this.root = element("div", { className: "kerf-editor", attributes: { "data-tab": "form" } }, this.head(), left, this.answer.root);
    window.addEventListener("beforeunload", (event) => this.isSaved() || event.preventDefault());
    document.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.key !== "s") return;
      event.preventDefault();
      void this.save();
    });
  }

  start() {
    this.showFile();
    this.text.show(this.file.text ?? "");
    this.checker.setText(this.file.text ?? "");
    void this.run.look();
  }

  private head(): HTMLElement {
    const bar = element("div", { className: "kerf-bar-line" }, this.tabs.bar, this.answer.state);
    const name = element("div", { className: "kerf-name" }, element("h1", {}, "Case"), element("label", {}, "File ", this.fileName), this.saveButton, this.pilotButton, this.saved);
    return element("header", { className: "kerf-head" }, name, bar, this.messages);
  }

  private templates(): HTMLElement {
    const options = this.schema.templates.map(({ name, title }): [string, string] => [name, `${name}: ${title}`]);
    const choice = selection("kerf-template", [["", "choose"], ...options], "");
    choice.addEventListener("input", () => void this.begin(choice.value));
    return element("p", { className: "kerf-templates" }, element("label", {}, "Begin with a template ", choice));
  }

  private async begin(name: string) {
    if (name === "") return;
    try {
      const { text, notes } = await tell<{ text: string; notes: string[] }>("template", { name });
      if (!this.file.file && this.fileName.value === "") this.fileName.value = `${name}.toml`;
      note(this.messages, notes.join(" "), "note");
      this.text.show(text);
      this.typed(() => this.checker.setText(text));
    } catch (error) {
      this.complain((error as Error).message);
    }
  }

  private async add(section: string, name: string) {
    let path = "";
    const made = await this.rewrite(async (text) => {
      const answer = await tell<{ text: string; path: string }>("add", { text, section, name });
      path = answer.path;
      return answer.text;
    });
    if (!made) return;
    this.form.goToTable(path);
    note(this.messages, `${path} was added, with values to start from.`, "note");
  }

  private async remove(table: Table) {
    let before = "";
    const done = await this.rewrite(async (text) => {
      before = text;
      return (await tell<{ text: string }>("remove", { text, path: table.path })).text;
    });
    if (!done) return;
    this.form.goToAdder(table.section);
    const undo = element("button", { id: "kerf-undo", type: "button" }, "Undo");
    undo.addEventListener("click", () => {
      this.typed(() => this.checker.setText(before));
      note(this.messages, `${table.heading} is back.`, "note");
      this.form.goToAdder(table.section);
    });
    note(this.messages, `${table.heading} was removed. `, "note");
    this.messages.querySelector(".kerf-message")?.append(undo);
  }

  private async rewrite(make: (text: string) => Promise<string>): Promise<boolean> {
    try {
      await this.checker.rewrite(make);
    } catch (error) {
      this.complain((error as Error).message);
      return false;
    }
    return true;
  }

  private async pilot() {
    await this.checker.settled();
    this.tabs.open("run");
    await this.run.pilot(this.checker.text);
  }

  private typed(action: () => void) {
    if (this.messages.querySelector("#kerf-undo")) note(this.messages, ""); // it would undo this as well
    action();
    this.saved.textContent = "not saved";
  }

  private arrived(answer: Answer) {
    this.text.show(answer.text);
    this.form.show(answer);
    this.answer.show(answer);
    this.showSaved();
  }

  private isSaved(): boolean {
    return this.checker.text === (this.before ?? "");
  }

  private showSaved() {
    this.saved.textContent = this.isSaved() ? (this.before === null ? "" : "saved") : "not saved";
  }

  private showFile() {
    this.fileName.readOnly = this.file.file !== "";
    if (this.file.file !== "") this.fileName.value = this.file.file;
    this.fileName.placeholder = "my.toml";
    document.title = `Kerf: ${this.file.file || "new case"}`;
  }

  private async save(): Promise<boolean> {
    await this.checker.settled();
    const request = { text: this.checker.text, before: this.before, file: this.fileName.value.trim() };
    try {
      this.file = await tell<CaseFile>("save", request);
    } catch (error) {
      this.complain((error as Error).message);
      return false;
    }
    this.before = this.file.text;
    note(this.messages, "");
    this.showFile();
    this.showSaved();
    void this.run.look();
    return true;
  }

  private goTo(problem: Problem) {
    this.tabs.open("form");
    if (this.form.goTo(problem.path)) return;
    this.tabs.open("text");
    this.text.goTo(problem.line);
  }

  private complain(words: string) {
    note(this.messages, words);
  }
}
