// SPDX-License-Identifier: Apache-2.0
// Frames by number. Keeps the ones used last, as many as fit a budget.

import { loadFrame } from "./frames.ts";
import type { Particles } from "./frames.ts";
import type { Frame, Run } from "./run.ts";

const defaultBudget = 192 * 1024 * 1024; // bytes

type Load = (frame: Frame, run: Run) => Promise<Particles>;

export class FrameStore {
  private readonly kept = new Map<string, Promise<Particles>>(); // oldest use first
  private readonly sizes = new Map<string, number>();

  constructor(
    private run: Run,
    private readonly budget = defaultBudget,
    private readonly load: Load = loadFrame,
  ) {}

  /** Frames stay valid as long as the bytes mean the same. */
  update(run: Run) {
    const meaning = (one: Run) => JSON.stringify([one.dimension, one.fields.map((field) => field.key)]);
    if (meaning(run) !== meaning(this.run)) {
      this.kept.clear();
      this.sizes.clear();
    }
    this.run = run;
  }

  get(index: number): Promise<Particles> {
    const frame = this.run.frames[index];
    const key = `${frame.url ?? `#${index}`} ${frame.time} ${frame.count}`;
    const known = this.kept.get(key);
    if (known) {
      this.kept.delete(key);
      this.kept.set(key, known);
      return known;
    }
    const loading = this.load(frame, this.run);
    this.kept.set(key, loading);
    loading.then(
      (particles) => this.arrived(key, loading, particles.bytes),
      () => this.forget(key, loading),
    );
    return loading;
  }

  private arrived(key: string, loading: Promise<Particles>, bytes: number) {
    if (this.kept.get(key) !== loading) return;
    this.sizes.set(key, bytes);
    let total = [...this.sizes.values()].reduce((sum, size) => sum + size, 0);
    for (const oldest of [...this.kept.keys()]) {
      if (total <= this.budget || oldest === key) break;
      total -= this.sizes.get(oldest) ?? 0;
      this.kept.delete(oldest);
      this.sizes.delete(oldest);
    }
  }

  // A frame that failed may be there at the next try.
  private forget(key: string, loading: Promise<Particles>) {
    if (this.kept.get(key) === loading) this.kept.delete(key);
  }
}
