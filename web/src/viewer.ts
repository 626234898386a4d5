// SPDX-License-Identifier: Apache-2.0
// The particles of a run: picture, player and controls, kept in step.

import { CategoryList } from "./category_list.ts";
import { ClipControls } from "./clip_controls.ts";
import { ClipPlane } from "./clip_plane.ts";
import { ColourChoice } from "./colour_choice.ts";
import { element } from "./dom.ts";
import { withImages } from "./extent.ts";
import type { Particles } from "./frames.ts";
import { scaleFor } from "./overlays.ts";
import { Picture } from "./picture.ts";
import { Player } from "./player.ts";
import { timeFormat } from "./quantities.ts";
import type { Run } from "./run.ts";
import { composePicture, download } from "./save_picture.ts";
import { mirrorNote, viewButtons } from "./side.ts";
import { listenToKeys } from "./stage_frame.ts";
import { Transport } from "./transport.ts";
import type { Direction } from "./view.ts";

export class Viewer {
  readonly root: HTMLElement;
  readonly player: Player;
  private readonly picture: Picture;
  private readonly clip = new ClipPlane();
  private readonly colours: ColourChoice;
  private readonly categories: CategoryList;
  private readonly clipControls: ClipControls;

  /** Throws NoWebGl. */
  constructor(private run: Run) {
    this.colours = new ColourChoice(run.fields, () => this.recolour());
    this.categories = new CategoryList(run.categories, run.dimension === 3, () => this.recolour());
    const choices = {
      showing: () => this.categories.showing,
      clip: () => this.clipNow(),
      field: (of: Run, frame: number, particles: Particles) => {
        this.colours.adapt(of, frame, particles);
        return this.colours.field;
      },
    };
    this.picture = new Picture(run, choices, () => this.shape());
    this.player = new Player(timesOf(run), (index) => this.show(index));
    const transport = new Transport(this.player, (index) => this.run.frames[index].count);
    this.clipControls = new ClipControls(this.clip, this.picture.box, () => this.picture.recut());
    const looks = { look: (direction?: Direction) => this.picture.look(direction), save: () => this.save() };
    const side = element("div", { className: "kerf-side" }, this.colours.root, this.categories.root);
    if (run.dimension === 3) side.append(this.clipControls.root);
    side.append(...mirrorNote(run));
    side.append(viewButtons(run.dimension, looks));
    this.root = element("div", { className: "kerf-view" }, this.picture.frame, side, transport.root);
    this.listen();
    this.picture.setTables();
  }

  /** To be called once the root is in the page. */
  start() {
    this.picture.start();
    this.player.goTo(this.player.last);
  }

  /** The same run, further on. */
  update(run: Run) {
    this.run = run;
    this.colours.setFields(run.fields);
    this.categories.setCategories(run.categories);
    this.picture.update(run);
    this.clipControls.setBox(this.picture.box);
    this.player.setTimes(timesOf(run));
    if (this.picture.shown) this.recolour();
    else void this.show(this.player.index);
  }

  private listen() {
    const { player } = this;
    listenToKeys(this.root, {
      step: (by) => player.step(by),
      ends: (last) => player.goTo(last ? player.last : 0),
      toggle: () => player.toggle(),
      reset: () => this.picture.look(),
      zoom: (factor) => this.picture.stage.view.zoom(factor),
    });
  }

  private async show(index: number): Promise<void> {
    if (index > this.player.last) return;
    const next = this.player.playing && index < this.player.last ? index + 1 : undefined;
    await this.picture.show(index, () => index === this.player.index, next);
  }

  private shape() {
    this.picture.shape(this.picture.extent!);
    this.picture.look();
  }

  private recolour() {
    this.root.classList.toggle("kerf-by-field", this.colours.index >= 0);
    this.picture.recolour();
  }

  private clipNow(): [number, number, number, number] {
    return this.run.dimension === 3 ? this.clip.coefficients(withImages(this.run, this.run.mirrors)) : [0, 0, 0, 1];
  }

  private save() {
    const { player, run } = this;
    const { stage, shown } = this.picture;
    const time = shown ? timeFormat(player.times)(player.times[shown.index]) : "";
    const { showing } = this.categories;
    const flat = run.dimension === 2;
    stage.draw();
    const picture = composePicture(stage.canvas, {
      title: run.title,
      time,
      field: this.colours.field,
      categories: run.categories.filter((_, at) => showing[at] !== "hidden"),
      scale: flat ? scaleFor(stage.metresPerPixel(), stage.canvas.clientWidth) : undefined,
    });
    download(picture, `${run.title.replace(/[^\p{L}\p{N}]+/gu, "_")}_${time.replace(/\s/g, "")}.png`);
  }
}

function timesOf(run: Run): number[] {
  return run.frames.map((frame) => frame.time);
}
