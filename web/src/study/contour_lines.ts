// SPDX-License-Identifier: Apache-2.0
// Areas and lines of equal value of a raster, as paths.

import { contours } from "d3-contour";

import type { Patch } from "./patches.ts";

export interface Plane {
  x: (u: number) => number; // px
  y: (v: number) => number;
}

const written = (place: number) => place.toFixed(1);

export class ContourDrawing {
  private readonly generator;

  constructor(
    private readonly known: Float64Array,
    private readonly values: Float64Array, // grown beyond what is known
    private readonly size: number,
    private readonly plane: Plane,
  ) {
    this.generator = contours().size([size, size]);
  }

  /** All that is at or above the threshold. */
  area(threshold: number): string {
    const { coordinates } = this.contour(threshold);
    return coordinates.flatMap((polygon) => polygon.map((ring) => `M${ring.map((at) => this.place(at)).join("L")}Z`)).join("");
  }

  /** Where the value is the threshold: the edges of the area, but for those beyond what is known. */
  line(threshold: number): [number, number][][] {
    const pieces: [number, number][][] = [];
    for (const polygon of this.contour(threshold).coordinates)
      for (const ring of polygon) {
        let piece: [number, number][] = [];
        for (let at = 0; at + 1 < ring.length; ++at) {
          const [from, to] = [ring[at], ring[at + 1]] as [number, number][];
          if (this.isInside(from) && this.isInside(to)) {
            if (piece.length === 0) pieces.push((piece = [this.pixels(from)]));
            piece.push(this.pixels(to));
          } else piece = [];
        }
      }
    return pieces;
  }

  private contour(threshold: number) {
    // The library takes plain arrays; what is not a number is below every threshold.
    return this.generator.contour(this.values as unknown as number[], threshold);
  }

  private isInside([x, y]: [number, number]): boolean {
    const [column, row] = [x - 0.5, y - 0.5];
    const corners = [Math.floor(column), Math.ceil(column)].flatMap((i) => [Math.floor(row), Math.ceil(row)].map((j) => [i, j]));
    return corners.every(([i, j]) => i >= 0 && j >= 0 && i < this.size && j < this.size && !Number.isNaN(this.known[j * this.size + i]));
  }

  private pixels([x, y]: number[]): [number, number] {
    const steps = this.size - 1;
    return [this.plane.x((x - 0.5) / steps), this.plane.y((y - 0.5) / steps)];
  }

  private place(at: number[]): string {
    return this.pixels(at).map(written).join(",");
  }
}

export function pathOf(pieces: [number, number][][]): string {
  return pieces.map((piece) => `M${piece.map(([x, y]) => `${written(x)},${written(y)}`).join("L")}`).join("");
}

export function outline(patches: Patch[], plane: Plane): string {
  const corner = ({ u, v }: { u: number; v: number }) => `${written(plane.x(u))},${written(plane.y(v))}`;
  return patches.map((patch) => `M${patch.map(corner).join("L")}Z`).join("");
}
