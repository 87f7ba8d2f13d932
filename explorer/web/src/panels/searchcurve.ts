// How a search goes on: what was best, and the bound where there is one.
import { quantity } from '../quantity';
import type { Selection, ValueSearch } from '../searches';
import { ends, figure, note, placed, steps, svg, type Frame } from './plot';

const small = { width: 220, height: 110 };

/** What a person did, after so many evaluations. */
export interface Mark {
  evaluation: number;
  text: string;
}

/** Incumbents of each round as steps, every evaluation as a dot: faint where edges are soft. */
export function searchCurve(search: Pick<ValueSearch, 'objective' | 'incumbents' | 'designs' | 'evaluations' | 'best'>, size = small, marks: Mark[] = []): SVGSVGElement {
  const { objective, incumbents, designs, evaluations } = search;
  const last = incumbents[incumbents.length - 1]?.round ?? 0;
  const values = incumbents.map((i) => i.objective ?? NaN);
  const near = designs.map((d) => d.objective ?? NaN).filter((v) => values.length > 0 && v <= Math.max(...values));
  const frame: Frame = { ...size, x: [0, Math.max(1, evaluations)], y: ends([...values, ...near]) };
  const dots = designs.flatMap((d) => {
    if (d.objective === null || d.objective > frame.y[1] || d.objective < frame.y[0]) return [];
    const [cx, cy] = placed(frame, [d.evaluation, d.objective]);
    return [svg('circle', { cx, cy, r: 1.5, class: d.soft ? 'soft' : d.feasible ? 'looked' : 'missed' })];
  });
  const rounds = [...new Set(incumbents.map((i) => i.round))];
  const lines = rounds.map((round) => {
    const own = incumbents.filter((i) => i.round === round);
    const next = incumbents.find((i) => i.round > round);
    return steps(frame, own.map((i) => [i.evaluation, i.objective ?? NaN] as const), next?.evaluation ?? evaluations, 'best');
  });
  const best = search.best === null ? 'nothing that keeps the constraints yet' : `best ${quantity(search.best, objective.unit, 4)}`;
  const label = `${objective.name}: ${best} after ${evaluations} evaluations, round ${last}`;
  return figure(frame, label, ...dots, ...lines, ...marks.flatMap((mark, k) => marked(frame, mark, k)), ...labels(frame, objective.unit, `${evaluations} evaluations`));
}

/** The best choice so far, and what no choice can be below. */
export function boundCurve(selection: Selection): SVGSVGElement {
  const { curve, unit } = selection;
  const end = curve[curve.length - 1];
  const frame: Frame = {
    ...small,
    x: [0, Math.max(0.1, end?.seconds ?? 0)],
    y: ends(curve.flatMap((p) => [p.value ?? NaN, p.bound ?? NaN])),
  };
  const line = (key: 'value' | 'bound', className: string) =>
    steps(frame, curve.flatMap((p) => (p[key] === null ? [] : [[p.seconds, p[key]] as const])), frame.x[1], className);
  const label = end ? `best ${quantity(end.value, unit, 4)}, no choice is below ${quantity(end.bound, unit, 4)}` : 'nothing is chosen yet';
  return figure(frame, label, line('value', 'best'), line('bound', 'bound'), ...labels(frame, unit, `${(end?.seconds ?? 0).toFixed(1)} s`));
}

/** Texts stand one below the other, so that those of one time don't cover each other. */
function marked(frame: Frame, { evaluation, text }: Mark, k: number): SVGElement[] {
  const [x] = placed(frame, [evaluation, 0]);
  const right = x > frame.width / 2;
  return [
    svg('line', { x1: x, x2: x, y1: 0, y2: frame.height, class: 'act' }),
    note(x + (right ? -4 : 4), 24 + 12 * (k % 8), text, right ? 'end' : 'start'),
  ];
}

function labels({ width, height, y }: Frame, unit: string, x: string): SVGElement[] {
  return [note(4, 10, quantity(y[1], unit)), note(4, height - 3, quantity(y[0], unit)), note(width - 4, 10, x, 'end')];
}
