// SPDX-License-Identifier: Apache-2.0
// A made-up jet into a block: not physics, but laid out and moving like a run.

import { deflateSync } from "node:zlib";

const frameCount = 12;
const interval = 0.25e-3; // s
const speed = 50; // m/s
const water = 0;
const solid = 1;
const fractured = 2;
const plate = 3;

const categories = [
  { label: "water", colour: "#5cc48a" },
  { label: "solid", colour: "#b3262a" },
  { label: "fractured", colour: "#2b62d9" },
  { label: "plate", colour: "#f0c52e" },
];
const fields = [
  { key: "speed", label: "speed", unit: "m/s", minimum: 0, maximum: 52.3 },
  { key: "pressure", label: "pressure", unit: "Pa", minimum: -0.4e6, maximum: 1.25e6 },
  { key: "damage", label: "damage", unit: "1", minimum: 0, maximum: 1 },
  { key: "body", label: "body", unit: "1", minimum: 0, maximum: 2, names: ["block", "table", "jet"] },
];

// The same numbers at every run, as the tests compare pictures.
function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function lattice(low, high, spacing) {
  const counts = low.map((start, axis) => Math.max(1, Math.round((high[axis] - start) / spacing)));
  const places = [];
  for (let k = 0; k < counts[2]; ++k)
    for (let j = 0; j < counts[1]; ++j)
      for (let i = 0; i < counts[0]; ++i)
        places.push([i, j, k].map((n, axis) => (counts[axis] === 1 ? 0.5 * (low[axis] + high[axis]) : low[axis] + (n + 0.5) * spacing)));
  return places;
}

function layout(dimension) {
  const flat = dimension === 2;
  const depth = flat ? 0 : 0.008;
  const [fine, coarse] = flat ? [0.0002, 0.0004] : [0.0006, 0.0009];
  return {
    dimension,
    flat,
    minimum: [-0.025, -0.014, flat ? 0 : -0.012],
    maximum: [0.025, 0.02, flat ? 0 : 0.012],
    block: lattice([-0.014, -0.01, -depth], [0.014, 0, depth], coarse),
    table: lattice([-0.02, -0.012, -depth - 0.002], [0.02, -0.0105, depth + 0.002], 2 * coarse),
    jet: lattice([-0.0015, 0, flat ? 0 : -0.0015], [0.0015, 0.16, flat ? 0 : 0.0015], fine),
    spacings: [fine, coarse, 2 * coarse],
  };
}

const bodyOf = (category) => (category === water ? 2 : category === plate ? 1 : 0);
const across = ([x, , z]) => Math.hypot(x, z);

function particlesAt(time, { flat, block, table, jet, minimum, maximum }) {
  const chance = random(7);
  const front = -Math.min(0.009, Math.max(0, time - 0.2e-3) * 4.5);
  const kerf = 0.0022;
  const made = [];
  const add = (place, category, size, values) => made.push({ place, category, size, values: [...values, bodyOf(category)] });
  for (const place of table) add(place, plate, 2, [0, 0, 0]);
  for (const place of block) {
    const distance = across(place) + 0.0006 * (chance() - 0.5);
    const above = place[1] > front;
    const share = Math.exp(-Math.hypot(place[0], place[1] - front, place[2]) / 0.003);
    if (above && distance < 0.8 * kerf && chance() < 0.6) continue; // washed out
    const broken = above && distance < kerf;
    const wave = 1.1e6 * share - 0.35e6 * Math.exp(-(((distance - 0.006) / 0.002) ** 2));
    add(place, broken ? fractured : solid, 1, [40 * share * (broken ? 1 : 0.2), wave, broken ? 1 : Math.min(1, 2 * share)]);
  }
  for (const start of jet) {
    if (!flat && across(start) > 0.0015) continue;
    const y = start[1] + 0.004 - speed * time;
    const beyond = front + 0.0004 - y;
    if (beyond <= 0) {
      if (y < maximum[1]) add([start[0], y, start[2]], water, 0, [50 + 2 * chance(), 1e6 * Math.exp((front - y) / 0.001), 0]);
      continue;
    }
    const side = start[0] < 0 ? -1 : 1;
    const turn = flat ? 0 : Math.atan2(start[2], start[0]) + 0.2 * chance();
    const reach = 0.0012 + 0.35 * beyond * (0.6 + 0.8 * chance());
    const x = flat ? side * reach : reach * Math.cos(turn);
    const z = flat ? 0 : reach * Math.sin(turn);
    const height = front + 0.65 * beyond * (0.5 + chance());
    const place = [x, height, z];
    if (height < 0 && Math.hypot(x, z) > 0.0018) continue;
    if (place.every((part, axis) => (flat && axis === 2) || (part > minimum[axis] && part < maximum[axis])))
      add(place, water, 0, [14 + 10 * chance(), 0.02e6, 0]);
  }
  return made;
}

