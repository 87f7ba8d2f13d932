// Searches of the open design: what is asked, how they go on, and how the design follows.
import { newGesture } from './gesture';
import type { SearchActions, SearchPanel } from './panels/search';
import { atWork, SearchLine, Searches, type Search } from './searches';
import type { Description, Session } from './server';

/** What there is to search for: search_task() of the server. */
export interface Task {
  revision: number;
  variables: { path: string; unit: string; value: number | null; lower: number | null; upper: number | null; logarithmic: boolean; followers: number }[];
  objective: { name: string; unit: string };
  constraints: { name: string; limit: number | null; unit: string }[];
  selection: 'count' | 'budget' | 'cover' | null;
}

/** term_values() of the server: a row of values a design. */
export interface TermValues {
  terms: { name: string; unit: string }[];
  values: (number | null)[][];
}

export interface SearchSteps {
  /** Send a change of the design; of those that wait for one place the newest counts. */
  change: (place: string, verb: string, body: object) => void;
  failed: (error: unknown) => void;
}

export class Searching {
  readonly searches = new Searches();
  private readonly line = new SearchLine((news, whole) => this.heard(news, whole));
  private session: Session | null = null;
  private description: Description | null = null;
  private asked = -1;

  constructor(
    private readonly panel: SearchPanel,
    private readonly steps: SearchSteps,
  ) {}

  async open(session: Session): Promise<void> {
    this.session = session;
    this.asked = -1;
    this.searches.clear();
    const { searches } = await session.ask<{ searches: Search[] }>('searches');
    for (const search of searches) this.searches.take(search, true);
    this.panel.show(this.searches);
    this.line.open(session.name);
  }

  /** The design is another one. */
  describe(description: Description, selected: string | null): void {
    this.description = description;
    const { devices, types } = description;
    this.panel.choose(devices.find((d) => d.name === selected) ?? null, devices, types);
    if (!this.panel.open || this.asked === description.revision) return;
    this.asked = description.revision;
    void this.attempt(async (session) => this.panel.task(await session.ask<Task>('task')));
  }

  toggle(selected: string | null): void {
    this.panel.toggle();
    if (this.description && this.panel.open) this.describe(this.description, selected);
  }

  begin(): void {
    if (this.panel.open) this.panel.begin();
  }

  pauseOrResume(): void {
    const { now } = this.searches;
    if (now) this.do(atWork(now) ? 'search_pause' : 'search_resume');
  }

  /** Begin, stop, go on, lock: what comes of it is told by the line, too. */
  do(verb: string, body: object = {}): void {
    void this.attempt(async (session) => {
      const news = await session.ask<Search>(verb, body);
      if (session === this.session) this.heard(news, true);
    });
  }

  /** Changes of the design: none takes another's place. */
  change(verb: string, body: object = {}): void {
    this.steps.change(newGesture(), verb, body);
  }

  /** What each term of the objective is worth, of designs that were the best of their time. */
  async terms(search: number, incumbents: number[]): Promise<TermValues | null> {
    let values: TermValues | null = null;
    await this.attempt(async (session) => {
      values = await session.ask<TermValues>('terms', { search, incumbents });
    });
    return values;
  }

  private async attempt(what: (session: Session) => Promise<void>): Promise<void> {
    try {
      if (this.session) await what(this.session);
    } catch (error) {
      this.steps.failed(error);
    }
  }

  private heard(news: Search, whole: boolean): void {
    const before = this.searches.take(news, whole);
    this.panel.show(this.searches);
    if (news.kind !== 'search') return;
    const found = news.incumbents.length > (before?.kind === 'search' ? before.incumbents.length : 0);
    // The layout moves as it improves; at last, what is best on all samples counts.
    if (atWork(news) ? found : atWork(before) && news.judged) this.steps.change('search follow', 'search_follow', {});
  }
}

/** What the panel's buttons do. */
export const searchActions = (searching: () => Searching, form: SearchActions['form']): SearchActions => ({
  form,
  terms: (search, incumbents) => searching().terms(search, incumbents),
  vary: (body) => searching().change('vary', body),
  fix: (path) => searching().change('fix', { path }),
  lock: (path, locked) => searching().do('search_lock', { path, locked }),
  start: (body) => searching().do('search_start', body),
  select: (body) => searching().do('select_start', body),
  front: (body) => searching().do('front_start', body),
  pause: () => searching().do('search_pause'),
  resume: (body) => searching().do('search_resume', body),
  accept: () => searching().change('search_accept'),
  reject: () => searching().change('search_reject'),
  minimize: (kind) => {
    if (kind) searching().change('change', { set: [{ path: 'objective', value: `{minimize: ${kind}}` }], gesture: '' });
  },
  reinstate: (search, which) => searching().change('search_reinstate', { search, ...which }),
});
