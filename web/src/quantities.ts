// SPDX-License-Identifier: Apache-2.0
// Numbers with units, for readers.

export interface Prefix {
  factor: number;
  symbol: string;
}

const day = 86400; // s
const narrowSpace = "\u202f";
const prefixes: [number, string][] = [
  [1e12, "T"],
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];
const none: Prefix = { factor: 1, symbol: "" };

// "km/s" and "mm^2" would be misread or wrong, "kkg" is no unit, and "mm" has its prefix already.
function takesPrefix(unit: string): boolean {
  if (unit === "m" || unit === "s") return true;
  return /^(Pa|J|N|W|Hz)(?![a-z0-9²³^])/i.test(unit);
}

export function prefixFor(size: number, unit: string): Prefix {
  if (!takesPrefix(unit) || !Number.isFinite(size) || size === 0) return none;
  if (unit === "s" && size >= 1) return none; // longer times are minutes and hours
  // 999.96 would be written as 1000, which is better said as 1 k.
  const rounded = Number(Math.abs(size).toPrecision(3));
  const [value, symbol] = prefixes.find(([least]) => rounded >= least) ?? prefixes[prefixes.length - 1];
  return { factor: 1 / value, symbol };
}

export function formatNumber(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return "—";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(digits));
  if (size >= 1e-4 && size < 1e6) return String(rounded).replace("-", "−");
  const power = Math.floor(Math.log10(Math.abs(rounded)));
  const mantissa = Number((rounded / 10 ** power).toPrecision(digits));
  return `${mantissa}·10${superscript(power)}`.replace("-", "−");
}

function superscript(power: number): string {
  const raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return [...String(power)].map((sign) => (sign === "-" ? "⁻" : raised[Number(sign)])).join("");
}

/** "12.3 ms"; a unit of "1" or "" is left out. */
export function formatQuantity(value: number, unit: string, digits = 3): string {
  if (unit === "s" && value >= 60) return duration(value);
  const prefix = prefixFor(value, unit);
  return join(formatNumber(value * prefix.factor, digits), prefix.symbol + plainUnit(unit));
}

// "3 min 20 s", "1 h 05 min", "12 days", "2.5 years", as duration_text() of the program has it.
function duration(seconds: number): string {
  const whole = Math.round(seconds);
  const two = (part: number) => String(part).padStart(2, "0");
  if (whole < 3600) return `${join(String(Math.floor(whole / 60)), "min")} ${join(two(whole % 60), "s")}`;
  if (seconds >= 365.25 * day) return join(String(Number((seconds / (365.25 * day)).toPrecision(2))), "years");
  if (seconds >= 2 * day) return join(String(Math.round(seconds / day)), "days");
  return `${join(String(Math.floor(whole / 3600)), "h")} ${join(two(Math.floor((whole % 3600) / 60)), "min")}`;
}

/** The unit in which a column writes times of up to `size` seconds. */
export function timeUnit(size: number): { seconds: number; unit: string } | undefined {
  if (size >= 3600) return { seconds: 3600, unit: "h" };
  return size >= 60 ? { seconds: 60, unit: "min" } : undefined;
}

export function plainUnit(unit: string): string {
  return unit === "1" ? "" : unit;
}

export function join(number: string, unit: string): string {
  return unit === "" ? number : number + narrowSpace + unit;
}

export function formatCount(count: number): string {
  return String(count).replace(/\B(?=(\d{3})+$)/g, narrowSpace);
}

/** Writes all times of a run alike, so that the label does not jump as the run plays. */
export function timeFormat(times: number[]): (time: number) => string {
  const last = times.length > 0 ? Math.max(...times.map(Math.abs)) : 0;
  const prefix = prefixFor(last, "s");
  const steps = times.slice(1).map((time, at) => time - times[at]);
  const typical = steps.sort((a, b) => a - b)[Math.floor(steps.length / 2)] || last;
  // Enough to write the typical step with two digits: 0.25 ms, but 0.2 ms.
  const step = Number((typical * prefix.factor).toPrecision(2)).toFixed(6);
  const decimals = step.replace(/0+$/, "").split(".")[1].length;
  return (time) => join((time * prefix.factor).toFixed(decimals).replace("-", "−"), `${prefix.symbol}s`);
}

/** The largest of 1, 2, 5 times a power of ten that is not above `limit`. */
export function roundLength(limit: number): number {
  const power = 10 ** Math.floor(Math.log10(limit));
  const lead = [5, 2, 1].find((candidate) => candidate * power <= limit * (1 + 1e-9)) ?? 1;
  return lead * power;
}

/** Round values from `minimum` to `maximum`, about `wanted` of them. */
export function roundTicks(minimum: number, maximum: number, wanted: number): number[] {
  const span = maximum - minimum;
  if (!(span > 0)) return [minimum];
  const power = 10 ** Math.floor(Math.log10(span / wanted));
  const misses = (size: number) => Math.abs(span / size - wanted);
  const step = [1, 2, 5, 10].map((lead) => lead * power).reduce((a, b) => (misses(b) < misses(a) ? b : a));
  const first = Math.ceil(minimum / step - 1e-6);
  const last = Math.floor(maximum / step + 1e-6);
  return Array.from({ length: last - first + 1 }, (_, at) => Number(((first + at) * step).toPrecision(12)));
}
