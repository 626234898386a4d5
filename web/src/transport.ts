// SPDX-License-Identifier: Apache-2.0
// The row below the picture: play, step, scrub, time, speed.

import { element, selection } from "./dom.ts";
import type { Player } from "./player.ts";
import { formatCount, timeFormat } from "./quantities.ts";

const speeds = [2, 5, 10, 20, 40];

function icon(path: string): SVGSVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  made.setAttribute("viewBox", "0 0 16 16");
  made.setAttribute("aria-hidden", "true");
  const shape = document.createElementNS("http://www.w3.org/2000/svg", "path");
  shape.setAttribute("d", path);
  made.append(shape);
  return made;
}

const shapes = {
  play: "M4 2.5v11l9.5-5.5z",
  pause: "M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z",
  back: "M11 3v10L4.5 8z",
  forward: "M5 3v10l6.5-5z",
};

function iconButton(id: string, label: string, shape: string, action: () => void): HTMLButtonElement {
  const button = element("button", { id, type: "button", title: label, className: "kerf-icon", onclick: action });
  button.setAttribute("aria-label", label);
  button.append(icon(shape));
  return button;
}

export class Transport {
  readonly root: HTMLElement;
  private readonly playButton: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private readonly time = element("output", { id: "kerf-time" });
  private readonly status = element("span", { id: "kerf-status" });

  constructor(
    private readonly player: Player,
    private readonly countOf: (frame: number) => number,
  ) {
    this.playButton = iconButton("kerf-play", "Play", shapes.play, () => player.toggle());
    this.slider = element("input", { id: "kerf-frame", type: "range", min: "0", step: "1" });
    this.slider.setAttribute("aria-label", "Time");
    this.slider.oninput = () => player.goTo(Number(this.slider.value));
    const choices = speeds.map((speed): [string, string] => [String(speed), `${speed} frames/s`]);
    const speed = selection("kerf-speed", choices, String(player.framesPerSecond));
    speed.setAttribute("aria-label", "Speed");
    speed.onchange = () => (player.framesPerSecond = Number(speed.value));
    this.root = element(
      "div",
      { className: "kerf-transport" },
      this.playButton,
      iconButton("kerf-back", "One frame back", shapes.back, () => player.step(-1)),
      iconButton("kerf-forward", "One frame forward", shapes.forward, () => player.step(1)),
      this.slider,
      this.time,
      element("div", { className: "kerf-row" }, this.status, speed),
    );
    player.onChange(() => this.refresh());
    this.refresh();
  }

  private refresh() {
    const { player } = this;
    const frames = player.times.length;
    const label = player.playing ? "Pause" : "Play";
    if (this.playButton.title !== label) {
      this.playButton.title = label;
      this.playButton.setAttribute("aria-label", label);
      this.playButton.replaceChildren(icon(player.playing ? shapes.pause : shapes.play));
    }
    this.slider.max = String(Math.max(frames - 1, 0));
    this.slider.value = String(player.index);
    const time = player.time;
    this.time.textContent = time === undefined ? "—" : timeFormat(player.times)(time);
    this.slider.setAttribute("aria-valuetext", this.time.textContent);
    this.status.textContent =
      frames === 0
        ? "no frames yet"
        : `frame ${player.index + 1}/${frames} · ${formatCount(this.countOf(player.index))} particles`;
  }
}
