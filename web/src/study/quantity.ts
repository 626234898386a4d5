// SPDX-License-Identifier: Apache-2.0
// Keys and metrics by the names and in the units that people read.

import { formatNumber, join, prefixFor, timeUnit } from "../quantities.ts";
import { numberOf, type Setting, type StudyData } from "./study_data.ts";

export interface Quantity {
  name: string; // as in study.json
  label: string;
  help: string; // what a key means; "" for a metric
  unit: string; // that is shown
  factor: number; // a number in SI divided by it is in that unit
  isLogarithmic: boolean;
  isKey: boolean;
}

const written: Record<string, string> = { "J/m3": "J/m³", "J/m2": "J/m²", m2: "m²", m3: "m³", "1": "" };

export class Quantities {
  private readonly known = new Map<string, Quantity>();

  constructor(private readonly data: StudyData) {}

  get(name: string): Quantity {
    let quantity = this.known.get(name);
    if (!quantity) this.known.set(name, (quantity = this.make(name)));
    return quantity;
  }

  private make(name: string): Quantity {
    const { study, units, labels, help } = this.data;
    const key = study.keys.find((one) => one.key === name);
    if (key)
      return {
        name,
        label: labels[name] ?? name,
        help: help[name] ?? "",
        unit: written[key.shown_unit] ?? key.shown_unit,
        factor: key.shown_factor,
        isLogarithmic: key.scale === "log",
        isKey: true,
      };
    const unit = units[name] ?? "";
    const sizes = study.runs.map((run) => Math.abs(numberOf(run, name) ?? 0));
    const largest = Math.max(0, ...sizes);
    const time = unit === "s" ? timeUnit(largest) : undefined;
    const prefix = prefixFor(largest, unit);
    return {
      name,
      label: labels[name] ?? name,
      help: help[name] ?? "",
      unit: time?.unit ?? prefix.symbol + (written[unit] ?? unit),
      factor: time?.seconds ?? 1 / prefix.factor,
      isLogarithmic: false,
      isKey: false,
    };
  }

  /** "4.16 m/s" */
  show(name: string, value: number | null | undefined, digits = 3): string {
    if (value === null || value === undefined) return "—";
    const { factor, unit } = this.get(name);
    return join(formatNumber(value / factor, digits), unit);
  }

  /** "3.81 to 4.5 m/s" */
  showRange(name: string, low: number, high: number, words = "to"): string {
    const { factor, unit } = this.get(name);
    return join(`${formatNumber(low / factor)} ${words} ${formatNumber(high / factor)}`, unit);
  }

  /** "pressure 20 MPa, angle 5 deg" */
  showSetting(setting: Setting): string {
    const parts = Object.entries(setting).map(([name, value]) => {
      const words = typeof value === "number" ? this.show(name, value) : value;
      return `${this.get(name).label} ${words}`;
    });
    return parts.join(", ");
  }
}

/** "depth of the kerf / mm" */
export function titleOf({ label, unit }: Quantity): string {
  if (unit === "") return label;
  return unit.includes("/") ? `${label} / (${unit})` : `${label} / ${unit}`;
}
