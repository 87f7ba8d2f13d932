// Begin a search, stop it, go on, and keep what it found or not.
import { h } from '../dom';
import { counted, digits, quantity } from '../quantity';
import { atWork, type Search } from '../searches';
import type { Task } from '../searching';
import { details } from './details';
import { boundCurve, searchCurve } from './searchcurve';

export interface RunActions {
  start: (body: object) => void;
  select: (body: object) => void;
  pause: () => void;
  resume: (body: object) => void;
  accept: () => void;
  reject: () => void;
  minimize: (objective: string) => void;
}

const reductions = { mean: 'mean', maximum: 'greatest', percentile: '95 % are below', cvar: 'mean of the worst 5 %', p_norm: '8-norm' };

export class SearchRunPanel {
  readonly element: HTMLElement;
  private readonly objective = h('select', { id: 'objective', onchange: () => this.actions.minimize(this.objective.value) });
  private readonly evaluations = this.option('search-evaluations', 'Evaluations', 'by size');
  private readonly seconds = this.option('search-seconds', 'Seconds', 'no limit');
  private readonly starts = this.option('search-starts', 'Starts', 'by kind');
  private readonly seed = this.option('search-seed', 'Seed', '1');
  private readonly study = this.option('search-study', 'Study', 'not kept');
  private readonly buttons = {
    start: this.button('search-start', 'Search', 'Begin a search (Ctrl Enter)', () => this.start()),
    pause: this.button('search-pause', 'Pause', 'Stop, with the best so far', () => this.actions.pause()),
    resume: this.button('search-resume', 'Go on', 'Go on where it was', () => this.resume()),
    accept: this.button('search-accept', 'Keep', 'Keep the best: one step that can be undone', () => this.keep()),
    reject: this.button('search-reject', 'Take back', 'All variables as they were when it began', () => this.actions.reject()),
  };
  private readonly status = h('p', { className: 'search-status', id: 'search-status', role: 'status' });
  private readonly curve = h('div', { className: 'curve' });
  private task: Task | null = null;
  private now: Search | null = null;
  /** Keep it once it has stopped. */
  private keeping = false;

  constructor(private readonly actions: RunActions) {
    this.element = h(
      'section',
      { className: 'search-column', 'aria-label': 'Search' },
      h('div', { className: 'pair' }, h('label', { htmlFor: 'objective' }, 'Minimize'), this.objective),
      h('div', { className: 'actions', role: 'toolbar', 'aria-label': 'Search' }, ...Object.values(this.buttons)),
      this.status,
      this.curve,
      details('How', false, h('div', { className: 'search-options' }, ...[this.evaluations, this.seconds, this.starts, this.seed, this.study].map(([label]) => label))),
    );
  }

  private option(id: string, text: string, placeholder: string): [HTMLElement, HTMLInputElement] {
    const box = h('input', { type: 'text', id, placeholder, autocomplete: 'off', spellcheck: false });
    return [h('label', { htmlFor: id }, text, box), box];
  }

  private button(id: string, text: string, title: string, onclick: () => void): HTMLButtonElement {
    return h('button', { type: 'button', id, title, onclick }, text);
  }

  offer(task: Task): void {
    this.task = task;
    const { name } = task.objective;
    this.objective.replaceChildren(
      h('option', { value: '' }, name),
      ...Object.entries(reductions).map(([value, text]) => h('option', { value }, text)),
    );
    this.render();
  }

  /** @returns the options that are given, as numbers */
  private wishes(): Record<string, number | string> {
    const wishes: Record<string, number | string> = {};
    const numbers = { evaluations: this.evaluations, seconds: this.seconds, starts: this.starts, seed: this.seed };
    for (const [key, [, box]] of Object.entries(numbers)) if (box.value.trim() !== '') wishes[key] = Number(box.value);
    const study = this.study[1].value.trim();
    if (study !== '') wishes.study = study;
    return wishes;
  }

  start(): void {
    if (this.buttons.start.disabled) return;
    const { selection } = this.task!;
    if (selection) this.actions.select(this.wishes());
    else this.actions.start(this.wishes());
  }

  private resume(): void {
    const { evaluations, ...rest } = this.wishes();
    const more = this.now?.kind === 'search' ? evaluations ?? Math.max(this.now.of, 100) : undefined;
    this.actions.resume(more === undefined ? rest : { evaluations: more });
  }

  /** Stop and keep the best: once it stands still. */
  keep(): void {
    if (!atWork(this.now)) return this.actions.accept();
    this.keeping = true;
    this.actions.pause();
  }

  show(search: Search | null): void {
    this.now = search;
    if (this.keeping && search && !atWork(search)) {
      this.keeping = false;
      this.actions.accept();
    }
    this.render();
  }

  private render(): void {
    const { now, task, buttons } = this;
    const working = atWork(now);
    buttons.start.textContent = task?.selection ? 'Choose' : 'Search';
    buttons.start.disabled = working || !task || (task.variables.length === 0 && !task.selection);
    buttons.pause.disabled = !working;
    buttons.resume.disabled = !now || working || (now.kind !== 'search' && now.phase === 'ended');
    buttons.accept.disabled = !now || now.kind === 'front' || (now.kind === 'search' ? now.incumbents.length === 0 : working || !now.result);
    buttons.reject.disabled = now?.kind !== 'search';
    this.status.textContent = now ? words(now) : task?.selection ? `A choice by ${task.selection}.` : '';
    this.status.dataset.phase = now?.phase ?? '';
    this.status.dataset.mood = now?.phase === 'failed' ? 'bad' : '';
    const drawn = now?.kind === 'search' ? searchCurve(now) : now?.kind === 'selection' ? boundCurve(now) : null;
    this.curve.replaceChildren(...(drawn ? [drawn] : []));
  }
}

/** Where a search is, in a sentence. */
function words(search: Search): string {
  const { phase } = search;
  if (phase === 'failed') return search.message;
  if (phase === 'waiting') return 'Waits for its turn.';
  const how = { running: 'Searching', paused: 'Paused', ended: 'Ended' }[phase];
  if (search.kind === 'front') return `${how}: trade-off, ${search.done} of ${search.of} searches.`;
  if (search.kind === 'selection') {
    if (search.ready < 1) return `${how}: candidates asked what they see, ${digits(100 * search.ready, 2)} %.`;
    const last = search.curve[search.curve.length - 1];
    const chosen = search.result ? `, ${counted(search.result.chosen.length, 'candidate')}, at most ${digits(100 * search.result.gap, 2)} % from the best` : '';
    return last ? `${how}: ${quantity(last.value, search.unit)}, at best ${quantity(last.bound, search.unit)}${chosen}.` : `${how}.`;
  }
  const { objective, best, result, judged, evaluations, incumbents } = search;
  const none = incumbents.length > 0 ? 'from the design as it is now' : 'none keeps the constraints yet';
  const from = result && judged ? `${quantity(result.initial, objective.unit)} → ${quantity(result.best, objective.unit, 4)}` : quantity(best, objective.unit, 4);
  const why = phase === 'ended' && result ? `, ${result.stop}` : '';
  return `${how}: ${objective.name} ${best === null && !judged ? none : from} after ${counted(evaluations, 'evaluation')}${why}.`;
}
