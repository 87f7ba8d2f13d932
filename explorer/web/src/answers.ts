// What is worked out of a design for its picture: coarse while a hand moves, then all of it.
import { isScattered, unpack, type Field } from './field';
import { isNothing, noShapes, textOf, unpackShapes, type ShapesAsked } from './shapes';
import { coloured, type Shown } from './picture';
import { Refusal, type BlindRegions, type Lattice, type PointReport, type Session, type Vec3, type Worth } from './server';
import { sectionOf, type Viewing } from './viewing';

/** Samples that are worked out while a hand moves; the rest follows. */
const coarseSamples = 20_000;
const sectionSamples = { coarse: 1500, full: 10_000 };
const latticePoints = 150;

export interface Heard {
  drawn: () => void;
  answered: () => void;
  uncertain: () => void;
  valued: (worth: Worth) => void;
  /** What shapes are to be seen now. */
  shapes: () => ShapesAsked;
  refused: (error: Refusal) => void;
}

export class Answers {
  constructor(
    private readonly shown: Shown,
    private readonly viewing: Viewing,
    private readonly heard: Heard,
  ) {}

  /** The picture, coarse where the field is large. */
  async draw(session: Session, signal: AbortSignal): Promise<void> {
    await this.fields(session, coarseSamples, sectionSamples.coarse, signal);
    this.heard.drawn();
  }

  /** What can wait. */
  async rest(session: Session, signal: AbortSignal): Promise<void> {
    const { shown, viewing } = this;
    if (shown.field!.level === 'coarse' || this.sectionsAsked().length > 0) {
      await this.fields(session, 0, sectionSamples.full, signal);
      this.heard.drawn();
    }
    if (this.pinned && viewing.compare !== 'difference') {
      shown.difference = await this.field(session, 'difference', { most: 0 }, signal);
      this.heard.drawn();
    }
    if (shown.asked) await this.point(session, shown.asked, signal);
    shown.lattice = viewing.lattice ? await session.ask<Lattice>('lattice', { most: latticePoints }, signal) : null;
    shown.blind = viewing.blind ? await session.ask<BlindRegions>('blind', {}, signal) : null;
    if (viewing.lattice || viewing.blind) this.heard.uncertain();
    this.heard.valued(await session.ask<Worth>('worth', {}, signal));
  }

  /** What is shown now needs more than is known. */
  get lacking(): boolean {
    const { shown, viewing } = this;
    return (
      (viewing.lattice && !shown.lattice) ||
      (viewing.blind && !shown.blind) ||
      (this.pinned && ((viewing.compare === 'difference' && !shown.difference) || (viewing.compare === 'beside' && !shown.pinned))) ||
      (shown.field !== null && JSON.stringify(this.throughAsked(shown.field)) !== this.throughKnown) ||
      viewing.sensitivity !== (shown.slopes?.summary.sensitivity?.path ?? '') ||
      JSON.stringify([this.sectionsAsked(), this.pinned && viewing.compare === 'difference' ? { of: 'difference' } : {}]) !== this.sectionsKnown
    );
  }
  private sectionsKnown = '[[],{}]';
  private throughKnown = 'null';

  private get pinned(): boolean {
    return this.shown.description!.pinned !== null;
  }

  private sectionsAsked() {
    const { box } = this.shown.description!;
    return this.viewing.slants.flatMap((slant) => sectionOf(slant, box) ?? []);
  }

  /** What a surface goes through, and how; null: there is to be none. */
  private throughAsked(field: Field) {
    const { sensitivity, through } = this.viewing;
    if (through.method === 'none' || !field.parts.some(isScattered)) return null;
    return { ...through, of: coloured(this.viewing, this.shown), path: sensitivity };
  }

  private async field(session: Session, verb: string, more: object, signal: AbortSignal): Promise<Field> {
    return unpack(await session.bytes(verb, more, signal));
  }

  private async fields(session: Session, most: number, ofSection: number, signal: AbortSignal): Promise<void> {
    const { shown, viewing } = this;
    const field = await this.field(session, 'field', { most }, signal);
    const sections = this.sectionsAsked();
    const differing = this.pinned && viewing.compare === 'difference';
    const of = differing ? { of: 'difference' } : {};
    const cuts = sections.length > 0 ? await this.field(session, 'sections', { sections, most: ofSection, ...of }, signal) : null;
    await this.slopes(session, most, signal);
    if (differing) shown.difference = await this.field(session, 'difference', { most }, signal);
    if (this.pinned && viewing.compare === 'beside') await this.baseline(session, signal);
    const asked = this.throughAsked(field);
    const surface = asked && (await this.through(session, { ...asked, most }, signal));
    [shown.field, shown.sections, this.sectionsKnown] = [field, cuts, JSON.stringify([sections, of])];
    [shown.through, this.throughKnown] = [surface && { ...surface, of: asked!.of }, JSON.stringify(surface && asked)];
    await this.shape(session, signal);
  }

  /** Where samples span no surface, none; the field is drawn all the same. */
  private async through(session: Session, asked: object, signal: AbortSignal): Promise<Field | null> {
    try {
      return await this.field(session, 'through', asked, signal);
    } catch (error) {
      if (!(error instanceof Refusal) || error.status !== 422) throw error;
      this.viewing.through.method = 'none';
      this.heard.refused(error);
      return null;
    }
  }

  private async shape(session: Session, signal: AbortSignal): Promise<void> {
    const asked = this.heard.shapes();
    this.shown.shapes = isNothing(asked) ? noShapes(asked) : unpackShapes(await session.bytes('shapes', asked, signal), asked);
  }

  private reshaping = new AbortController();

  /** Shapes of the field that is there, where others are to be seen: beside all else, so that they
   * follow a level while it is dragged. */
  async reshape(session: Session): Promise<void> {
    if (textOf(this.heard.shapes()) === (this.shown.shapes?.asked ?? '')) return;
    this.reshaping.abort();
    this.reshaping = new AbortController();
    try {
      await this.shape(session, this.reshaping.signal);
      this.heard.drawn();
    } catch (error) {
      const overtaken = this.reshaping.signal.aborted || (error instanceof DOMException && error.name === 'AbortError') || (error instanceof Refusal && error.status === 409);
      if (!overtaken) throw error;
    }
  }

  /** Of a number that there isn't, none. */
  private async slopes(session: Session, most: number, signal: AbortSignal): Promise<void> {
    const { shown, viewing } = this;
    const path = viewing.sensitivity;
    if (!path) return void (shown.slopes = null);
    try {
      shown.slopes = await this.field(session, 'sensitivity', { path, most }, signal);
    } catch (error) {
      if (error instanceof Refusal && error.status === 422) [viewing.sensitivity, shown.slopes] = ['', null];
      throw error;
    }
  }

  /** What is pinned stays: it is asked once. */
  private async baseline(session: Session, signal: AbortSignal): Promise<void> {
    if (this.shown.pinned) return;
    const description = await session.ask<NonNullable<Shown['pinned']>['description']>('pinned', {}, signal);
    this.shown.pinned = { description, field: await this.field(session, 'field', { most: 0, of: 'pinned' }, signal) };
  }

  private async point(session: Session, at: Vec3, signal: AbortSignal): Promise<void> {
    this.shown.report = await session.ask<PointReport>('point', { at }, signal);
    this.heard.answered();
  }
}