export function pack(particles, { dimension, minimum, maximum }, ranges = fields) {
  const count = particles.length;
  const bytes = Buffer.alloc(count * (2 * dimension + 2 + ranges.length));
  let offset = 0;
  for (let axis = 0; axis < dimension; ++axis)
    for (const { place } of particles) {
      const share = (place[axis] - minimum[axis]) / (maximum[axis] - minimum[axis]);
      offset = bytes.writeUInt16LE(Math.round(65535 * Math.min(Math.max(share, 0), 1)), offset);
    }
  for (const { category } of particles) offset = bytes.writeUInt8(category, offset);
  for (const { size } of particles) offset = bytes.writeUInt8(size, offset);
  ranges.forEach((range, at) => {
    for (const { values } of particles) {
      const share = (values[at] - range.minimum) / (range.maximum - range.minimum);
      offset = bytes.writeUInt8(Math.round(255 * Math.min(Math.max(share, 0), 1)), offset);
    }
  });
  return deflateSync(bytes);
}

function curves() {
  const time = Array.from({ length: 400 }, (_, at) => (at / 399) * (frameCount - 1) * interval);
  const cut = 2.2e-3;
  const along = (law) => time.map((t) => law(t));
  return {
    time,
    groups: [
      { label: "Depth of the water front", unit: "m", series: [{ key: "front_depth", label: "front depth", values: along((t) => Math.min(0.009, Math.max(0, t - 0.2e-3) * 4.5)) }] },
      {
        label: "Energy by kind",
        unit: "J/m",
        series: [
          { key: "kinetic", label: "kinetic", values: along((t) => 5e3 * t * 1e3 * Math.exp(-t / 2e-3)) },
          { key: "pressure", label: "work against pressure", values: along((t) => 900 * Math.sin(t * 9e3) ** 2) },
          { key: "fracture", label: "lost to fracture", values: along((t) => (t < 0.3e-3 ? null : 1e6 * (t - 0.3e-3))) },
        ],
      },
      {
        label: "Errors of the balances",
        unit: "%",
        series: [
          { key: "energy", label: "energy", values: along((t) => 0.02 * Math.sin(t * 2e3) - 3 * t) },
          { key: "mass", label: "mass", values: along(() => 0) },
        ],
      },
      { label: "Force on the plate", unit: "N/m", series: [{ key: "force", label: "vertical", values: along((t) => -4e4 * (1 - Math.exp(-t / 1e-3)) * (1 + 0.1 * Math.sin(t * 3e4))) }] },
    ],
    marks: [
      { time: 0.28e-3, label: "contact" },
      { time: cut, label: "cut through" },
    ],
  };
}

export function sampleRun(dimension) {
  const world = layout(dimension);
  const frames = Array.from({ length: frameCount }, (_, at) => {
    const particles = particlesAt(at * interval, world);
    return { time: at * interval, count: particles.length, data: pack(particles, world).toString("base64") };
  });
  return {
    title: `Jet into a block, ${dimension}D`,
    dimension,
    live: false,
    minimum: world.minimum,
    maximum: world.maximum,
    categories: structuredClone(categories),
    spacings: world.spacings,
    fields: structuredClone(fields),
    frames,
    curves: curves(),
  };
}
