// Quantities for people: a few digits and a handy unit, as the program prints them.

export interface DisplayUnit {
  name: string;
  /** Display units per SI unit. */
  factor: number;
}

const prefixes: [string, number][] = [
  ['k', 1e3],
  ['', 1],
  ['m', 1e-3],
  ['µ', 1e-6],
  ['n', 1e-9],
];

/** Metres, seconds, hertz and their rates take a prefix, radians become degrees. */
export function displayUnit(si: number, unit: string): DisplayUnit {
  if (unit === '1') return { name: '', factor: 1 };
  if (unit === 'rad' || unit.startsWith('rad/'))
    return { name: unit.replace('rad', 'deg'), factor: 180 / Math.PI };
  const head = unit === '1/s' ? 'Hz' : unit;
  const match = /^(m|s|Hz)(\^2)?(\/.*)?$/.exec(head);
  if (!match) return { name: unit, factor: 1 };
  const power = match[2] ? 2 : 1;
  const size = Math.abs(si) * (1 + 1e-9);
  const [prefix, step] =
    prefixes.find(([p, s]) => size >= s ** power && (p !== 'k' || match[1] === 'Hz')) ??
    (size > 0 ? prefixes[prefixes.length - 1]! : prefixes[1]!);
  return { name: prefix + head, factor: 1 / step ** power };
}

/** Up to so many significant digits, without trailing zeros. */
export function digits(value: number, count = 3): string {
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = value.toPrecision(count);
  if (size >= 1e6 || size < 1e-4) return Number(text).toExponential();
  return String(Number(text));
}

export function quantity(
  si: number | null | undefined,
  unit: string,
  count = 3,
  as = displayUnit(si ?? 0, unit),
): string {
  if (si === null || si === undefined || !Number.isFinite(si)) return 'not observed';
  return `${digits(si * as.factor, count)} ${raised(as.name)}`.trim();
}

/** "m²" of "m^2". */
export const raised = (unit: string) =>
  unit.replace(/\^(-?\d+)/g, (_, power: string) =>
    [...power].map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]!)).join(''),
  );

/** As a scene would say it: what `quantity` shows may be typed, too. */
export function typed(si: number, unit: string, as = displayUnit(si, unit)): string {
  // A unit of nothing but a divisor stands for itself.
  const unitText = as.name.startsWith('1/') ? '' : as.name;
  return `${digits(si * as.factor, 5)} ${unitText}`.trim();
}

export const percent = (part: number) => `${digits(100 * part, 2)} %`;
export const counted = (n: number, noun: string) => `${n} ${noun}${n === 1 ? '' : 's'}`;

const sizes: Record<string, number> = { k: 1e3, '': 1, c: 1e-2, m: 1e-3, µ: 1e-6, u: 1e-6, n: 1e-9 };

/** "17.4 mm", "0.0174", "3 deg" or, a power of ten, "-1.76 log m", in SI units; not a number
 * where it is something else. */
export function siOf(text: string, unit: string): number {
  const match = /^\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*(log)?\s*(\S*)\s*$/i.exec(text);
  if (!match) return NaN;
  const [, digits, log, named] = match;
  const value = log ? 10 ** Number(digits) : Number(digits);
  if (!named || named === unit) return value;
  if (unit.startsWith('rad')) return named === unit.replace('rad', 'deg') ? (value * Math.PI) / 180 : NaN;
  const head = unit === '1/s' ? 'Hz' : unit;
  const power = head.includes('^2') ? 2 : 1;
  const prefix = named.endsWith(head) ? named.slice(0, named.length - head.length) : '?';
  return value * (sizes[prefix] ?? NaN) ** power;
}

/** How values are written: with the prefix that reads best, in SI units, or as powers of ten. */
export type Units = 'auto' | 'si' | 'log10';

/** Values of a scale as they are labelled, and the unit behind them. */
export function labelling(units: Units, largest: number, unit: string): { name: string; of: (si: number) => string } {
  if (units === 'log10')
    return { name: unit === '1' ? 'log₁₀' : `log₁₀ ${unit}`, of: (si) => (si > 0 ? digits(Math.log10(si), 4) : '') };
  const as = units === 'si' ? { name: unit === '1' ? '' : unit, factor: 1 } : displayUnit(largest, unit);
  return { name: as.name, of: (si) => digits(si * as.factor) };
}
