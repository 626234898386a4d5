// SPDX-License-Identifier: Apache-2.0
// Where the reader looks from: pan and zoom in 2D, orbit in 3D. y is up.

import { MOUSE, OrthographicCamera, PerspectiveCamera, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import type { Box } from "./extent.ts";
import type { Point } from "./run.ts";

export type Direction = Point; // from what is looked at towards the eye
export const directions: Record<string, Direction> = {
  oblique: [0.5, 0.4, 1],
  front: [0, 0, 1],
  side: [1, 0, 0],
  top: [0, 1, 0.001], // straight down, y could not be up
};

const margin = 1.06;
const scaleSpace = 0.1; // of the height of what a flat picture shows
const openingAngle = 30; // degrees, of the picture's height

export class View {
  readonly camera: OrthographicCamera | PerspectiveCamera;
  private readonly controls: OrbitControls;
  private box: Box = { minimum: [0, 0, 0], maximum: [1, 1, 1] };
  private direction = directions.oblique;
  private aspect = 1;
  private moved = false;
  private readonly changed: () => void;

  constructor(dimension: 2 | 3, canvas: HTMLCanvasElement, changed: () => void) {
    this.camera = dimension === 2 ? new OrthographicCamera() : new PerspectiveCamera(openingAngle);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomSpeed = 1.5;
    this.controls.screenSpacePanning = true;
    if (dimension === 2) {
      this.controls.enableRotate = false;
      this.controls.zoomToCursor = true;
      this.controls.mouseButtons.LEFT = MOUSE.PAN;
      this.controls.touches.ONE = TOUCH.PAN;
      this.controls.touches.TWO = TOUCH.DOLLY_PAN;
    }
    this.controls.addEventListener("start", () => (this.moved = true));
    // The controls tell of moves of a millimetre and more only, which is all there is to see here.
    canvas.addEventListener("wheel", changed);
    canvas.addEventListener("pointermove", (event) => event.buttons !== 0 && changed());
    this.changed = changed;
  }

  resize(width: number, height: number) {
    this.aspect = width / height;
    if (!this.moved) this.fit(this.box, this.direction);
    else if (this.camera instanceof PerspectiveCamera) {
      this.camera.aspect = this.aspect;
      this.camera.updateProjectionMatrix();
    } else this.setWindow(this.camera, this.camera.top);
  }

  fit(box: Box, direction = this.direction) {
    this.box = box;
    this.direction = direction;
    this.moved = false;
    const low = new Vector3(...box.minimum);
    const high = new Vector3(...box.maximum);
    const centre = low.clone().add(high).multiplyScalar(0.5);
    const size = high.sub(low);
    this.controls.target.copy(centre);
    if (this.camera instanceof OrthographicCamera) this.fitFlat(this.camera, centre, size);
    else this.fitSolid(this.camera, centre, size);
    this.controls.update();
  }

  zoom(factor: number) {
    this.moved = true;
    if (this.camera instanceof OrthographicCamera) {
      this.camera.zoom *= factor;
      this.camera.updateProjectionMatrix();
    } else {
      this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    }
    this.controls.update();
    this.changed();
  }

  /** Metres per pixel of a picture `height` pixels high; of the flat view only. */
  metresPerPixel(height: number): number {
    if (!(this.camera instanceof OrthographicCamera)) return 0;
    return (this.camera.top - this.camera.bottom) / this.camera.zoom / height;
  }

  private setWindow(camera: OrthographicCamera, halfHeight: number) {
    camera.top = halfHeight;
    camera.bottom = -halfHeight;
    camera.right = halfHeight * this.aspect;
    camera.left = -camera.right;
    camera.updateProjectionMatrix();
  }

  private fitFlat(camera: OrthographicCamera, centre: Vector3, size: Vector3) {
    camera.zoom = 1;
    camera.near = 0.1;
    camera.far = 10;
    const height = Math.max((1 + scaleSpace) * size.y, size.x / this.aspect);
    camera.position.copy(centre).setZ(centre.z + 1);
    // Down, for the scale bar, unless there is room below anyway.
    camera.position.y -= Math.min(0.5 * scaleSpace * size.y, 0.5 * (height - size.y));
    this.controls.target.y = camera.position.y;
    this.setWindow(camera, 0.5 * margin * height);
  }

  // As near as all eight corners allow.
  private fitSolid(camera: PerspectiveCamera, centre: Vector3, size: Vector3) {
    const back = new Vector3(...this.direction).normalize();
    const right = new Vector3(0, 1, 0).cross(back).normalize();
    const up = back.clone().cross(right);
    const slope = Math.tan((openingAngle * Math.PI) / 360) / margin;
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const sign = [1, 2, 4].map((bit) => (corner & bit ? 0.5 : -0.5));
      const offset = new Vector3(sign[0] * size.x, sign[1] * size.y, sign[2] * size.z);
      const wide = Math.abs(offset.dot(right)) / (slope * this.aspect);
      const high = Math.abs(offset.dot(up)) / slope;
      distance = Math.max(distance, offset.dot(back) + Math.max(wide, high));
    }
    camera.position.copy(centre).addScaledVector(back, distance);
    camera.aspect = this.aspect;
    camera.near = 0.01 * distance;
    camera.far = distance + 20 * size.length();
    camera.updateProjectionMatrix();
    this.controls.minDistance = 0.02 * distance;
    this.controls.maxDistance = 10 * distance;
  }
}
