// From values to colours.
import { diverging, sequential, type MapName, type Rgb } from './maps';

/** How people want their colours. */
export interface Colouring {
  logarithmic: boolean;
  map: MapName;
  /** Dark is good. */
  reversed: boolean;
  /** Ends in SI units; null: those of the field. */
  low: number | null;
  high: number | null;
}

/** Where in the range a value is, and which colour it has: unless reversed, bright is good. */
export class Scale {
  constructor(
    readonly min: number,
    readonly max: number,
    readonly logarithmic: boolean,
    readonly brightIsLarge: boolean,
    readonly map: MapName = 'viridis',
    readonly difference = false,
  ) {}

  /** @param field what the range is taken from where the hand gives none */
  static of(field: { min: number; max: number; largerIsBetter: boolean }, as: Colouring): Scale {
    const low = as.low ?? field.min;
    const high = Math.max(low, as.high ?? field.max);
    return new Scale(low, high, as.logarithmic && low > 0, field.largerIsBetter !== as.reversed, as.map);
  }
  /** As far on both sides of no difference. */
  static ofDifference(min: number, max: number, largerIsBetter: boolean): Scale {
    const most = Math.max(Math.abs(min), Math.abs(max), 1e-12);
    return new Scale(-most, most, false, largerIsBetter, 'viridis', true);
  }

  /** 0 at the least value, 1 at the greatest. */
  part(value: number): number {
    if (!(this.max > this.min)) return 0.5;
    return this.logarithmic
      ? Math.log(value / this.min) / Math.log(this.max / this.min)
      : (value - this.min) / (this.max - this.min);
  }
  /** The value at a part of the range. */
  at(part: number): number {
    return this.logarithmic
      ? this.min * (this.max / this.min) ** part
      : this.min + part * (this.max - this.min);
  }
  colour(value: number): Rgb {
    const part = this.part(value);
    const t = this.brightIsLarge ? part : 1 - part;
    return this.difference ? diverging(t) : sequential(this.map, t);
  }
  /** A colour for CSS. */
  css(value: number): string {
    return `rgb(${this.colour(value).map((c) => Math.round(255 * c)).join(' ')})`;
  }

  /** Values whose powers of ten are round. */
  powers(): number[] {
    return roundBetween(Math.log10(this.min), Math.log10(this.max)).map((x) => 10 ** x);
  }

  /** Round values to label. @param factor display units per SI unit */
  ticks(factor: number): number[] {
    const low = this.min * factor;
    const high = this.max * factor;
    if (!(high > low)) return [this.min];
    const rounded: number[] = [];
    if (this.logarithmic && high / low > 8) {
      for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); ++e)
        for (const m of high / low > 1e3 ? [1] : [1, 2, 5]) rounded.push(m * 10 ** e);
    } else {
      rounded.push(...roundBetween(low, high));
    }
    return rounded.filter((x) => x >= low && x <= high).map((x) => x / factor);
  }
}

/** About five round numbers. */
function roundBetween(low: number, high: number): number[] {
  const rough = (high - low) / 5;
  if (!(rough > 0)) return [];
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((m) => m * decade >= rough)! * decade;
  const all: number[] = [];
  for (let k = Math.ceil(low / step); k * step <= high; ++k) all.push(k * step);
  return all;
}
