// SPDX-License-Identifier: Apache-2.0
// The picture of one run: its stage, the frames that it shows, and what lies over it.

import { note } from "./dom.ts";
import { extentOf, withImages, type Box } from "./extent.ts";
import { FrameStore } from "./frame_store.ts";
import type { Particles } from "./frames.ts";
import { axesSign, scaleBar, type Overlay } from "./overlays.ts";
import { particleAt, pointerLabel, wordsFor } from "./pointer_value.ts";
import type { Showing } from "./points.ts";
import { codedRange, type Field, type Run } from "./run.ts";
import { Stage } from "./stage.ts";
import { stageFrame } from "./stage_frame.ts";
import type { Direction } from "./view.ts";

type Plane = [number, number, number, number]; // keeps places with plane.xyz . place <= plane.w

/** What the reader has chosen. */
export interface Choices {
  showing(): Showing[]; // of the categories
  clip(run: Run): Plane;
  field(run: Run, frame: number, particles: Particles): Field | undefined; // with the range that its colours span
}

export interface Shown {
  index: number;
  particles: Particles;
}

export class Picture {
  readonly frame: HTMLElement;
  readonly stage: Stage;
  shown: Shown | undefined;
  private readonly overlay: Overlay;
  private readonly store: FrameStore;
  private field = -1; // that is drawn; -1 = the state of the matter

  /** Throws NoWebGl. `shaped` is called when the first frame is there, before it is drawn. */
  constructor(
    public run: Run,
    private readonly choices: Choices,
    private readonly shaped: () => void,
    id = "kerf-stage",
    name = "Particles",
  ) {
    this.stage = new Stage(run.dimension, () => this.overlay?.refresh());
    const { canvas } = this.stage;
    this.overlay = run.dimension === 2 ? scaleBar(canvas, () => this.stage.metresPerPixel()) : axesSign(() => this.stage.axes());
    this.store = new FrameStore(run);
    this.frame = stageFrame(canvas, id, name);
    this.frame.append(this.overlay.root, pointerLabel(canvas, (x, y) => this.wordsAt(x, y), id.replace("stage", "value")));
  }

  /** To be called once it is in the page. */
  start() {
    new ResizeObserver(() => this.resize()).observe(this.frame);
    this.resize();
  }

  /** The same run, further on. */
  update(run: Run) {
    if (run.dimension !== this.run.dimension) throw new Error("the run has changed its dimension");
    this.run = run;
    this.store.update(run);
    this.setTables();
  }

  setTables() {
    this.stage.cloud.setRun(this.run);
    this.stage.cloud.setCategories(this.run, this.choices.showing());
    this.stage.cloud.setClip(this.choices.clip(this.run));
  }

  /** Resolves when the frame is drawn, or is no longer the one that is wanted. */
  async show(index: number, isWanted: () => boolean, next?: number): Promise<void> {
    try {
      const particles = await this.store.get(index);
      if (!isWanted()) return; // the reader went on
      this.put(index, particles);
      note(this.frame, "");
      if (next !== undefined) this.store.get(next).catch(() => {});
    } catch (error) {
      if (isWanted()) note(this.frame, `Frame ${index + 1}: ${(error as Error).message}.`);
    }
  }

  recolour() {
    this.stage.cloud.setCategories(this.run, this.choices.showing());
    this.applyField();
    this.stage.invalidate();
  }

  recut() {
    this.stage.cloud.setClip(this.choices.clip(this.run));
    this.stage.invalidate();
  }

  get extent(): Box | undefined {
    return this.shown && extentOf(this.shown.particles, this.run);
  }

  look(direction?: Direction, box = this.extent) {
    if (!box) return;
    this.stage.view.fit(box, direction);
    this.stage.invalidate();
  }

  /** A flat picture gets the shape of what it shows. */
  shape({ minimum, maximum }: Box) {
    const aspect = (maximum[0] - minimum[0]) / (1.1 * (maximum[1] - minimum[1]));
    if (this.run.dimension === 2) this.frame.style.setProperty("--kerf-aspect", String(Math.min(Math.max(aspect, 0.8), 2.5)));
    this.resize();
  }

  /** Where the particles can be, with their images. */
  get box(): Box {
    return withImages(this.run, this.run.mirrors);
  }

  private put(index: number, particles: Particles) {
    const first = !this.shown;
    this.shown = { index, particles };
    this.applyField();
    this.stage.cloud.setParticles(particles);
    if (first) this.shaped();
    this.stage.draw();
    this.frame.dataset.frame = String(index);
  }

  private applyField() {
    if (!this.shown) return;
    const { index, particles } = this.shown;
    const field = this.choices.field(this.run, index, particles);
    this.field = field ? this.run.fields.findIndex((one) => one.key === field.key) : -1;
    this.stage.cloud.setField(this.run, this.field, index, field);
  }

  private resize() {
    this.stage.resize(this.frame.clientWidth, this.frame.clientHeight);
  }

  private wordsAt(x: number, y: number): string {
    if (!this.shown) return "";
    const { run, stage, choices, field } = this;
    const { index, particles } = this.shown;
    const scene = { run, particles, camera: stage.view.camera, showing: choices.showing(), clip: choices.clip(run) };
    const particle = particleAt(scene, x, y, stage.canvas.clientWidth, stage.canvas.clientHeight);
    return particle < 0 ? "" : wordsFor(particle, run, particles, run.fields[field], field < 0 ? undefined : codedRange(run, field, index));
  }
}
