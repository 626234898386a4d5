// SPDX-License-Identifier: Apache-2.0
// Numbers as src/report/html.cpp writes them, read back.

const prefixes = { "": 1, n: 1e-9, µ: 1e-6, m: 1e-3, k: 1e3, M: 1e6, G: 1e9, T: 1e12 };
// In SI units; those of the second kind take no prefix.
const units = { m: 1, s: 1, Pa: 1, W: 1, "W/m": 1, Hz: 1, "m/s": 1, "J/m³": 1, "L/min": 1 / 6e4, "L/min/m": 1 / 6e4 };
const wholeUnits = { "": 1, "%": 0.01, "°": Math.PI / 180, "mm²": 1e-6, "mm³": 1e-9, "mm²/s": 1e-6, "mm³/s": 1e-9, kg: 1, "kg/m": 1 };

function factorOf(unit) {
  if (unit in wholeUnits) return wholeUnits[unit];
  if (unit in units) return units[unit];
  const [prefix, rest] = [unit.slice(0, 1), unit.slice(1)];
  if (prefix in prefixes && rest in units) return prefixes[prefix] * units[rest];
  throw new Error(`"${unit}" is no unit of a report`);
}

/** "4.32 mm", "1.2 · 10<sup>-7</sup> m", "12 345" or "5.4 %" as number, decimals kept, and the SI value of its unit. */
function parts(html) {
  const found = /^(-?\d[\d.\u202f]*)(?: · 10<sup>(-?\d+)<\/sup>)?\u202f?(\D.*)?$/.exec(html);
  if (!found) throw new Error(`"${html}" is no quantity`);
  const [, digits, power, unit = ""] = found;
  const number = Number(digits.replaceAll("\u202f", "")) * 10 ** Number(power ?? 0);
  return { number, factor: factorOf(unit), hasPower: power !== undefined };
}

const lasting = { s: 1, min: 60, h: 3600 };

/** "1 min 08 s" or "2 h 05 min" as seconds, with the last unit, s; null if it is no such time. */
function duration(html) {
  const found = /^(\d+)\s(min|h)\s(\d\d)\s(s|min)$/.exec(html);
  if (!found) return null;
  const [, whole, unit, rest, last] = found;
  return { seconds: whole * lasting[unit] + rest * lasting[last], last: lasting[last] };
}

/** In SI units; null for "—". */
export function readQuantity(html) {
  if (html === "—") return null;
  const time = duration(html);
  if (time) return time.seconds;
  const { number, factor } = parts(html);
  return number * factor;
}

/** Whether `html` shows `value`, rounded to so many digits in the unit shown; three before a power of ten. */
export function shows(html, value, digits) {
  if (html === "—" || value === null) return html === "—" && value === null;
  const time = duration(html);
  if (time) return Math.abs(time.seconds - value) <= (time.last === 1 ? 0.5 : time.last);
  const { number, factor, hasPower } = parts(html);
  const exact = value / factor;
  if (exact === 0) return number === 0;
  const last = 10 ** (Math.floor(Math.log10(Math.abs(exact))) - (hasPower ? 3 : digits) + 1);
  return Math.abs(number - exact) <= 0.5001 * last;
}
