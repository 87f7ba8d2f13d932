// What is given up for what: the objective against the limit of a constraint.
import { h } from '../dom';
import { quantity, siOf, typed } from '../quantity';
import type { Front } from '../searches';
import type { Task } from '../searching';
import { ends, figure, note, placed, svg, type Frame } from './plot';

const size = { width: 220, height: 110 };

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
    const there = points.map((p, k) => ({ ...p, k })).filter((p) => p.objective !== null);
    const frame: Frame = { ...size, x: ends(there.map((p) => p.used)), y: ends(there.map((p) => p.objective!)) };
    const circles = there.map((p) => {
      const [cx, cy] = placed(frame, [p.used, p.objective!]);
      const circle = svg('circle', { cx, cy, r: 4, class: !p.kept ? 'missed point' : p.dominated ? 'looked point' : 'best point' });
      circle.addEventListener('click', () => this.actions.reinstate(search, p.k));
      return circle;
    });
    const words = (p: (typeof there)[number]) => `${quantity(p.used, limit.unit)}: ${quantity(p.objective, objective.unit)}`;
    return [
      figure(frame, `${objective.name} against ${limit.constraint}: ${there.map(words).join('; ')}`, ...circles, note(4, 10, quantity(frame.y[1], objective.unit)), note(size.width - 4, size.height - 3, `${limit.constraint} ${quantity(frame.x[1], limit.unit)}`, 'end')),
      h(
        'div',
        { className: 'incumbents' },
        ...there.map((p) => h('button', { type: 'button', title: 'Take this design', 'data-point': p.k, onclick: () => this.actions.reinstate(search, p.k) }, words(p), p.kept ? '' : ' ✗')),
      ),
    ];
  }
}
