// SPDX-License-Identifier: Apache-2.0
// Two runs whose colours mean the same.

import type { Field, Run } from "./run.ts";

const namesOf = (field: Field) => JSON.stringify(field.names ?? null);

/** The fields of both runs, or of one where the other is zero everywhere; each spans the values of both. Groups that have other names in the other run are left out. */
export function commonFields(first: Run, second: Run): Field[] {
  const inOther = (field: Field, run: Run) => run.fields.find((one) => one.key === field.key);
  const shared = first.fields.flatMap((field): Field[] => {
    const other = inOther(field, second);
    if (!other) return [withZero(field)];
    if (namesOf(field) !== namesOf(other)) return [];
    return [{ ...field, minimum: Math.min(field.minimum, other.minimum), maximum: Math.max(field.maximum, other.maximum) }];
  });
  return [...shared, ...second.fields.filter((field) => !inOther(field, first)).map(withZero)];
}

function withZero(field: Field): Field {
  return { ...field, minimum: Math.min(0, field.minimum), maximum: Math.max(0, field.maximum) };
}

/** The moments of both runs, in order, s. */
export function commonTimes(first: Run, second: Run): number[] {
  return [...new Set([...first.frames, ...second.frames].map((frame) => frame.time))].sort((a, b) => a - b);
}

/** The number of the frame nearest to a time; -1 where there is no frame. */
export function frameAt(run: Run, time: number): number {
  let nearest = -1;
  run.frames.forEach((frame, at) => {
    if (nearest < 0 || Math.abs(frame.time - time) < Math.abs(run.frames[nearest]!.time - time)) nearest = at;
  });
  return nearest;
}
