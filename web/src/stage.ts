// SPDX-License-Identifier: Apache-2.0
// The canvas. Draws when something has changed, and not otherwise.

import { Scene, WebGLRenderer } from "three";

import { ParticleCloud } from "./points.ts";
import type { Point } from "./run.ts";
import { View } from "./view.ts";

export class NoWebGl extends Error {}

export class Stage {
  readonly canvas: HTMLCanvasElement;
  readonly cloud: ParticleCloud;
  readonly view: View;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private waiting = false;
  private height = 1; // CSS px

  /** Throws NoWebGl. `drawn` is called after each picture. */
  constructor(
    dimension: 2 | 3,
    private readonly drawn: () => void,
  ) {
    this.canvas = document.createElement("canvas");
    // Asked for here, as the library would write its failure to the console.
    const attributes = { antialias: true, alpha: false, depth: true, powerPreference: "high-performance" };
    const context = this.canvas.getContext("webgl2", attributes) as WebGL2RenderingContext | null;
    if (!context) throw new NoWebGl("this browser has no WebGL");
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context, antialias: true });
    this.renderer.setClearColor(0xffffff);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.cloud = new ParticleCloud(dimension);
    this.scene.add(this.cloud.object);
    this.view = new View(dimension, this.canvas, () => this.invalidate());
    this.canvas.addEventListener("webglcontextrestored", () => this.invalidate());
  }

  resize(width: number, height: number) {
    if (width < 1 || height < 1) return;
    this.height = height;
    this.renderer.setSize(width, height);
    this.cloud.setHeight(this.renderer.domElement.height);
    this.view.resize(width, height);
    this.draw(); // at once: the canvas has just been emptied
  }

  invalidate() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.waiting = false;
    this.renderer.render(this.scene, this.view.camera);
    this.drawn();
  }

  metresPerPixel(): number {
    return this.view.metresPerPixel(this.height);
  }

  /** Where the axes of space point in the picture: right, up, towards the eye. */
  axes(): Point[] {
    const m = this.view.camera.matrixWorldInverse.elements;
    return [0, 1, 2].map((axis) => [m[4 * axis], m[4 * axis + 1], m[4 * axis + 2]]);
  }
}
