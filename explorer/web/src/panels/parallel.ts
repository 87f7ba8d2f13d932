// Parallel coordinates: each design a line across the axes of the variables.
import { quantity } from '../quantity';
import type { Looked, Round, ValueSearch } from '../searches';
import { figure, note, rounded, svg, type Frame } from './plot';

const small = { width: 220, height: 130 };
const inner = { left: 8, right: 8, top: 8, bottom: 24 };
/** Names of more axes than these would cover each other. */
const mostNames = 6;

const short = (path: string) => path.replace(/^devices\./, '').replace('.params.', '.');

function line(design: Looked, round: Round, className: string, height: number, across: (k: number) => number): SVGPathElement {
  const d = design.values.map((value, k) => {
    const [low, high] = [round.lower[k]!, round.upper[k]!];
    const v = value ?? low;
    const part = round.logarithmic[k] ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low);
    return rounded([across(k), height - inner.bottom - part * (height - inner.top - inner.bottom)]);
  });
  return svg('path', { d: `M${d.join('L')}`, class: className });
}

/** Designs of the last round: all faint, those that were the best of their time clearer, the best
 * of all strong. */
export function parallelCoordinates(search: Pick<ValueSearch, 'rounds' | 'incumbents' | 'designs'>, unitOf: (path: string) => string, size = small): SVGSVGElement | null {
  const round = search.rounds[search.rounds.length - 1];
  if (!round) return null;
  const n = round.variables.length;
  const { width, height } = size;
  const across = (k: number) => inner.left + (n > 1 ? k / (n - 1) : 0.5) * (width - inner.left - inner.right);
  const axes = round.variables.map((path, k) => {
    const bounds = `${short(path)}: ${quantity(round.lower[k], unitOf(path))} to ${quantity(round.upper[k], unitOf(path))}`;
    return svg('line', { x1: across(k), x2: across(k), y1: inner.top, y2: height - inner.bottom, class: 'axis' }, svg('title', {}, bounds));
  });
  const own = <T extends Looked>(all: T[]) => all.filter((d) => d.round === round.round);
  const incumbents = own(search.incumbents);
  const lines = [
    ...own(search.designs).map((d) => line(d, round, d.feasible ? 'looked' : 'missed', height, across)),
    ...incumbents.map((d, k) => line(d, round, k === incumbents.length - 1 ? 'best' : 'incumbent', height, across)),
  ];
  const names = n > mostNames ? [] : round.variables.map((path, k) => note(across(k), height - (k % 2 ? 3 : 13), short(path), k === 0 ? 'start' : k === n - 1 ? 'end' : 'middle'));
  const frame: Frame = { ...size, x: [0, 1], y: [0, 1] };
  return figure(frame, `${incumbents.length} designs that were the best of their time, over ${n} variables`, ...axes, ...lines, ...names);
}
