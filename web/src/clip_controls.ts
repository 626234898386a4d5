// SPDX-License-Identifier: Apache-2.0
import type { ClipPlane } from "./clip_plane.ts";
import { element, selection } from "./dom.ts";
import type { Box } from "./extent.ts";
import { formatQuantity } from "./quantities.ts";

const names = ["x", "y", "z"];
const steps = 1000;

export class ClipControls {
  readonly root: HTMLElement;
  private readonly place = element("output", { id: "kerf-clip-place" });
  private readonly slider: HTMLInputElement;

  constructor(
    private readonly plane: ClipPlane,
    private box: Box,
    changed: () => void,
  ) {
    const enabled = element("input", { type: "checkbox", id: "kerf-clip-on", checked: plane.enabled });
    const axis = selection("kerf-clip-axis", names.map((name, at) => [String(at), name]), String(plane.axis));
    axis.setAttribute("aria-label", "Axis of the cut");
    const flip = element("button", { type: "button", id: "kerf-clip-flip" }, "flip");
    flip.setAttribute("aria-pressed", "false");
    flip.title = "Show the other side of the cut";
    const slider = element("input", { type: "range", id: "kerf-clip-position", min: "0", max: String(steps) });
    slider.setAttribute("aria-label", "Position of the cut");
    slider.value = String(plane.share * steps);
    this.slider = slider;
    const apply = () => {
      plane.enabled = enabled.checked;
      plane.axis = Number(axis.value) as 0 | 1 | 2;
      plane.share = Number(slider.value) / steps;
      for (const control of [axis, flip, slider]) control.disabled = !plane.enabled;
      this.refresh();
      changed();
    };
    enabled.onchange = axis.onchange = slider.oninput = apply;
    flip.onclick = () => {
      plane.flipped = !plane.flipped;
      flip.setAttribute("aria-pressed", String(plane.flipped));
      apply();
    };
    this.root = element(
      "div",
      { className: "kerf-group" },
      element("div", { className: "kerf-line" }, element("label", {}, enabled, "Cut across"), axis, flip),
      slider,
      element("div", { className: "kerf-soft" }, this.place),
    );
    this.refresh();
  }

  setBox(box: Box) {
    this.box = box;
    this.refresh();
  }

  private refresh() {
    const place = formatQuantity(this.plane.place(this.box), "m");
    this.place.textContent = `at ${names[this.plane.axis]} = ${place}`;
    this.slider.setAttribute("aria-valuetext", this.place.textContent);
  }
}
