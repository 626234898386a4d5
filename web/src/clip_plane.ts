// SPDX-License-Identifier: Apache-2.0
// Particles whose centres are beyond the plane are left out. Starts through the middle, seen from
// the front, as the cut is looked at.

import type { Box } from "./extent.ts";

export class ClipPlane {
  enabled = true;
  axis: 0 | 1 | 2 = 2;
  flipped = false;
  share = 0.5; // of the box, along the axis

  place(box: Box): number {
    return box.minimum[this.axis] + this.share * (box.maximum[this.axis] - box.minimum[this.axis]);
  }

  /** n and d, to keep where n·x <= d. */
  coefficients(box: Box): [number, number, number, number] {
    const plane: [number, number, number, number] = [0, 0, 0, 1];
    if (!this.enabled) return plane;
    const sign = this.flipped ? -1 : 1;
    plane[this.axis] = sign;
    plane[3] = sign * this.place(box);
    return plane;
  }
}
