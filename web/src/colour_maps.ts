// SPDX-License-Identifier: Apache-2.0
// Colour maps whose lightness alone tells the order (one-sided), or whose ends are blue and red
// around a light middle (signed): both can be read without telling red from green.

import type { Range } from "./run.ts";

export type Rgb = [number, number, number]; // 0..255

export function parseColour(code: string): Rgb {
  return [1, 3, 5].map((at) => parseInt(code.slice(at, at + 2), 16)) as Rgb;
}

// Viridis at equal steps (Smith and van der Walt, 2015, CC0).
export const viridisCodes = "440154 482878 3e4a89 31688e 26828e 1f9e89 35b779 6ece58 b5de2b fde725";
// The middle is a grey that is still seen on white paper.
const diverging = "08306b 1c5fa8 5a9bd4 a3c6e6 dcdcdc f2b48f dd7442 b3391f 67130f";

export function stops(codes: string): Rgb[] {
  return codes.split(" ").map((code) => parseColour(`#${code}`));
}

const oneSided = stops(viridisCodes);
const signed = stops(diverging);

export function sample(map: Rgb[], share: number): Rgb {
  const at = Math.min(Math.max(share, 0), 1) * (map.length - 1);
  const lower = Math.min(Math.floor(at), map.length - 2);
  const weight = at - lower;
  return map[lower].map((part, k) => Math.round(part + weight * (map[lower + 1][k] - part))) as Rgb;
}

export function isSigned(range: Range): boolean {
  return range.minimum < 0 && range.maximum > 0;
}

export function colourOf(value: number, range: Range): Rgb {
  if (isSigned(range)) {
    const reach = Math.max(-range.minimum, range.maximum);
    return sample(signed, 0.5 + (0.5 * value) / reach);
  }
  const span = range.maximum - range.minimum;
  return sample(oneSided, span > 0 ? (value - range.minimum) / span : 0);
}

// Groups that a field numbers: Okabe and Ito, 2008, and a few more; the eighth is a grey.
const groupCodes = "0072b2 d55e00 009e73 cc79a7 7a6a00 56b4e9 e69f00 8a929c 8f63c8 b3262a";
const groups = stops(groupCodes);

export function groupColour(number: number): Rgb {
  return groups[number % groups.length];
}

export function cssColour(colour: Rgb): string {
  return `rgb(${colour.join(",")})`;
}

/** RGBA for every byte. `coded` says what the bytes mean, `shown` what the colours mean. */
export function colourTable(coded: Range, shown: Range & { names?: string[] }): Uint8Array<ArrayBuffer> {
  const table = new Uint8Array(256 * 4);
  for (let byte = 0; byte < 256; ++byte) {
    const value = coded.minimum + (byte / 255) * (coded.maximum - coded.minimum);
    table.set([...(shown.names ? groupColour(Math.round(value)) : colourOf(value, shown)), 255], 4 * byte);
  }
  return table;
}
