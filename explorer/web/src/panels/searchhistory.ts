// What was searched for, with all designs that were the best of their time.
import { h } from '../dom';
import { counted, quantity } from '../quantity';
import type { Search, Searches, ValueSearch } from '../searches';

const most = 40;

export class SearchHistory {
  readonly element = h('ol', { className: 'history', 'aria-label': 'Searches', reversed: true });

  /** @param reinstate an incumbent of a search, by number */
  constructor(private readonly reinstate: (search: number, incumbent: number) => void) {}

  show(searches: Searches): void {
    const all = [...searches.all.values()].reverse();
    const focused = this.element.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset.incumbent : undefined;
    this.element.replaceChildren(...all.map((search) => h('li', { value: search.search }, ...this.words(search))));
    if (focused) this.element.querySelector<HTMLElement>(`[data-incumbent="${focused}"]`)?.focus();
  }

  private words(search: Search): (HTMLElement | string)[] {
    if (search.kind === 'selection') {
      const { result, unit } = search;
      return [result ? `chose ${counted(result.chosen.length, 'candidate')}: ${quantity(result.value, unit)}` : 'a choice'];
    }
    if (search.kind === 'front') return [`trade-off${search.front ? ` against ${search.front.limit.constraint}` : ''}`];
    return [`${search.objective.name}, ${counted(search.evaluations, 'evaluation')}${search.study ? `, in ${search.study}` : ''}`, this.incumbents(search)];
  }

  private incumbents({ search, incumbents, objective }: ValueSearch): HTMLElement {
    return h(
      'div',
      { className: 'incumbents' },
      ...[...incumbents]
        .reverse()
        .slice(0, most)
        .map((one) =>
          h(
            'button',
            {
              type: 'button',
              title: `Take this design again: after ${counted(one.evaluation, 'evaluation')}, round ${one.round}`,
              'data-incumbent': `${search} ${one.number}`,
              onclick: () => this.reinstate(search, one.number),
            },
            quantity(one.objective, objective.unit, 4),
          ),
        ),
    );
  }
}
