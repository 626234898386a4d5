// SPDX-License-Identifier: Apache-2.0
// The particles on the graphics card: two arrays written in place, and three small tables.

import {
  BufferAttribute,
  DataTexture,
  DynamicDrawUsage,
  FloatType,
  Group,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Points,
  RedFormat,
  ShaderMaterial,
  Vector3,
  Vector4,
} from "three";

import { colourTable, parseColour } from "./colour_maps.ts";
import { imagesOf } from "./extent.ts";
import type { Particles } from "./frames.ts";
import { codedRange, type Field, type Run } from "./run.ts";
import { fragmentShader, vertexShader } from "./shaders.ts";

export type Showing = "full" | "faint" | "hidden";
const opacities: Record<Showing, number> = { full: 255, faint: 36, hidden: 0 };
const tableLength = 256;

export class ParticleCloud {
  readonly object = new Group();
  private readonly categoryTable = new DataTexture(new Uint8Array(4 * tableLength), tableLength, 1);
  private readonly valueTable = new DataTexture(new Uint8Array(4 * tableLength), tableLength, 1);
  private readonly diameterTable = new DataTexture(new Float32Array(tableLength), tableLength, 1, RedFormat, FloatType);
  // One object for all passes: what is set here is set for each of them.
  private readonly shared = {
    boxMinimum: { value: new Vector3() },
    boxSize: { value: new Vector3(1, 1, 1) },
    mirrorPlaces: { value: new Vector3() },
    clip: { value: new Vector4(0, 0, 0, 1) },
    halfHeight: { value: 1 },
    byValue: { value: false },
    categoryTable: { value: this.categoryTable },
    valueTable: { value: this.valueTable },
    diameterTable: { value: this.diameterTable },
  };
  private geometry = new InstancedBufferGeometry();
  private images = [[0, 0, 0]];
  private readonly whole: Points;
  private readonly ghosts: Points[];
  private capacity = -1;
  private particles: Particles | undefined;
  private field = -1; // -1: by category

  constructor(private readonly dimension: 2 | 3) {
    this.whole = new Points(this.geometry, this.material(false));
    // First only the depth of the nearest ghosts, then their colour: else those behind would add up.
    const depthOnly = this.material(true);
    depthOnly.colorWrite = false;
    const colourOnly = this.material(true);
    colourOnly.transparent = true;
    colourOnly.depthWrite = false;
    this.ghosts = [depthOnly, colourOnly].map((material) => new Points(this.geometry, material));
    [this.whole, ...this.ghosts].forEach((points, order) => {
      points.renderOrder = order;
      points.frustumCulled = false;
      this.object.add(points);
    });
  }

  private material(ghosts: boolean): ShaderMaterial {
    const spheres = this.dimension === 3;
    return new ShaderMaterial({
      vertexShader,
      fragmentShader,
      defines: { AMBIENT: spheres ? "0.5" : "0.66", ...(spheres && { SPHERES: 1 }) },
      uniforms: { ...this.shared, ghosts: { value: ghosts } },
      alphaToCoverage: !ghosts,
      depthTest: spheres,
      depthWrite: spheres,
    });
  }

  setRun(run: Run) {
    this.shared.boxMinimum.value.set(...run.minimum);
    this.shared.boxSize.value.set(...run.maximum).sub(this.shared.boxMinimum.value);
    for (const { axis, place } of run.mirrors) this.shared.mirrorPlaces.value.setComponent(axis, place);
    this.images = imagesOf(run.mirrors);
    this.capacity = -1; // of a geometry with these images
    const diameters = this.diameterTable.image.data as Float32Array;
    diameters.fill(run.spacings[run.spacings.length - 1] ?? 0);
    diameters.set(run.spacings);
    this.diameterTable.needsUpdate = true;
  }

  setCategories(run: Run, showing: Showing[]) {
    const table = this.categoryTable.image.data as Uint8Array;
    table.fill(255);
    run.categories.forEach((category, at) => {
      table.set([...parseColour(category.colour), opacities[showing[at]]], 4 * at);
    });
    this.categoryTable.needsUpdate = true;
    const anyGhost = showing.includes("faint");
    for (const points of this.ghosts) points.visible = anyGhost;
  }

  /** Colours by field number `field` of the run, or by category where it is -1. */
  setField(run: Run, field: number, frame: number, shown: Field = run.fields[field]) {
    this.shared.byValue.value = field >= 0;
    if (field >= 0) {
      const coded = codedRange(run, field, frame);
      (this.valueTable.image.data as Uint8Array).set(colourTable(coded, shown));
      this.valueTable.needsUpdate = true;
    }
    if (field === this.field) return;
    this.field = field;
    if (this.particles) this.write(this.particles);
  }

  setClip(plane: [number, number, number, number]) {
    this.shared.clip.value.set(...plane);
  }

  setHeight(pixels: number) {
    this.shared.halfHeight.value = 0.5 * pixels;
  }

  setParticles(particles: Particles) {
    this.particles = particles;
    this.write(particles);
  }

  private grow(count: number) {
    this.geometry.dispose();
    this.geometry = new InstancedBufferGeometry();
    this.geometry.instanceCount = this.images.length;
    this.geometry.setAttribute("mirrored", new InstancedBufferAttribute(new Float32Array(this.images.flat()), 3));
    this.capacity = Math.ceil(1.25 * count);
    const places = new BufferAttribute(new Uint16Array(4 * this.capacity), 4, true);
    const kinds = new BufferAttribute(new Uint8Array(4 * this.capacity), 4, false);
    this.geometry.setAttribute("position", places.setUsage(DynamicDrawUsage));
    this.geometry.setAttribute("kind", kinds.setUsage(DynamicDrawUsage));
    for (const points of [this.whole, ...this.ghosts]) points.geometry = this.geometry;
  }

  // Four numbers per particle each, of which three are used: graphics cards want steps of 4 bytes.
  private write(particles: Particles) {
    const { count, places, categories, sizes } = particles;
    if (count > this.capacity) this.grow(count);
    const placeAttribute = this.geometry.getAttribute("position") as BufferAttribute;
    const kindAttribute = this.geometry.getAttribute("kind") as BufferAttribute;
    const place = placeAttribute.array;
    const kind = kindAttribute.array;
    const values = this.field >= 0 ? particles.values[this.field] : undefined;
    places.forEach((along, axis) => {
      for (let i = 0, to = axis; i < count; ++i, to += 4) place[to] = along[i];
    });
    for (let i = 0, to = 0; i < count; ++i, to += 4) {
      kind[to] = categories[i];
      kind[to + 1] = sizes[i];
      kind[to + 2] = values ? values[i] : 0;
    }
    for (const attribute of [placeAttribute, kindAttribute]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, 4 * count);
      attribute.needsUpdate = true;
    }
    this.geometry.setDrawRange(0, count);
  }
}
