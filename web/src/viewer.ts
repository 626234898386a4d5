// SPDX-License-Identifier: Apache-2.0
// The particles of a run: picture, player and controls, kept in step.

import { CategoryList } from "./category_list.ts";
import { ClipControls } from "./clip_controls.ts";
import { ClipPlane } from "./clip_plane.ts";
import { ColourChoice } from "./colour_choice.ts";
import { element, note } from "./dom.ts";
import { extentOf, withImages } from "./extent.ts";
import { FrameStore } from "./frame_store.ts";
import type { Particles } from "./frames.ts";
import { axesSign, scaleBar, scaleFor } from "./overlays.ts";
import type { Overlay } from "./overlays.ts";
import { Player } from "./player.ts";
import { particleAt, pointerLabel, wordsFor } from "./pointer_value.ts";
import { timeFormat } from "./quantities.ts";
import { codedRange, type Run } from "./run.ts";
import { composePicture, download } from "./save_picture.ts";
import { mirrorNote, viewButtons } from "./side.ts";
import { Stage } from "./stage.ts";
import { listenToKeys, stageFrame } from "./stage_frame.ts";
import { Transport } from "./transport.ts";
import type { Direction } from "./view.ts";

export class Viewer {
  readonly root: HTMLElement;
  readonly player: Player;
  private readonly stage: Stage;
  private readonly frame: HTMLElement;
  private readonly overlay: Overlay;
  private readonly store: FrameStore;
  private readonly clip = new ClipPlane();
  private readonly colours: ColourChoice;
  private readonly categories: CategoryList;
  private readonly clipControls: ClipControls;
  private shown: { index: number; particles: Particles } | undefined;

  /** Throws NoWebGl. */
  constructor(private run: Run) {
    this.stage = new Stage(run.dimension, () => this.overlay?.refresh());
    const { canvas } = this.stage;
    this.overlay =
      run.dimension === 2
        ? scaleBar(canvas, () => this.stage.metresPerPixel())
        : axesSign(() => this.stage.axes());
    this.store = new FrameStore(run);
    this.player = new Player(timesOf(run), (index) => this.show(index));
    const transport = new Transport(this.player, (index) => this.run.frames[index].count);
    this.colours = new ColourChoice(run.fields, () => this.recolour());
    this.categories = new CategoryList(run.categories, run.dimension === 3, () => this.recolour());
    this.clipControls = new ClipControls(this.clip, withImages(run, run.mirrors), () => this.recut());
    this.frame = stageFrame(canvas);
    this.frame.append(this.overlay.root, pointerLabel(canvas, (x, y) => this.wordsAt(x, y)));
    const looks = { look: (direction?: Direction) => this.look(direction), save: () => this.save() };
    const side = element("div", { className: "kerf-side" }, this.colours.root, this.categories.root);
    if (run.dimension === 3) side.append(this.clipControls.root);
    side.append(...mirrorNote(run));
    side.append(viewButtons(run.dimension, looks));
    this.root = element("div", { className: "kerf-view" }, this.frame, side, transport.root);
    this.listen();
    this.setTables();
  }

  /** To be called once the root is in the page. */
  start() {
    new ResizeObserver(() => this.resize()).observe(this.frame);
    this.resize();
    this.player.goTo(this.player.last);
  }

  /** The same run, further on. */
  update(run: Run) {
    if (run.dimension !== this.run.dimension) throw new Error("the run has changed its dimension");
    this.run = run;
    this.store.update(run);
    this.colours.setFields(run.fields);
    this.categories.setCategories(run.categories);
    this.clipControls.setBox(withImages(run, run.mirrors));
    this.setTables();
    this.player.setTimes(timesOf(run));
    if (this.shown) this.recolour();
    else void this.show(this.player.index);
  }

  private listen() {
    const { player } = this;
    listenToKeys(this.root, {
      step: (by) => player.step(by),
      ends: (last) => player.goTo(last ? player.last : 0),
      toggle: () => player.toggle(),
      reset: () => this.look(),
      zoom: (factor) => this.stage.view.zoom(factor),
    });
  }

