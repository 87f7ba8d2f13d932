// Changes on their way to the server, and what is worked out after them.
//
// Changes go one after the other; of those that wait for one place only the newest counts.
// Each is followed by a coarse field, which the next one waits for, so that the picture keeps up
// with the hand; what takes longer waits until the hand rests, and is given up as soon as
// something changes.
import { Refusal } from './server';

export interface Steps {
  /** Send a change and take over what came of it. */
  change: (verb: string, body: object) => Promise<void>;
  /** Draw the field, coarse where it is large. */
  draw: (signal: AbortSignal) => Promise<void>;
  /** What can wait. */
  rest: (signal: AbortSignal) => Promise<void>;
  failed: (error: unknown) => void;
  busy: (busy: boolean) => void;
}

/** After how long a hand that has moved something rests, milliseconds. */
const stillness = 150;

/** @throws AbortError it moved before */
const rested = (signal: AbortSignal) =>
  new Promise<void>((still, moved) => {
    signal.throwIfAborted();
    const waiting = setTimeout(still, stillness);
    signal.addEventListener('abort', () => {
      clearTimeout(waiting);
      moved(signal.reason);
    });
  });

export class Work {
  private readonly waiting = new Map<string, { verb: string; body: object }>();
  private running = false;
  private abort = new AbortController(); // of what can wait
  private gone = new AbortController(); // of all that is of another design
  private stale = false;

  constructor(private readonly steps: Steps) {}

  /** @param place what a newer change takes the place of an older one by */
  change(place: string, verb: string, body: object): void {
    const before = this.waiting.get(place);
    this.waiting.delete(place);
    this.waiting.set(place, { verb, body: { ...before?.body, ...body } });
    this.start();
  }

  /** Nothing that waits or is worked out is of use any more. */
  forget(): void {
    this.waiting.clear();
    this.abort.abort();
    this.gone.abort();
    this.gone = new AbortController();
  }

  /** Draw anew. */
  refresh(): void {
    this.stale = true;
    this.start();
  }

  private start(): void {
    this.abort.abort();
    if (!this.running) void this.run();
  }

  private async run(): Promise<void> {
    this.running = true;
    this.steps.busy(true);
    while (this.waiting.size > 0 || this.stale) {
      const next = this.waiting.entries().next().value;
      try {
        if (next) {
          this.waiting.delete(next[0]);
          await this.steps.change(next[1].verb, next[1].body);
        }
        this.stale = false;
        this.abort = new AbortController();
        const { signal } = this.abort;
        await this.steps.draw(this.gone.signal);
        if (next && 'gesture' in next[1].body && next[1].body.gesture !== '') await rested(signal);
        if (this.waiting.size === 0 && !this.stale) await this.steps.rest(signal);
      } catch (error) {
        const overtaken =
          (error instanceof DOMException && error.name === 'AbortError') ||
          (error instanceof Refusal && error.status === 409);
        if (!overtaken) this.steps.failed(error);
      }
    }
    this.running = false;
    this.steps.busy(false);
  }
}
