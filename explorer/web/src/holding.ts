// What is chosen in the hand: moved and turned by the gizmo or by typing, with snapping.
import type { Place } from './gizmo';
import { TypedMove } from './hand';
import type { Layout } from './layout';
import type { Picture, Shown } from './picture';
import type { Rooming } from './rooming';

export interface HoldingSteps {
  /** Send a change of the design; of those that wait for one place the newest counts. */
  change: (place: string, verb: string, body: object) => void;
  undo: () => void;
}

export class Holding {
  private readonly typed: TypedMove;
  /** Turning: to the faces that devices snap to. */
  private readonly snapping = { on: false, turning: false };

  constructor(
    private readonly layout: Layout,
    private readonly picture: Picture,
    private readonly shown: Shown,
    private readonly rooming: Rooming,
    private readonly steps: HoldingSteps,
  ) {
    this.typed = new TypedMove({
      place: (change, gesture) => this.place(change, gesture),
      back: () => steps.undo(),
      say: (text) => layout.handSays(text),
    });
  }

  /** Whether something can be moved. */
  get held(): boolean {
    return this.picture.hasIcon(this.shown.selected) || this.shown.body !== null;
  }

  /** Nothing is typed any more. */
  end(): void {
    this.typed.end();
  }

  /** @returns whether the key was for it */
  take(event: KeyboardEvent): boolean {
    return this.rooming.take(event) || this.picture.gizmo.take(event, () => this.steps.undo()) || this.typed.take(event);
  }

  move(mode: 'translate' | 'rotate'): void {
    const { picture, shown } = this;
    picture.gizmo.use(mode);
    this.layout.gizmoMode(mode, this.held);
    const held = shown.body ? picture.heldBody : shown.description!.devices.find((d) => d.name === shown.selected);
    if (!shown.body || mode === 'translate') this.typed.begin(mode, held ?? null);
  }

  /** By the gizmo: a device sticks to faces where it snaps. */
  drag({ ray, ...change }: Parameters<Place>[0], gesture: string): void {
    const { on, turning } = this.snapping;
    const stick = on && change.p ? { stick: { turn: turning, ...(ray ? { ray } : {}) } } : {};
    this.place({ ...change, ...stick }, gesture);
  }

  place(change: { p?: number[]; q?: number[]; size?: number[]; stick?: object }, gesture: string): void {
    const { body, selected } = this.shown;
    const { stick, ...rest } = change;
    if (body) this.rooming.shape(rest, gesture);
    else if (selected) this.steps.change(`place ${selected}`, 'place', { device: selected, gesture, ...change });
  }

  snap(): void {
    this.set({ on: !this.snapping.on });
  }

  turnToFaces(): void {
    this.set({ on: true, turning: !this.snapping.turning });
  }

  private set(how: Partial<Holding['snapping']>): void {
    Object.assign(this.snapping, how);
    const { on, turning } = this.snapping;
    this.picture.gizmo.snap(on);
    this.picture.sticking = on;
    this.layout.snapping(on, on && turning);
  }
}
