// SPDX-License-Identifier: Apache-2.0
// The range that the colours of a field span: that of all frames, or what most particles of one frame have.

import type { Range } from "./run.ts";

/** Without the share `outside` of the values at either end. `coded` says what the bytes mean. */
export function percentileRange(bytes: Uint8Array, coded: Range, outside: number): Range {
  const histogram = new Uint32Array(256);
  for (const byte of bytes) ++histogram[byte];
  const leftOut = Math.floor(outside * bytes.length);
  const walk = (from: number, step: number) => {
    let at = from;
    for (let seen = histogram[at]; seen <= leftOut && at + step >= 0 && at + step < 256; seen += histogram[at]) at += step;
    return at;
  };
  const value = (byte: number) => valueOf(byte, coded);
  const [low, high] = bytes.length === 0 ? [0, 255] : [walk(0, 1), walk(255, -1)];
  return low < high ? { minimum: value(low), maximum: value(high) } : { ...coded };
}

export function valueOf(byte: number, coded: Range): number {
  return coded.minimum + (byte / 255) * (coded.maximum - coded.minimum);
}
