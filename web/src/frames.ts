// SPDX-License-Identifier: Apache-2.0
// The particles of one frame, from the packed bytes of the page.

import { RunError } from "./run.ts";
import type { Frame, Run } from "./run.ts";

export interface Particles {
  count: number;
  places: Uint16Array[]; // one per dimension, 0..65535 over the box of the run
  categories: Uint8Array;
  sizes: Uint8Array;
  values: Uint8Array[]; // one per field
  bytes: number;
}

export function bytesOfBase64(source: string): Uint8Array<ArrayBuffer> {
  const letters = atob(source);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

export async function inflate(packed: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  // In the browser's words "deflate" is zlib's format, RFC 1950.
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export function frameLength(count: number, dimension: number, fieldCount: number): number {
  return count * (2 * dimension + 2 + fieldCount);
}

/** Views into `bytes`, which are little-endian as is every computer that runs a browser today. */
export function splitFrame(bytes: Uint8Array<ArrayBuffer>, frame: Frame, run: Run): Particles {
  const { count } = frame;
  const expected = frameLength(count, run.dimension, run.fields.length);
  if (bytes.length !== expected)
    throw new RunError(
      `${bytes.length} bytes, where ${count} particles in ${run.dimension}D with ${run.fields.length} fields take ${expected}`,
    );
  let offset = 0;
  const places = Array.from({ length: run.dimension }, () => {
    const part = new Uint16Array(bytes.buffer, bytes.byteOffset + offset, count);
    offset += 2 * count;
    return part;
  });
  const next = () => bytes.subarray(offset, (offset += count));
  const categories = next();
  const sizes = next();
  const values = run.fields.map(next);
  return { count, places, categories, sizes, values, bytes: bytes.length };
}

async function packedBytes(frame: Frame): Promise<Uint8Array<ArrayBuffer>> {
  if (frame.data !== undefined) return bytesOfBase64(frame.data);
  const answer = await fetch(frame.url!);
  if (!answer.ok) throw new RunError(`${frame.url} cannot be read (${answer.status})`);
  return new Uint8Array(await answer.arrayBuffer());
}

export async function loadFrame(frame: Frame, run: Run): Promise<Particles> {
  const packed = await packedBytes(frame);
  let bytes: Uint8Array<ArrayBuffer>;
  try {
    bytes = await inflate(packed);
  } catch {
    throw new RunError("its bytes are no zlib data");
  }
  return splitFrame(bytes, frame, run);
}
