// What the server tells of searches, as they go on.
import type { Metric } from './server';

export type Phase = 'waiting' | 'running' | 'paused' | 'ended' | 'failed';

/** What a round searches: other variables after a lock. */
export interface Round {
  round: number;
  variables: string[];
  lower: number[];
  upper: number[];
  logarithmic: boolean[];
}

/** A design that was looked at. */
export interface Looked {
  evaluation: number;
  round: number;
  objective: number | null;
  /** By softened edges: not to be compared with hard ones. */
  soft: boolean;
  feasible: boolean;
  values: (number | null)[];
}

export interface Incumbent extends Looked {
  number: number;
}

interface Common {
  search: number;
  phase: Phase;
  message: string;
}

export interface ValueSearch extends Common {
  kind: 'search';
  study: string | null;
  objective: Pick<Metric, 'name' | 'unit'>;
  locked: string[];
  /** Evaluations of the round, at most. */
  of: number;
  best: number | null;
  /** It stands still, and what was found is judged on all samples. */
  judged: boolean;
  seconds: number;
  result: { initial: number | null; best: number | null; stop: string; algorithm: string; messages: string[] } | null;
  rounds: Round[];
  evaluations: number;
  incumbents: Incumbent[];
  designs: Looked[];
}

export interface Selection extends Common {
  kind: 'selection';
  study: string | null;
  unit: string;
  /** The part of what must be known first that is. */
  ready: number;
  curve: { seconds: number; value: number | null; bound: number | null; nodes: number }[];
  result: { chosen: string[]; value: number; lower_bound: number; gap: number; stop: string } | null;
}

export interface Front extends Common {
  kind: 'front';
  done: number;
  of: number;
  front: {
    objective: Pick<Metric, 'name' | 'unit'>;
    limit: { constraint: string; unit: string };
    points: { limit: number; used: number; objective: number | null; kept: boolean; dominated: boolean }[];
  } | null;
}

export type Search = ValueSearch | Selection | Front;

export const atWork = (search: Search | null) => search?.phase === 'running' || search?.phase === 'waiting';

/** Designs that are kept of a search, beside its incumbents. */
const mostDesigns = 400;

/** Searches by their number, the newest last. */
export class Searches {
  readonly all = new Map<number, Search>();

  get now(): Search | null {
    return [...this.all.values()].pop() ?? null;
  }

  clear(): void {
    this.all.clear();
  }

  /** @param whole all that there is to tell; else what is new
   *  @returns the search, with how it was before */
  take(news: Search, whole: boolean): Search | null {
    const before = this.all.get(news.search) ?? null;
    if (!whole && before?.kind === 'search' && news.kind === 'search') {
      news.rounds = [...before.rounds, ...news.rounds];
      news.incumbents = [...before.incumbents, ...news.incumbents];
      news.designs = [...before.designs, ...news.designs];
      while (news.designs.length > mostDesigns) news.designs = news.designs.filter((_, k) => k % 2 === 1);
    }
    this.all.set(news.search, news);
    return before;
  }
}

/** Listens to the server until it is closed; a line that breaks is opened again. */
export class SearchLine {
  private socket: WebSocket | null = null;
  private again = 0;

  /** @param hear whole: all that there is to tell */
  constructor(private readonly hear: (news: Search, whole: boolean) => void) {}

  open(session: string): void {
    this.close();
    const socket = new WebSocket(`ws://${location.host}/api/watch?session=${encodeURIComponent(session)}`);
    const heard = new Set<number>();
    socket.onmessage = ({ data }) => {
      const news: Search = JSON.parse(data as string);
      this.hear(news, !heard.has(news.search));
      heard.add(news.search);
    };
    socket.onclose = () => {
      if (this.socket === socket) this.again = window.setTimeout(() => this.open(session), 2000);
    };
    this.socket = socket;
  }

  close(): void {
    clearTimeout(this.again);
    const { socket } = this;
    this.socket = null;
    socket?.close();
  }
}