  private setTables() {
    this.stage.cloud.setRun(this.run);
    this.stage.cloud.setCategories(this.run, this.categories.showing);
    this.stage.cloud.setClip(this.clipNow());
  }

  private resize() {
    this.stage.resize(this.frame.clientWidth, this.frame.clientHeight);
  }

  private async show(index: number): Promise<void> {
    if (index > this.player.last) return;
    try {
      const particles = await this.store.get(index);
      if (index !== this.player.index) return; // the reader went on
      this.put(index, particles);
      note(this.frame, "");
      if (this.player.playing && index < this.player.last) this.store.get(index + 1).catch(() => {});
    } catch (error) {
      if (index === this.player.index) note(this.frame, `Frame ${index + 1}: ${(error as Error).message}.`);
    }
  }

  private put(index: number, particles: Particles) {
    const first = !this.shown;
    this.shown = { index, particles };
    this.applyField();
    this.stage.cloud.setParticles(particles);
    if (first) this.shapeStage(particles);
    this.stage.draw();
    this.frame.dataset.frame = String(index);
  }

  // A flat picture gets the shape of what it shows.
  private shapeStage(particles: Particles) {
    const { minimum, maximum } = extentOf(particles, this.run);
    const aspect = (maximum[0] - minimum[0]) / (1.1 * (maximum[1] - minimum[1]));
    if (this.run.dimension === 2) this.frame.style.setProperty("--kerf-aspect", String(Math.min(Math.max(aspect, 0.8), 2.5)));
    this.resize();
    this.look();
  }

  private recolour() {
    this.root.classList.toggle("kerf-by-field", this.colours.index >= 0);
    this.stage.cloud.setCategories(this.run, this.categories.showing);
    this.applyField();
    this.stage.invalidate();
  }

  private applyField() {
    if (!this.shown) return;
    const { index, particles } = this.shown;
    this.colours.adapt(this.run, index, particles);
    this.stage.cloud.setField(this.run, this.colours.index, index, this.colours.field);
  }

  private clipNow(): [number, number, number, number] {
    return this.run.dimension === 3 ? this.clip.coefficients(withImages(this.run, this.run.mirrors)) : [0, 0, 0, 1];
  }

  private wordsAt(x: number, y: number): string {
    if (!this.shown) return "";
    const { run, stage } = this;
    const { index, particles } = this.shown;
    const scene = { run, particles, camera: stage.view.camera, showing: this.categories.showing, clip: this.clipNow() };
    const particle = particleAt(scene, x, y, stage.canvas.clientWidth, stage.canvas.clientHeight);
    const field = this.colours.index;
    return particle < 0 ? "" : wordsFor(particle, run, particles, run.fields[field], field < 0 ? undefined : codedRange(run, field, index));
  }

  private recut() {
    this.stage.cloud.setClip(this.clipNow());
    this.stage.invalidate();
  }

  private look(direction?: Direction) {
    if (!this.shown) return;
    this.stage.view.fit(extentOf(this.shown.particles, this.run), direction);
    this.stage.invalidate();
  }

  private save() {
    const { player, run } = this;
    const time = this.shown ? timeFormat(player.times)(player.times[this.shown.index]) : "";
    const { showing } = this.categories;
    const flat = run.dimension === 2;
    this.stage.draw();
    const picture = composePicture(this.stage.canvas, {
      title: run.title,
      time,
      field: this.colours.field,
      categories: run.categories.filter((_, at) => showing[at] !== "hidden"),
      scale: flat ? scaleFor(this.stage.metresPerPixel(), this.stage.canvas.clientWidth) : undefined,
    });
    download(picture, `${run.title.replace(/[^\p{L}\p{N}]+/gu, "_")}_${time.replace(/\s/g, "")}.png`);
  }
}

function timesOf(run: Run): number[] {
  return run.frames.map((frame) => frame.time);
}
