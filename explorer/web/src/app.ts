// The explorer: what is open, what is chosen, and how a change reaches the picture.
import { unpack, type Field } from './field';
import { newGesture } from './gesture';
import { Gizmo } from './gizmo';
import { Layout } from './layout';
import { counted, quantity } from './quantity';
import { Scale } from './scale';
import {
  listScenes,
  Session,
  type Around,
  type Description,
  type PointReport,
  type Vec3,
  type Worth,
} from './server';
import { applyTheme, currentTheme, type Theme } from './theme';
import { FieldView } from './view/fieldview';
import { Icons } from './view/icons';
import { Probe } from './view/probe';
import { Room } from './view/room';
import { Stage } from './view/stage';
import { Work } from './work';
import { middle, type Viewing } from './panels/viewing';

/** Samples that are worked out while a hand moves; the rest follows. */
const coarseSamples = 20_000;
const sessionKey = 'delos-session';

/** The picture in one sentence. */
function words({ summary }: Field): string {
  const { metric, min, max, samples, finite } = summary;
  const from =
    min && max
      ? `${metric.name} from ${quantity(min.value, metric.unit)} to ${quantity(max.value, metric.unit)}`
      : `${metric.name} is finite nowhere`;
  return `The room: ${from}; ${samples - finite} of ${counted(samples, 'sample')} blind`;
}

export class App {
  private readonly layout: Layout;
  private readonly stage: Stage;
  private readonly room = new Room();
  private readonly fieldView = new FieldView();
  private readonly icons = new Icons();
  private readonly probe = new Probe();
  private readonly gizmo: Gizmo;
  private readonly work: Work;
  private theme: Theme = currentTheme();
  private colours = applyTheme(this.theme);
  private readonly viewing: Viewing = {
    axis: 2,
    at: [0, 0, 0],
    surface: false,
    level: 0.35,
    logarithmic: false,
    frusta: true,
    names: true,
  };

  private session: Session | null = null;
  private description: Description | null = null;
  private around: Around = { occluders: [], beacons: [] };
  private field: Field | null = null;
  private selected: string | null = null;
  private asked: Vec3 | null = null;
  private report: PointReport | null = null;
  private enlarged = 0;

  constructor(root: HTMLElement) {
    this.layout = new Layout(root, this.viewing, {
      open: (id) => void this.open(id),
      chooseScene: () => void this.chooseScene(),
      select: (name) => this.select(name),
      change: (set, gesture) =>
        this.work.change(set.map((s) => s.path).join(), 'change', { set, gesture }),
      place: (change, gesture) => this.place(change, gesture),
      undo: () => this.step('undo'),
      redo: () => this.step('redo'),
      save: () => void this.save(),
      toggleTheme: () => this.toggleTheme(),
      viewed: () => {
        this.render();
        this.described();
      },
      ask: (at) => this.ask(at),
      clear: () => this.ask(null),
      gizmo: (mode) => this.useGizmo(mode),
      look: (from) => this.stage.look(from),
    });
    this.stage = new Stage(this.layout.viewport);
    this.stage.scene.add(this.room.group, this.fieldView.group, this.icons.group, this.probe.group);
    this.stage.background(this.colours.background);
    this.gizmo = new Gizmo(
      this.stage,
      (change, gesture) => this.place(change, gesture),
      () => this.described(),
    );
    this.work = new Work({
      change: async (verb, body) => {
        const { session } = this;
        const description = await session!.ask<Description>(verb, body);
        if (session === this.session) this.take(description);
      },
      draw: (signal) => this.draw(signal, coarseSamples),
      rest: (signal) => this.rest(signal),
      failed: (error) => this.failed(error),
      busy: (busy) => this.layout.busy(busy),
    });
    this.listen();
  }

  async start(): Promise<void> {
    const kept = sessionStorage.getItem(sessionKey);
    if (kept) {
      try {
        return this.opened(...(await Session.resume(kept)));
      } catch {
        sessionStorage.removeItem(sessionKey); // of a server that has ended
      }
    }
    const { first } = await listScenes();
    if (first) await this.open(first);
    else await this.chooseScene();
  }

  private async chooseScene(): Promise<void> {
    try {
      this.layout.start.show(await listScenes());
    } catch (error) {
      this.failed(error);
    }
  }

  private async open(id: string): Promise<void> {
    try {
      await this.opened(...(await Session.open(id)));
    } catch (error) {
      this.failed(error);
    }
  }

  private async opened(session: Session, description: Description): Promise<void> {
    this.work.forget();
    this.session = session;
    sessionStorage.setItem(sessionKey, session.name);
    this.description = description;
    this.field = null;
    this.selected = null;
    this.ask(null);
    this.viewing.axis = 2;
    this.viewing.at = middle(description.box);
    this.viewing.surface = false;
    this.around = await session.ask<Around>('around');
    this.drawRoom();
    this.stage.look('corner', description.room);
    this.described();
    this.work.refresh();
  }

  /** A description that the server gave after a change. */
  private take(description: Description): void {
    this.description = description;
    this.layout.devices.stale();
    this.described();
  }

