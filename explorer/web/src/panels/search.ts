// The search: what may change, how it goes on, and what was found.
import { h, iconButton } from '../dom';
import type { Box, Device, DeviceType, FormField } from '../server';
import type { Searches } from '../searches';
import type { Task } from '../searching';
import { parallelCoordinates } from './parallel';
import { SearchFront, type FrontActions } from './searchfront';
import { SearchHistory } from './searchhistory';
import { SearchRunPanel, type RunActions } from './searchrun';
import { SearchTerms, type TermActions } from './searchterms';
import { SceneForm, type FormActions } from './sceneform';
import { SearchVariables, type VariableActions } from './searchvariables';

export interface SearchActions extends VariableActions, RunActions {
  form: FormActions;
  terms: TermActions['terms'];
  front: FrontActions['start'];
  reinstate: (search: number, which: { incumbent: number } | { point: number }) => void;
}

export class SearchPanel {
  readonly element: HTMLElement;
  private readonly variables: SearchVariables;
  private readonly run: SearchRunPanel;
  private readonly history: SearchHistory;
  private readonly front: SearchFront;
  private readonly aims: SceneForm;
  private readonly terms: SearchTerms;
  private readonly designs = h('div', { className: 'designs' });
  private offered: Task | null = null;
  private searches: Searches | null = null;
  /** Before a search is begun: what it shall not change. */
  private readonly locked = new Set<string>();

  constructor(private readonly actions: SearchActions) {
    this.variables = new SearchVariables({ ...actions, lock: (path, on) => this.lock(path, on) });
    this.run = new SearchRunPanel({ ...actions, start: (body) => actions.start({ ...body, locked: this.lockedNow() }) });
    this.history = new SearchHistory((search, incumbent) => actions.reinstate(search, { incumbent }));
    this.front = new SearchFront({ start: actions.front, reinstate: (search, point) => actions.reinstate(search, { point }) });
    this.aims = new SceneForm(actions.form);
    this.terms = new SearchTerms({ terms: actions.terms, reinstate: (search, incumbent) => actions.reinstate(search, { incumbent }) });
    this.variables.element.append(this.aims.element);
    this.element = h(
      'section',
      { className: 'search', id: 'search', hidden: true, 'aria-label': 'Search for a better design' },
      this.variables.element,
      this.run.element,
      h(
        'section',
        { className: 'search-column', 'aria-label': 'What was found', tabIndex: 0 },
        h('h3', {}, 'What was found'),
        this.designs,
        this.history.element,
        this.front.element,
        this.terms.element,
      ),
      iconButton('close', 'Close the search', () => this.toggle(), 'icon close-search'),
    );
  }

  get open(): boolean {
    return !this.element.hidden;
  }

  toggle(): void {
    this.element.hidden = !this.element.hidden;
    document.getElementById('search-open')?.setAttribute('aria-pressed', String(this.open));
  }

  /** The devices that there are, and which of them is chosen. */
  choose(device: Device | null, all: Device[], types: Record<string, DeviceType>): void {
    this.variables.offer(device, device ? types[device.type] : undefined, all, types);
  }

  task(task: Task): void {
    this.offered = task;
    this.run.offer(task);
    this.front.offer(task);
    if (this.searches) this.show(this.searches);
    else this.variables.show(task, [...this.locked]);
  }

  /** What is made small, and what is kept. */
  form(sections: FormField[], room: Box): void {
    const terms = sections.find((s) => s.path === 'objective')?.members?.find((m) => m.name === 'terms');
    this.terms.several((terms?.members?.length ?? 0) > 1);
    this.aims.show(sections.filter((s) => s.path === 'objective' || s.path === 'constraints'), room);
  }

  begin(): void {
    this.run.start();
  }

  keep(): void {
    this.run.keep();
  }

  private lockedNow(): string[] {
    const now = this.searches?.now;
    return now?.kind === 'search' ? now.locked : [...this.locked];
  }

  show(searches: Searches): void {
    this.searches = searches;
    const { now } = searches;
    this.run.show(now);
    if (this.offered) this.variables.show(this.offered, this.lockedNow());
    const units = new Map(this.offered?.variables.map((v) => [v.path, v.unit]));
    const drawn = now?.kind === 'search' ? parallelCoordinates(now, (path) => units.get(path) ?? '1') : null;
    this.designs.replaceChildren(...(drawn ? [drawn] : []));
    this.history.show(searches);
    this.terms.show(now?.kind === 'search' ? now : null);
    const front = [...searches.all.values()].filter((s) => s.kind === 'front').pop();
    this.front.show(front?.kind === 'front' ? front : null);
  }

  /** Of the search at work, else of the next one. */
  private lock(path: string, on: boolean): void {
    if (this.searches?.now?.kind === 'search') return this.actions.lock(path, on);
    for (const { path: one } of this.offered?.variables ?? []) {
      if (one !== path && !one.startsWith(`${path}.`)) continue;
      if (on) this.locked.add(one);
      else this.locked.delete(one);
    }
    if (this.offered) this.variables.show(this.offered, [...this.locked]);
  }
}
