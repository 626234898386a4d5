// SPDX-License-Identifier: Apache-2.0
// The page of a study: finds its place and fills it. What fails leaves the static page and says why.

import "./style.css";

import { note, setFallbackAside } from "../dom.ts";
import { StudyPage } from "./study_page.ts";
import { readStudyData } from "./study_data.ts";

function start() {
  const place = document.getElementById("kerf-study");
  const source = document.getElementById("kerf-study-data");
  if (!place || !source) return;
  setFallbackAside(place);
  try {
    const page = new StudyPage(readStudyData(source.textContent ?? ""));
    place.append(page.root);
    place.classList.add("kerf-enhanced");
    page.start();
  } catch (error) {
    note(place, `The study cannot be shown as it should: ${error instanceof Error ? error.message : String(error)}.`);
  }
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
