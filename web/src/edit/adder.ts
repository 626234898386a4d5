// SPDX-License-Identifier: Apache-2.0
// The places of the form where another body, jet, load, probe or material is added.

import { element } from "../dom.ts";

const article = (word: string) => (/^[aeiou]/.test(word) ? "an" : "a");

export class Adder {
  readonly button: HTMLButtonElement;
  readonly root: HTMLElement;

  /** The name of a material is in the heading of its table, so it is asked for here. */
  constructor(
    readonly section: string,
    word: string,
    asksName: boolean,
    add: (section: string, name: string) => void,
  ) {
    this.button = element("button", { id: `kerf-add-${section}`, type: "button" }, `Add ${article(word)} ${word}`);
    this.root = element("div", { className: "kerf-adder" }, this.button);
    const name = element("input", { id: `kerf-name-of-new-${section}`, type: "text", spellcheck: false, placeholder: `${word}-1` });
    if (asksName) this.root.append(element("label", {}, `Name of the new ${word} `, name));
    const act = () => {
      add(section, name.value.trim());
      name.value = "";
    };
    this.button.addEventListener("click", act);
    name.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      act();
    });
  }
}