  private described(): void {
    const { description, selected } = this;
    if (!description) return;
    this.layout.describe(description, selected);
    if (this.gizmo.dragging) {
      this.icons.move(description, selected);
    } else {
      this.icons.show(
        description,
        { selected, frusta: this.viewing.frusta, labels: this.viewing.names },
        this.colours,
      );
      const device = description.devices.find((d) => d.name === selected);
      this.gizmo.hold(device?.surface ? null : this.icons.find(selected));
    }
    this.layout.gizmoMode(this.gizmo.mode, this.icons.find(selected) !== null);
    this.stage.draw();
  }

  private async draw(signal: AbortSignal, most: number): Promise<void> {
    this.field = unpack(await this.session!.bytes('field', { most }, signal));
    this.render();
  }

  private async rest(signal: AbortSignal): Promise<void> {
    if (this.field!.level === 'coarse') await this.draw(signal, 0);
    if (this.asked) await this.answer(this.asked, signal);
    const worth = await this.session!.ask<Worth>('worth', {}, signal);
    this.layout.devices.value(worth);
  }

  private async answer(at: Vec3, signal: AbortSignal): Promise<void> {
    this.report = await this.session!.ask<PointReport>('point', { at }, signal);
    this.showProbe();
  }

  private render(): void {
    const { field, viewing } = this;
    if (!field || !this.description) return;
    const { min, max } = field.summary;
    const scale =
      min && max
        ? new Scale(min.value, max.value, viewing.logarithmic && min.value > 0, field.largerIsBetter)
        : null;
    const grid = field.parts.some((part) => part.kind === 'grid');
    const level = viewing.surface && grid && scale ? scale.at(viewing.level) : null;
    this.fieldView.show(
      field,
      { axis: viewing.axis, at: viewing.at[viewing.axis] ?? 0, level },
      scale,
      this.colours.edge,
    );
    this.layout.field(field, scale, level);
    this.stage.describe(words(field));
    this.stage.draw();
  }

  private drawRoom(): void {
    const { box, room } = this.description!;
    const { colours } = this;
    this.room.show(box, room, this.around, colours);
    this.layout.floor(this.room.step);
    this.showProbe();
  }

  private select(name: string | null): void {
    this.selected = name;
    this.described();
  }

  private ask(at: Vec3 | null): void {
    this.asked = at;
    this.report = null;
    this.showProbe();
    if (at) this.work.refresh();
    else this.layout.report.clear();
  }

  private showProbe(): void {
    if (!this.asked || !this.description) {
      this.probe.clear();
    } else {
      const { min, max } = this.description.room;
      const size = Math.hypot(...max.map((x, k) => x - min[k]!));
      this.enlarged = this.probe.show(this.asked, this.report, size, this.colours.probe);
      if (this.report)
        this.layout.report.show(this.report, this.description.metric, this.enlarged);
    }
    this.stage.draw();
  }

  /** Each press is a step: none takes another's place. */
  private step(verb: 'undo' | 'redo'): void {
    if (this.session) this.work.change(newGesture(), verb, {});
  }

  private place(change: { p?: number[]; q?: number[] }, gesture: string): void {
    const device = this.selected;
    if (device) this.work.change(`place ${device}`, 'place', { device, gesture, ...change });
  }

  private useGizmo(mode: 'translate' | 'rotate'): void {
    this.gizmo.use(mode);
    this.layout.gizmoMode(mode, this.icons.find(this.selected) !== null);
  }

  private toggleTheme(): void {
    this.theme = this.theme === 'dark' ? 'light' : 'dark';
    localStorage.setItem('delos-theme', this.theme);
    this.colours = applyTheme(this.theme);
    this.stage.background(this.colours.background);
    if (!this.description) return;
    this.drawRoom();
    this.render();
    this.described();
  }

  private async save(): Promise<void> {
    try {
      const text = await this.session!.text();
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([text], { type: 'application/yaml' }));
      link.download = `${this.description!.name.replace(/[^\w-]+/g, '-').toLowerCase()}.yaml`;
      link.click();
      URL.revokeObjectURL(link.href);
      this.layout.say(`Saved as ${link.download}`, 'good');
    } catch (error) {
      this.failed(error);
    }
  }

  /** What was refused stays as it was: the panels show that again. */
  private failed(error: unknown): void {
    const lost = error instanceof TypeError;
    this.layout.say(
      lost ? 'The server has ended: start delos explore again.' : (error as Error).message,
      'bad',
    );
    this.described();
  }

  private listen(): void {
    let pressed: { x: number; y: number } | null = null;
    const { canvas } = this.stage;
    canvas.addEventListener('pointerdown', (event) => {
      pressed = this.gizmo.hovered || event.button !== 0 ? null : { x: event.clientX, y: event.clientY };
    });
    canvas.addEventListener('pointerup', (event) => {
      const still = pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < 4;
      pressed = null;
      if (!still || !this.description) return;
      const ray = this.stage.ray(event);
      const icon = ray.intersectObject(this.icons.group, true).find((hit) => 'isMesh' in hit.object && !this.seeThrough(hit.object));
      if (icon) return this.select(this.icons.nameOf(icon.object));
      const at = this.fieldView.pick(ray);
      if (at) this.ask(at);
    });
    this.layout.keys({
      translate: () => this.useGizmo('translate'),
      rotate: () => this.useGizmo('rotate'),
      escape: () => (this.selected ? this.select(null) : this.ask(null)),
      ready: () => this.session !== null,
    });
  }

  /** A frustum is no thing to click on. */
  private seeThrough(object: object): boolean {
    const { material } = object as { material?: { transparent?: boolean } };
    return material?.transparent === true;
  }
}
