// What is given up for what: the objective against the limit of a constraint.
import { h } from '../dom';
import { quantity, siOf, typed } from '../quantity';
import type { Front } from '../searches';
import type { Task } from '../searching';
import { ends, figure, note, placed, svg, type Frame } from './plot';

const small = { width: 220, height: 110 };

type Named = { name: string; unit: string };

/** The best objective at each limit. @param x what is used of the limit, or the limit itself */
export function frontFigure(
  points: { x: number; objective: number; kept: boolean; dominated: boolean }[],
  objective: Named,
  across: Named,
  size: { width: number; height: number },
): { figure: SVGSVGElement; circles: SVGCircleElement[] } {
  const frame: Frame = { ...size, x: ends(points.map((p) => p.x)), y: ends(points.map((p) => p.objective)) };
  const circles = points.map((p) => {
    const [cx, cy] = placed(frame, [p.x, p.objective]);
    return svg('circle', { cx, cy, r: 4, class: !p.kept ? 'missed point' : p.dominated ? 'looked point' : 'best point' });
  });
  const words = points.map((p) => `${quantity(p.x, across.unit)}: ${quantity(p.objective, objective.unit)}`);
  const label = `${objective.name} against ${across.name}: ${words.join('; ')}`;
  const notes = [note(4, 10, quantity(frame.y[1], objective.unit)), note(size.width - 4, size.height - 3, `${across.name} ${quantity(frame.x[1], across.unit)}`, 'end')];
  return { figure: figure(frame, label, ...circles, ...notes), circles };
}

export interface FrontActions {
  start: (body: { constraint: string; from: number; to: number; levels: number }) => void;
  reinstate: (search: number, point: number) => void;
}

export class SearchFront {
  readonly element: HTMLElement;
  private readonly constraint = h('select', { id: 'front-constraint', 'aria-label': 'Constraint', onchange: () => this.propose() });
  private readonly from = h('input', { type: 'text', id: 'front-from', 'aria-label': 'Limit from', autocomplete: 'off' });
  private readonly to = h('input', { type: 'text', id: 'front-to', 'aria-label': 'Limit to', autocomplete: 'off' });
  private readonly levels = h('input', { type: 'text', id: 'front-levels', 'aria-label': 'Number of limits', value: '5', defaultValue: '5', inputMode: 'numeric' });
  private readonly plot = h('div', { className: 'front' });
  private task: Task | null = null;

  constructor(private readonly actions: FrontActions) {
    this.element = h(
      'div',
      {},
      h(
        'form',
        { className: 'front-form', onsubmit: (event: Event) => this.submit(event) },
        this.constraint,
        this.from,
        this.to,
        this.levels,
        h('button', { type: 'submit', id: 'front-start' }, 'Trade off'),
      ),
      this.plot,
    );
  }

  offer(task: Task): void {
    const names = (t: Task | null) => t?.constraints.map((c) => c.name).join('\n');
    const others = names(task) !== names(this.task);
    this.task = task;
    if (!others) return;
    this.constraint.replaceChildren(...task.constraints.map((c) => h('option', { value: c.name }, c.name)));
    this.propose();
  }

  /** Limits about the one that there is. */
  private propose(): void {
    const chosen = this.task?.constraints.find((c) => c.name === this.constraint.value);
    if (!chosen || chosen.limit === null) return;
    this.from.value = typed(0.5 * chosen.limit, chosen.unit);
    this.to.value = typed(chosen.limit, chosen.unit);
  }

  private submit(event: Event): void {
    event.preventDefault();
    const chosen = this.task?.constraints.find((c) => c.name === this.constraint.value);
    if (!chosen) return;
    const { unit } = chosen;
    this.actions.start({ constraint: chosen.name, from: siOf(this.from.value, unit), to: siOf(this.to.value, unit), levels: Number(this.levels.value) });
  }

  show(search: Front | null): void {
    this.element.hidden = (this.task?.constraints.length ?? 0) === 0;
    this.plot.replaceChildren(...(search ? this.drawn(search) : []));
  }

  private drawn({ search, front, done, of, phase }: Front): Node[] {
    if (!front) return [h('p', { className: 'hint', role: 'status' }, phase === 'running' ? `search ${done + 1} of ${of}` : '')];
    const { points, objective, limit } = front;
    const there = points.map((p, k) => ({ ...p, k, x: p.used })).filter((p) => p.objective !== null);
    const drawn = frontFigure(there.map((p) => ({ ...p, objective: p.objective! })), objective, { name: limit.constraint, unit: limit.unit }, small);
    drawn.circles.forEach((circle, k) => circle.addEventListener('click', () => this.actions.reinstate(search, there[k]!.k)));
    const words = (p: (typeof there)[number]) => `${quantity(p.used, limit.unit)}: ${quantity(p.objective, objective.unit)}`;
    return [
      drawn.figure,
      h(
        'div',
        { className: 'incumbents' },
        ...there.map((p) => h('button', { type: 'button', title: 'Take this design', 'data-point': p.k, onclick: () => this.actions.reinstate(search, p.k) }, words(p), p.kept ? '' : ' ✗')),
      ),
    ];
  }
}
