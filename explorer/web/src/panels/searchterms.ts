// Two terms of a weighted objective against each other: what a search gave up for what.
import { h } from '../dom';
import { quantity } from '../quantity';
import type { ValueSearch } from '../searches';
import type { TermValues } from '../searching';
import { ends, figure, note, placed, svg, type Frame } from './plot';

const size = { width: 220, height: 130 };
/** Designs that are looked at, the newest. */
const most = 60;

export interface TermActions {
  terms: (search: number, incumbents: number[]) => Promise<TermValues | null>;
  reinstate: (search: number, incumbent: number) => void;
}

export class SearchTerms {
  readonly element: HTMLElement;
  private readonly axes: [HTMLSelectElement, HTMLSelectElement];
  private readonly plot = h('div', { className: 'terms-plot' });
  private search: ValueSearch | null = null;
  private found: { search: number; numbers: number[]; terms: TermValues } | null = null;

  constructor(private readonly actions: TermActions) {
    const axis = (name: string) => h('select', { 'aria-label': name, hidden: true, onchange: () => this.draw() });
    this.axes = [axis('Term across'), axis('Term upwards')];
    this.element = h(
      'form',
      {
        hidden: true,
        className: 'terms',
        onsubmit: (event: Event) => {
          event.preventDefault();
          void this.ask();
        },
      },
      h('div', { className: 'vary' }, ...this.axes, h('button', { type: 'submit', id: 'plot-terms', title: 'What each term is worth of the designs that were the best of their time' }, 'Plot terms')),
      this.plot,
    );
  }

  /** Whether the objective has more terms than one. */
  several(yes: boolean): void {
    this.element.hidden = !yes;
  }

  show(search: ValueSearch | null): void {
    this.search = search;
  }

  private async ask(): Promise<void> {
    const { search } = this;
    if (!search || search.incumbents.length === 0) return;
    const numbers = search.incumbents.slice(-most).map((i) => i.number);
    const terms = await this.actions.terms(search.search, numbers);
    if (!terms) return;
    this.found = { search: search.search, numbers, terms };
    this.axes.forEach((select, k) => {
      const chosen = select.value || String(k);
      select.replaceChildren(...terms.terms.map((t, i) => h('option', { value: String(i) }, `${i + 1}: ${t.name}`)));
      select.value = Number(chosen) < terms.terms.length ? chosen : String(k);
      select.hidden = false;
    });
    this.draw();
  }

  private draw(): void {
    if (!this.found) return;
    const { search, numbers, terms } = this.found;
    const [i, j] = this.axes.map((select) => Number(select.value)) as [number, number];
    const points = terms.values.flatMap((row, k) => {
      const [x, y] = [row[i], row[j]];
      return x == null || y == null ? [] : [{ x, y, number: numbers[k]! }];
    });
    const frame: Frame = { ...size, x: ends(points.map((p) => p.x)), y: ends(points.map((p) => p.y)) };
    const [across, upwards] = [terms.terms[i]!, terms.terms[j]!];
    const circles = points.map((p, k) => {
      const [cx, cy] = placed(frame, [p.x, p.y]);
      const circle = svg('circle', { cx, cy, r: 4, class: k === points.length - 1 ? 'best point' : 'looked point', 'data-x': p.x, 'data-y': p.y });
      circle.append(svg('title', {}, `design ${p.number}: ${quantity(p.x, across.unit, 4)}, ${quantity(p.y, upwards.unit, 4)}`));
      circle.addEventListener('click', () => this.actions.reinstate(search, p.number));
      return circle;
    });
    const label = `${upwards.name} against ${across.name} of ${points.length} designs that were the best of their time`;
    this.plot.replaceChildren(
      figure(
        frame,
        label,
        ...circles,
        note(4, 10, `${upwards.name} ${quantity(frame.y[1], upwards.unit)}`),
        note(4, size.height - 3, quantity(frame.x[0], across.unit)),
        note(size.width - 4, size.height - 3, `${across.name} ${quantity(frame.x[1], across.unit)}`, 'end'),
      ),
    );
  }
}
