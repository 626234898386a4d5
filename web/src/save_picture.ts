// SPDX-License-Identifier: Apache-2.0
// The picture as a file, with what is needed to read it: title, time, colours, scale.

import { cssColour, groupColour } from "./colour_maps.ts";
import { legendText, paintBar } from "./legend.ts";
import type { Scale } from "./overlays.ts";
import type { Category, Field } from "./run.ts";

export interface Caption {
  title: string;
  time: string;
  field: Field | undefined;
  categories: Category[]; // those that are shown
  scale: Scale | undefined;
}

const ink = "#22272e";

function drawField(context: CanvasRenderingContext2D, field: Field, x: number, y: number, em: number) {
  const words = legendText(field);
  const width = 14 * em;
  context.fillText(words.title, x, y);
  const left = x + context.measureText(words.title).width + 1.5 * em;
  const bar = document.createElement("canvas");
  bar.width = 256;
  bar.height = 1;
  paintBar(bar, field);
  context.drawImage(bar, left, y - 0.8 * em, width, 0.7 * em);
  context.textAlign = "center";
  for (const tick of words.ticks) context.fillText(tick.label, left + tick.share * width, y + 1.2 * em);
  context.textAlign = "left";
}

interface Named {
  label: string;
  colour: string;
}

function groupsOf(names: string[]): Named[] {
  return names.map((label, at) => ({ label, colour: cssColour(groupColour(at)) }));
}

function drawCategories(context: CanvasRenderingContext2D, categories: Named[], x: number, y: number, em: number) {
  for (const { label, colour } of categories) {
    context.fillStyle = colour;
    context.beginPath();
    context.arc(x + 0.4 * em, y - 0.35 * em, 0.4 * em, 0, 2 * Math.PI);
    context.fill();
    context.fillStyle = ink;
    context.fillText(label, x + 1.1 * em, y);
    x += context.measureText(label).width + 2.6 * em;
  }
}

function drawScale(context: CanvasRenderingContext2D, scale: Scale, right: number, y: number, em: number, ratio: number) {
  const length = scale.pixels * ratio;
  context.fillRect(right - length, y, length, 0.2 * em);
  context.textAlign = "center";
  context.fillText(scale.label, right - 0.5 * length, y - 0.4 * em);
  context.textAlign = "left";
}

/** The canvas must have been drawn in this very task: browsers empty it after. */
export function composePicture(source: HTMLCanvasElement, caption: Caption): HTMLCanvasElement {
  const ratio = source.width / source.clientWidth;
  const em = Math.round(13 * ratio);
  const space = 1.5 * em;
  const [top, bottom] = [3 * em, 4.2 * em];
  const picture = document.createElement("canvas");
  picture.width = source.width;
  picture.height = source.height + top + bottom;
  const context = picture.getContext("2d")!;
  context.fillStyle = "#fff";
  context.fillRect(0, 0, picture.width, picture.height);
  context.drawImage(source, 0, top);
  context.fillStyle = ink;
  const font = "system-ui, 'Noto Sans', 'DejaVu Sans', sans-serif";
  context.font = `600 ${1.15 * em}px ${font}`;
  context.fillText(caption.title, space, 1.9 * em, picture.width - space - 9 * em);
  context.font = `${em}px ${font}`;
  context.textAlign = "right";
  context.fillText(caption.time, picture.width - space, 1.9 * em);
  context.textAlign = "left";
  const baseline = top + source.height + 1.7 * em;
  if (caption.scale) drawScale(context, caption.scale, picture.width - space, baseline, em, ratio);
  if (caption.field?.names) drawCategories(context, groupsOf(caption.field.names), space, baseline, em);
  else if (caption.field) drawField(context, caption.field, space, baseline, em);
  else drawCategories(context, caption.categories, space, baseline, em);
  return picture;
}

export function download(picture: HTMLCanvasElement, name: string) {
  picture.toBlob((blob) => {
    if (!blob) return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }, "image/png");
}
