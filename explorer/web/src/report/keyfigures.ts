// The figures of a field, or of two side by side.
import type { Field } from '../field';
import { said, saidChange, saidCount, table, verdict, type Cell } from './parts';

export function keyFigures(fields: Field[], names: string[]): HTMLElement {
  const all = fields.map((f) => f.summary);
  const larger = fields[0]!.largerIsBetter;
  const { name, unit } = all[0]!.metric;
  const change = (from: number | null | undefined, to: number | null | undefined): Cell => {
    if (from === null || from === undefined || to === null || to === undefined || from === 0) return '';
    const part = to / from - 1;
    return part === 0 ? '0 %' : verdict(larger ? part > 0 : part < 0, saidChange(part).text);
  };
  const row = (text: string, of: (s: (typeof all)[number]) => number | null | undefined): Cell[] => {
    const values = all.map(of);
    return [text, ...values.map((v) => said(v, unit)), ...(all.length === 2 ? [change(values[0], values[1])] : [])];
  };
  const count = (text: string, of: (s: (typeof all)[number]) => number): Cell[] => {
    const values = all.map(of);
    const by = values[values.length - 1]! - values[0]!;
    return [text, ...values.map(saidCount), ...(all.length === 2 ? [by === 0 ? '' : `${by > 0 ? '+' : '−'}${Math.abs(by)}`] : [])];
  };
  return table(
    'figures',
    `${name}, over the samples at which it is finite`,
    ['', ...names, ...(all.length === 2 ? ['change'] : [])],
    [
      row('least', (s) => s.min?.value),
      row('median', (s) => s.median),
      row('mean', (s) => s.mean),
      row(larger ? '95 % at least' : '95 % at most', (s) => s.p95),
      row('greatest', (s) => s.max?.value),
      count('samples', (s) => s.samples),
      count('observable samples', (s) => s.observable),
      count('one direction short', (s) => s.one_short ?? 0),
    ],
  );
}
