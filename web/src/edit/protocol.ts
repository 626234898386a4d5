// SPDX-License-Identifier: Apache-2.0
// What the server of `kerf view --edit` takes and answers (web/README.md).

export interface Key {
  name: string;
  label: string;
  unit: string;
  allowed: string;
  default: string;
  required: boolean;
  help: string;
  choices?: string[];
  material?: string; // the kind of material that the key names; "" = every kind
}

export interface Schema {
  sections: { name: string; sentence: string; keys: Key[] }[];
  materials: { name: string; kind: string; title: string }[];
  templates: { name: string; title: string }[];
}

export interface Table {
  section: string;
  path: string;
  heading: string;
  written: boolean;
  removable?: boolean;
  adds?: boolean; // no table, but the place where another one of its section is added
  asks_name?: boolean; // of the new table
  keys: { row: number; path: string; value: string }[];
}

export interface Problem {
  path: string;
  line: number;
  value: string;
  what: string;
  allowed: string;
  remedy: string;
}

export interface Change {
  section: string;
  path: string;
  value: string;
}

export interface Answer {
  text: string;
  tables: Table[] | null;
  problems: Problem[];
  check: { simulated: string[]; warnings: string[]; advice: { keys: string[] }[] } | null;
  facts?: { name: string; value: string }[];
  drawings?: { title: string; svg: string }[];
}

export interface CaseFile {
  file: string;
  text: string | null;
}

export interface RunState {
  state: "none" | "running" | "completed" | "stopped" | "failed";
  folder: string; // of the results of the next run
  results?: string; // the folder of this run
  changes?: string[]; // what a pilot run has other than the case
  output?: string;
  view?: string;
}

async function answerOf<T>(address: string, options: RequestInit): Promise<T> {
  let answer: Response;
  try {
    answer = await fetch(address, { cache: "no-store", ...options });
  } catch {
    throw new Error("The server does not answer. Does kerf view --edit still run?");
  }
  if (!answer.ok) throw new Error((await answer.text()) || `answer ${answer.status}`);
  return (await answer.json()) as T;
}

export function ask<T>(address: string): Promise<T> {
  return answerOf<T>(address, {});
}

export function tell<T>(address: string, body: unknown): Promise<T> {
  const headers = { "Content-Type": "application/json" };
  return answerOf<T>(address, { method: "POST", headers, body: JSON.stringify(body) });
}

/** A problem as one sentence after the other. */
export function sentences(problem: Problem): string {
  const ends = (words: string) => (/[.?!]$/.test(words) ? words : `${words}.`);
  const parts = [ends(problem.what)];
  if (problem.allowed) parts.push(`Allowed: ${ends(problem.allowed)}`);
  if (problem.remedy) parts.push(ends(problem.remedy));
  return parts.join(" ");
}
