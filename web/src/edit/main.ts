// SPDX-License-Identifier: Apache-2.0
// The page of `kerf view --edit`: finds its place and fills it.

import "../style.css";
import "./style.css";

import { note } from "../dom.ts";
import { Editor } from "./editor.ts";
import { ask, type CaseFile, type Schema } from "./protocol.ts";

async function start() {
  const place = document.getElementById("kerf-edit");
  if (!place) return;
  try {
    const editor = new Editor(await ask<Schema>("schema"), await ask<CaseFile>("case"));
    place.replaceChildren(editor.root);
    editor.start();
  } catch (error) {
    note(place, `The case cannot be edited: ${(error as Error).message}`);
  }
}

// The script stands behind its place.
void start();
