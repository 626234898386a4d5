// SPDX-License-Identifier: Apache-2.0
// What the page hands to the viewer, and the checks it goes through. README.md describes the format.

export interface Category {
  label: string;
  colour: string; // #rrggbb
  faint: boolean; // shown as a ghost at first
}

export interface Range {
  minimum: number;
  maximum: number;
}

export interface Field extends Range {
  key: string;
  label: string;
  unit: string;
  names?: string[]; // of the groups that the values number, from 0
}

export interface Frame {
  time: number; // s
  count: number;
  data?: string; // base64
  url?: string;
  ranges?: Range[]; // of its bytes, where they are not those of the fields
}

export type Point = [number, number, number]; // m

/** A plane of symmetry, at right angles to an axis: what is on one side of it is not in the data. */
export interface Mirror {
  axis: 0 | 1 | 2;
  place: number; // m
}

export interface Run {
  title: string;
  dimension: 2 | 3;
  live: boolean;
  minimum: Point;
  maximum: Point;
  mirrors: Mirror[]; // one for an axis at most
  categories: Category[];
  spacings: number[]; // m
  fields: Field[];
  frames: Frame[];
}

export class RunError extends Error {}

type Json = Record<string, unknown>;

export function refuse(place: string, expected: string): never {
  throw new RunError(`${place} should be ${expected}`);
}

export function object(value: unknown, place: string): Json {
  if (typeof value !== "object" || value === null || Array.isArray(value)) refuse(place, "an object");
  return value as Json;
}

export function list(value: unknown, place: string): unknown[] {
  if (!Array.isArray(value)) refuse(place, "a list");
  return value;
}

export function text(value: unknown, place: string): string {
  if (typeof value !== "string") refuse(place, "a text");
  return value;
}

export function number(value: unknown, place: string): number {
  if (typeof value !== "number" || !Number.isFinite(value)) refuse(place, "a finite number");
  return value;
}

function point(value: unknown, place: string): Point {
  const numbers = list(value, place).map((part, axis) => number(part, `${place}[${axis}]`));
  if (numbers.length !== 3) refuse(place, "three numbers");
  return numbers as Point;
}

function range(value: unknown, place: string): Range {
  const part = object(value, place);
  const minimum = number(part.minimum, `${place}.minimum`);
  const maximum = number(part.maximum, `${place}.maximum`);
  if (maximum < minimum) refuse(`${place}.maximum`, "no less than its minimum");
  return { minimum, maximum };
}

const rigid = /rigid|plate|nozzle|clamp|wall|table/i;

function category(value: unknown, place: string, dimension: number): Category {
  const part = object(value, place);
  const label = text(part.label, `${place}.label`);
  const colour = text(part.colour, `${place}.colour`);
  if (!/^#[0-9a-f]{6}$/i.test(colour)) refuse(`${place}.colour`, "like #5cc48a");
  const wish = part.faint;
  const faint = typeof wish === "boolean" ? wish : dimension === 3 && rigid.test(label);
  return { label, colour, faint };
}

function mirror(value: unknown, place: string): Mirror {
  const part = object(value, place);
  const axis = number(part.axis, `${place}.axis`);
  if (axis !== 0 && axis !== 1 && axis !== 2) refuse(`${place}.axis`, "0, 1 or 2");
  return { axis, place: number(part.place, `${place}.place`) };
}

function field(value: unknown, place: string): Field {
  const part = object(value, place);
  const names = part.names === undefined ? undefined : list(part.names, `${place}.names`).map((one, at) => text(one, `${place}.names[${at}]`));
  if (names && (names.length === 0 || names.length > 256)) refuse(`${place}.names`, "1 to 256 texts");
  return {
    ...(names && { names }),
    key: text(part.key, `${place}.key`),
    label: text(part.label, `${place}.label`),
    unit: text(part.unit, `${place}.unit`),
    ...range(value, place),
  };
}

function frame(value: unknown, place: string, fieldCount: number): Frame {
  const part = object(value, place);
  const count = number(part.count, `${place}.count`);
  if (!Number.isInteger(count) || count < 0) refuse(`${place}.count`, "a whole number, 0 or more");
  const made: Frame = { time: number(part.time, `${place}.time`), count };
  if (part.data !== undefined) made.data = text(part.data, `${place}.data`);
  else made.url = text(part.url, `${place}.data or .url`);
  if (part.ranges !== undefined) {
    made.ranges = list(part.ranges, `${place}.ranges`).map((one, at) => range(one, `${place}.ranges[${at}]`));
    if (made.ranges.length !== fieldCount) refuse(`${place}.ranges`, `one for each of ${fieldCount} fields`);
  }
  return made;
}

function each<T>(value: unknown, place: string, read: (part: unknown, place: string) => T): T[] {
  return list(value, place).map((part, at) => read(part, `${place}[${at}]`));
}

export function readJson(source: string): Json {
  try {
    return object(JSON.parse(source), "the data of the run");
  } catch (error) {
    if (error instanceof RunError) throw error;
    throw new RunError(`the data of the run is no JSON (${(error as Error).message})`);
  }
}

/** What the bytes of a field mean in a frame. */
export function codedRange(run: Run, field: number, frame: number): Range {
  return run.frames[frame]?.ranges?.[field] ?? run.fields[field];
}

/** Throws RunError, which says what is wrong where. The curves have a reader of their own. */
export function readRun(json: Json): Run {
  if (json.dimension !== 2 && json.dimension !== 3) refuse("dimension", "2 or 3");
  const dimension = json.dimension;
  const fields = each(json.fields, "fields", field);
  const run: Run = {
    title: text(json.title, "title"),
    dimension,
    live: json.live === true,
    minimum: point(json.minimum, "minimum"),
    maximum: point(json.maximum, "maximum"),
    mirrors: json.mirrors === undefined ? [] : each(json.mirrors, "mirrors", mirror),
    categories: each(json.categories, "categories", (part, place) => category(part, place, dimension)),
    spacings: each(json.spacings, "spacings", number),
    fields,
    frames: each(json.frames, "frames", (part, place) => frame(part, place, fields.length)),
  };
  for (let axis = 0; axis < dimension; ++axis)
    if (run.maximum[axis] <= run.minimum[axis]) refuse(`maximum[${axis}]`, "above the minimum");
  if (run.categories.length > 256) refuse("categories", "256 at most");
  if (run.spacings.length > 256) refuse("spacings", "256 at most");
  return run;
}
