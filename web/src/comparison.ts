// SPDX-License-Identifier: Apache-2.0
// Two runs side by side: one slider moves both to the same time, and their colours mean the same.

import { CategoryList } from "./category_list.ts";
import { ColourChoice } from "./colour_choice.ts";
import { commonFields, commonTimes, frameAt } from "./common_ranges.ts";
import { element } from "./dom.ts";
import type { Box } from "./extent.ts";
import { Picture } from "./picture.ts";
import { Player } from "./player.ts";
import { timeFormat } from "./quantities.ts";
import type { Run } from "./run.ts";
import { viewButtons } from "./side.ts";
import { listenToKeys } from "./stage_frame.ts";
import { Transport } from "./transport.ts";
import type { Direction } from "./view.ts";

interface Side {
  picture: Picture;
  state: HTMLElement; // the time of its frame
}

const ids = ["kerf-stage-first", "kerf-stage-second"];

export class Comparison {
  readonly root: HTMLElement;
  readonly player: Player;
  private readonly colours: ColourChoice;
  private readonly categories: CategoryList;
  private readonly sides: Side[];

  /** Throws NoWebGl. */
  constructor(private readonly runs: [Run, Run]) {
    const [first, second] = runs;
    const is3d = first.dimension === 3 || second.dimension === 3;
    this.colours = new ColourChoice(commonFields(first, second), () => this.recolour(), false);
    this.categories = new CategoryList(first.categories, is3d, () => this.recolour());
    this.sides = runs.map((run, at) => this.side(run, at));
    this.player = new Player(commonTimes(first, second), () => this.show());
    const transport = new Transport(this.player, () => this.particles());
    const controls = element("div", { className: "kerf-side" }, this.colours.root, this.categories.root);
    controls.append(viewButtons(is3d ? 3 : 2, { look: (direction) => this.look(direction) }));
    const figures = this.sides.map(({ picture, state }) =>
      element("figure", { className: "kerf-of-two" }, element("figcaption", {}, picture.run.title, " ", state), picture.frame),
    );
    this.root = element("div", { className: "kerf-view" }, element("div", { className: "kerf-two" }, ...figures), controls, transport.root);
    listenToKeys(this.root, {
      step: (by) => this.player.step(by),
      ends: (last) => this.player.goTo(last ? this.player.last : 0),
      toggle: () => this.player.toggle(),
      reset: () => this.look(),
      zoom: (factor) => this.sides.forEach(({ picture }) => picture.stage.view.zoom(factor)),
    });
    for (const { picture } of this.sides) picture.setTables();
  }

  /** To be called once the root is in the page. */
  start() {
    for (const { picture } of this.sides) picture.start();
    this.player.goTo(this.player.last);
  }

  /** One of the runs, further on. */
  update(at: 0 | 1, run: Run) {
    this.runs[at] = run;
    this.sides[at]!.picture.update(run);
    this.colours.setFields(commonFields(...this.runs));
    const { time } = this.player;
    const follows = this.player.index >= this.player.last;
    this.player.setTimes(commonTimes(...this.runs));
    if (!follows && time !== undefined) this.player.goToTime(time);
    this.recolour();
  }

  private side(run: Run, at: number): Side {
    const choices = {
      showing: () => this.categories.showing,
      clip: (): [number, number, number, number] => [0, 0, 0, 1],
      // A run without the field has zero everywhere; its particles have the colours of their state.
      field: (of: Run) => (of.fields.some((one) => one.key === this.colours.field?.key) ? this.colours.field : undefined),
    };
    const picture = new Picture(run, choices, () => this.shape(), ids[at], `Particles of the ${at === 0 ? "first" : "second"} run`);
    return { picture, state: element("span", { className: "kerf-soft" }) };
  }

  private async show(): Promise<void> {
    const { time, index } = this.player;
    if (time === undefined) return;
    const isWanted = () => index === this.player.index;
    await Promise.all(this.sides.map((side) => this.showSide(side, time, isWanted)));
  }

  private async showSide({ picture, state }: Side, time: number, isWanted: () => boolean) {
    const { run } = picture;
    const frame = frameAt(run, time);
    if (frame < 0) return;
    await picture.show(frame, isWanted);
    if (!isWanted()) return;
    const own = run.frames[frame]!.time;
    const words = timeFormat(this.player.times)(own);
    const isLast = frame === run.frames.length - 1 && own < time;
    state.textContent = isLast ? `${run.live ? "is at" : "ended at"} ${words}` : `at ${words}`;
  }

  private particles(): number {
    const { time } = this.player;
    return time === undefined ? 0 : this.runs.reduce((sum, run) => sum + (run.frames[frameAt(run, time)]?.count ?? 0), 0);
  }

  // Both pictures show the same part of space, so that lengths can be compared.
  private shape() {
    const box = this.extent();
    if (!box) return;
    for (const { picture } of this.sides) picture.shape(box);
    this.look();
  }

  private extent(): Box | undefined {
    const boxes = this.sides.flatMap(({ picture }) => picture.extent ?? []);
    if (boxes.length === 0) return undefined;
    const each = (pick: (...numbers: number[]) => number, end: "minimum" | "maximum") =>
      [0, 1, 2].map((axis) => pick(...boxes.map((box) => box[end][axis]!))) as [number, number, number];
    return { minimum: each(Math.min, "minimum"), maximum: each(Math.max, "maximum") };
  }

  private look(direction?: Direction) {
    const box = this.extent();
    for (const { picture } of this.sides) picture.look(direction, box);
  }

  private recolour() {
    this.root.classList.toggle("kerf-by-field", this.colours.index >= 0);
    for (const { picture } of this.sides) picture.recolour();
  }
}
