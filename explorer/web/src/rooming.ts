// The room in the hand: its form, the body that is chosen, and boxes that are drawn.
import { newGesture } from './gesture';
import type { Painted, RoomPanel } from './panels/room';
import type { SearchPanel } from './panels/search';
import type { Picture, Shown } from './picture';
import type { Session, FormAnswer } from './server';
import { Painter } from './view/painter';
import type { Viewing } from './viewing';

export interface RoomSteps {
  /** Send a change of the design; of those that wait for one place the newest counts. */
  change: (place: string, verb: string, body: object) => void;
  failed: (error: unknown) => void;
  say: (text: string) => void;
  /** Something else is chosen. */
  chosen: () => void;
}

export class Rooming {
  private readonly painter: Painter;
  private session: Session | null = null;
  private asked = -1;
  /** Bodies and regions that there were. */
  private paths: string[] = [];

  constructor(
    private readonly panel: RoomPanel,
    private readonly search: SearchPanel,
    picture: Picture,
    private readonly shown: Shown,
    private readonly steps: RoomSteps,
  ) {
    this.painter = new Painter(picture.stage);
  }

  open(session: Session): void {
    this.session = session;
    this.asked = -1;
    this.paths = this.pathsNow();
    this.painter.cancel();
  }

  /** The design is another one. */
  describe(): void {
    const { description } = this.shown;
    this.follow();
    if (!description || (!this.panel.open && !this.search.open) || this.asked === description.revision) return;
    this.asked = description.revision;
    void this.ask();
  }

  /** One more is chosen; one that has another name stays so. */
  private follow(): void {
    const before = this.paths;
    const now = (this.paths = this.pathsNow());
    const made = now.filter((path) => !before.includes(path));
    const { body } = this.shown;
    const gone = body !== null && !now.includes(body);
    if (gone) this.shown.body = null;
    const more = now.length === before.length + 1 || (gone && now.length === before.length);
    if (more && made.length === 1) this.choose(made[0]!);
    else if (gone) this.steps.chosen();
  }

  /** Those that a hand can change, in the order of the scene. */
  private pathsNow(): string[] {
    const { around } = this.shown;
    return [...around.occluders, ...around.regions].map((b) => b.path).filter(Boolean);
  }

  private async ask(): Promise<void> {
    const { session } = this;
    try {
      const { sections } = await session!.ask<FormAnswer>('form');
      if (session !== this.session) return;
      const { room } = this.shown.description!;
      this.panel.show(sections, room);
      this.search.form(sections, room);
      if (this.shown.body) this.panel.reveal(this.shown.body);
    } catch (error) {
      this.steps.failed(error);
    }
  }

  toggle(): void {
    this.panel.element.hidden = !this.panel.element.hidden;
    if (this.panel.open) {
      this.describe();
      this.panel.element.focus();
    } else this.choose(null);
  }

  /** A part of the form was opened: one that is a body is chosen. */
  opened(path: string): void {
    if (this.pathsNow().includes(path)) this.choose(path);
  }

  /** @param body "occluders.table" */
  choose(body: string | null): void {
    if (body === this.shown.body) return;
    this.shown.body = body;
    if (body) {
      this.shown.selected = null;
      this.panel.element.hidden = false;
      this.panel.reveal(body);
    }
    this.steps.chosen();
  }

  /** @param step from the chosen one, in the order of the scene */
  next(step: number): void {
    const paths = this.pathsNow();
    const at = paths.indexOf(this.shown.body ?? '');
    if (paths.length > 0) this.choose(paths[at < 0 ? 0 : (at + step + paths.length) % paths.length]!);
  }

  shape(change: { p?: number[]; size?: number[] }, gesture: string): void {
    const path = this.shown.body!;
    this.steps.change(`shape ${path}`, 'shape', { path, gesture, ...change });
  }

  /** Draw a box: on the slice across z where there is one, else on the floor. */
  paint(what: Painted, viewing: Viewing, colour: string): void {
    const { box } = this.shown.description!;
    const z = viewing.slices[2] && viewing.at[2] > box.min[2] ? viewing.at[2] : box.min[2];
    this.steps.say(`Drag a rectangle at z = ${Number(z.toFixed(3))} m; Esc gives it up`);
    this.painter.start(z, colour, (drawn) => {
      this.steps.say('');
      if (drawn) this.steps.change(newGesture(), 'paint', { what, ...drawn });
    });
  }

  /** @returns whether the key was for it */
  take({ key }: KeyboardEvent): boolean {
    if (!this.painter.at || key !== 'Escape') return false;
    this.painter.cancel();
    return true;
  }
}

/** What the fields of a form do. */
export const formActions = (rooming: () => Rooming, change: RoomSteps['change']) => ({
  edit: (set: { path: string; value: string }[], gesture: string) => change(`edit ${set.map((s) => s.path).join()}${gesture ? '' : newGesture()}`, 'edit', { set, gesture }),
  copyPart: (path: string) => change(newGesture(), 'copy_part', { path }),
  renamePart: (path: string, name: string) => change(newGesture(), 'rename_part', { path, name }),
  open: (path: string) => rooming().opened(path),
});
