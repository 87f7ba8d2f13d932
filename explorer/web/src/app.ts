// The explorer: what is open, what is chosen, and how a change reaches the picture.
import { Answers } from './answers';
import { listenForKeys } from './commands';
import { wordsOf } from './field';
import { newGesture } from './gesture';
import { Holding } from './holding';
import { commandsOf } from './keys';
import { Layout } from './layout';
import { nothingShown, Picture } from './picture';
import { listenForClicks } from './mouse';
import { download } from './saving';
import { listScenes, Session, type Around, type Description, type Palette, type Vec3 } from './server';
import { applyTheme, currentTheme, type Theme } from './theme';
import { Rooming, formActions } from './rooming';
import { searchActions, Searching } from './searching';
import { ViewCube } from './view/viewcube';
import type { ViewName } from './view/eye';
import { firstViewing, middle } from './viewing';
import { Work } from './work';

const sessionKey = 'delos-session';
/** How long a description waits for its field, milliseconds. */
const patience = 60;

export class App {
  private readonly layout: Layout;
  private readonly picture: Picture;
  private readonly work: Work;
  private readonly answers: Answers;
  private readonly holding: Holding;
  private readonly searching: Searching;
  private readonly rooming: Rooming;
  private readonly viewing = firstViewing();
  private readonly shown = nothingShown();
  private theme: Theme = currentTheme();
  private colours = applyTheme(this.theme);
  private session: Session | null = null;
  private waiting = 0;
  /** A device that was just made, to be chosen. */
  private awaited: Set<string> | null = null;

  constructor(root: HTMLElement) {
    const doings = {
      viewing: this.viewing,
      viewed: () => this.viewed(),
      look: (from: ViewName) => this.look(from),
      lookThrough: () => this.lookThrough(),
      orthographic: () => this.picture.stage.setOrthographic(!this.picture.stage.eye.orthographic),
      move: (mode: 'translate' | 'rotate') => this.holding.move(mode),
      letGo: () => this.letGo(),
      next: (step: number) => this.chooseNext(step),
      add: () => void this.askPalette(),
      copy: () => this.make('copy', { device: this.shown.selected, by: this.besideIt() }),
      array: () => this.layout.array.show(this.shown.description!, this.shown.selected!),
      mirror: (axis: 'x' | 'y') => this.make('mirror', { device: this.shown.selected, axis }),
      remove: () => this.work.change(newGesture(), 'remove', { device: this.shown.selected }),
      pin: (pinned: boolean) => this.pin(pinned),
      undo: () => this.step('undo'),
      redo: () => this.step('redo'),
      save: () => void this.save(),
      open: () => void this.chooseScene(),
      theme: () => this.toggleTheme(),
      snap: () => this.holding.snap(),
      turnToFaces: () => this.holding.turnToFaces(),
      room: () => this.rooming.toggle(),
      paint: () => this.rooming.paint(this.layout.room.chosen, this.viewing, this.colours.selected),
      nextBody: (step: number) => this.rooming.next(step),
      search: () => {
        this.searching.toggle(this.shown.selected);
        this.rooming.describe();
      },
      beginSearch: () => this.searching.begin(),
      pauseSearch: () => this.searching.pauseOrResume(),
      keepSearch: () => this.layout.search.keep(),
      rejectSearch: () => this.searching.change('search_reject'),
      slice: (axis: number) => this.layout.viewingPanel.slices.toggle(axis),
      slant: () => this.layout.viewingPanel.slices.addSlant(),
      commands: () => this.layout.palette.show(),
      help: () => this.layout.help.showModal(),
      hasScene: () => this.session !== null,
      hasDevice: () => this.shown.selected !== null,
      hasBody: () => this.shown.body !== null,
      hasPin: () => this.shown.description?.pinned != null,
    };
    const commands = commandsOf(doings);
    const form = formActions(() => this.rooming, (place, verb, body) => this.work.change(place, verb, body));
    this.layout = new Layout(
      root,
      this.viewing,
      {
        ...doings,
        open: (id) => void this.open(id),
        chooseScene: doings.open,
        select: (name) => this.select(name),
        change: (set, gesture) => this.work.change(set.map((s) => s.path).join(), 'change', { set, gesture }),
        place: (change, gesture) => this.holding.place(change, gesture),
        toggleTheme: doings.theme,
        ask: (at) => this.ask(at),
        clear: () => this.ask(null),
        gizmo: doings.move,
        askPalette: doings.add,
        makeArray: (array) => this.make('array', { device: this.shown.selected, ...array }),
        add: (type, preset) => this.make('add', { type, preset, ...(this.shown.asked ? { at: this.shown.asked } : {}) }),
        set: (setting) => this.work.change(setting.path, 'change', { set: [setting], gesture: '' }),
        searching: searchActions(() => this.searching, form),
        rooming: { ...form, paint: doings.paint, close: doings.room },
      },
      commands,
    );
    this.picture = new Picture(
      this.layout.viewport,
      this.viewing,
      (change, gesture) => this.holding.drag(change, gesture),
      () => this.described(),
    );
    this.picture.stage.background(this.colours.background);
    this.answers = new Answers(this.shown, this.viewing, {
      drawn: () => {
        this.described(false);
        this.render();
      },
      answered: () => this.showProbe(),
      uncertain: () => this.showUncertainty(),
      valued: (worth) => this.layout.devices.value(worth),
      shapes: () => this.picture.shapesAsked(this.shown),
      refused: (error) => this.failed(error),
    });
    this.work = new Work({
      change: (verb, body) => this.change(verb, body),
      draw: (signal) => this.answers.draw(this.session!, signal),
      rest: (signal) => this.answers.rest(this.session!, signal),
      failed: (error) => this.failed(error),
      busy: (busy) => this.layout.busy(busy),
    });
    this.searching = new Searching(this.layout.search, {
      change: (place, verb, body) => this.work.change(place, verb, body),
      failed: (error) => this.failed(error),
    });
    this.rooming = new Rooming(this.layout.room, this.layout.search, this.picture, this.shown, {
      change: (place, verb, body) => this.work.change(place, verb, body),
      failed: (error) => this.failed(error),
      say: (text) => this.layout.handSays(text),
      chosen: () => {
        this.drawRoom();
        this.described();
      },
    });
    this.holding = new Holding(this.layout, this.picture, this.shown, this.rooming, {
      change: (place, verb, body) => this.work.change(place, verb, body),
      undo: () => this.step('undo'),
    });
    listenForClicks(this.picture, {
      pressed: () => this.holding.end(),
      device: (name) => this.select(name),
      body: (path) => this.rooming.choose(path),
      place: (at) => this.ask(at),
    });
    this.layout.overPicture(new ViewCube(this.picture.stage, doings.look, doings.orthographic).element);
    listenForKeys(commands, (event) => this.holding.take(event));
  }

  async start(): Promise<void> {
    const kept = sessionStorage.getItem(sessionKey);
    if (kept) {
      try {
        return await this.opened(...(await Session.resume(kept)));
      } catch {
        sessionStorage.removeItem(sessionKey); // of a server that has ended
      }
    }
    const { first } = await listScenes();
    if (first) await this.open(first);
    else await this.chooseScene();
  }

  private async chooseScene(): Promise<void> {
    await this.attempt(async () => this.layout.start.show(await listScenes()));
  }

  private async open(id: string): Promise<void> {
    await this.attempt(async () => this.opened(...(await Session.open(id))));
  }

  private async askPalette(): Promise<void> {
    await this.attempt(async () => this.layout.addDevice.show(await this.session!.ask<Palette>('palette')));
  }

  private async attempt(what: () => Promise<void>): Promise<void> {
    try {
      await what();
    } catch (error) {
      this.failed(error);
    }
  }

  private async opened(session: Session, description: Description): Promise<void> {
    this.work.forget();
    this.session = session;
    sessionStorage.setItem(sessionKey, session.name);
    Object.assign(this.shown, nothingShown(), { description });
    this.ask(null);
    Object.assign(this.viewing, { slices: [false, false, true], at: middle(description.box), slants: [], relief: false, cells: false, through: firstViewing().through, surface: false, body: 'none', compare: 'design', sensitivity: '', low: null, high: null });
    this.shown.around = await session.ask<Around>('around');
    this.rooming.open(session);
    this.drawRoom();
    this.picture.stage.look('corner', description.room);
    this.described();
    this.work.refresh();
    await this.searching.open(session);
  }

  private async change(verb: string, body: object): Promise<void> {
    const { session } = this;
    const description = await session!.ask<Description>(verb, body);
    const moved = description.surroundings !== this.shown.description!.surroundings;
    const around = moved ? await session!.ask<Around>('around') : this.shown.around;
    if (session !== this.session) return;
    this.layout.devices.stale();
    this.shown.around = around;
    this.take(description);
    if (moved) this.drawRoom();
  }

  /** A description that the server gave after a change. */
  private take(description: Description): void {
    const { shown } = this;
    if (description.pinned !== shown.description!.pinned) [shown.pinned, shown.difference] = [null, null];
    if (description.pinned === null) this.viewing.compare = 'design';
    const names = new Set(description.devices.map((d) => d.name));
    const made = this.awaited && [...names].find((name) => !this.awaited!.has(name));
    if (made) shown.selected = made;
    if (shown.selected && !names.has(shown.selected)) shown.selected = null;
    this.awaited = null;
    shown.description = description;
    // Its field follows, and is drawn with it where that doesn't take long: a picture less.
    clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => this.described(), patience);
  }

  private described(draw = true): void {
    const { shown, picture } = this;
    clearTimeout(this.waiting);
    if (!shown.description) return;
    this.layout.describe(shown.description, shown.selected);
    this.searching.describe(shown.description, shown.selected);
    this.rooming.describe();
    picture.drawDevices(shown, this.colours);
    if (picture.stage.eye.asDevice) this.lookThrough();
    this.layout.gizmoMode(picture.gizmo.mode, this.holding.held);
    if (draw) picture.stage.draw();
  }

  private render(): void {
    const { shown, picture } = this;
    if (!shown.field || !shown.description) return;
    const { drawn, scale, marks } = picture.drawField(shown, this.colours);
    this.layout.field(shown, drawn, scale, marks, this.viewing, picture.latticeEnlarged);
    picture.stage.describe(wordsOf(drawn));
    picture.stage.draw();
  }

  /** Something else is to be shown. */
  private viewed(): void {
    this.render();
    this.described();
    this.showProbe();
    this.showUncertainty();
    if (this.shown.description && this.answers.lacking) this.work.refresh();
    else if (this.shown.field) void this.reshape();
  }

  private reshapes = 0;
  private async reshape(): Promise<void> {
    document.body.dataset.shaping = String(++this.reshapes > 0);
    await this.attempt(() => this.answers.reshape(this.session!));
    document.body.dataset.shaping = String(--this.reshapes > 0);
  }

  private drawRoom(): void {
    this.layout.floor(this.picture.drawRoom(this.shown, this.colours));
    this.showProbe();
  }

  private select(name: string | null): void {
    this.holding.end();
    this.shown.selected = name;
    if (name) this.rooming.choose(null);
    this.described();
  }

  private chooseNext(step: number): void {
    const names = this.shown.description!.devices.map((d) => d.name);
    const at = names.indexOf(this.shown.selected ?? '');
    this.select(names[at < 0 ? 0 : (at + step + names.length) % names.length] ?? null);
  }

  private letGo(): void {
    if (this.picture.stage.eye.asDevice) this.look('corner');
    else if (this.shown.selected) this.select(null);
    else if (this.shown.body) this.rooming.choose(null);
    else this.ask(null);
  }

  private ask(at: Vec3 | null): void {
    Object.assign(this.shown, { asked: at, report: null });
    this.showProbe();
    if (at) this.work.refresh();
    else this.layout.report.clear();
  }

  private showProbe(): void {
    const { shown, picture, viewing } = this;
    picture.drawProbe(shown, this.colours);
    if (shown.asked && shown.report) this.layout.report.show(shown.report, shown.description!.metric, picture.enlarged, viewing.sigmas);
    picture.stage.draw();
  }

  private showUncertainty(): void {
    this.picture.drawUncertainty(this.shown, this.colours);
    if (this.shown.field) this.render();
    this.picture.stage.draw();
  }

  private look(from: ViewName): void {
    this.picture.stage.look(from);
    this.described();
  }

  private lookThrough(): void {
    const device = this.shown.description!.devices.find((d) => d.name === this.shown.selected);
    if (device?.pose) this.picture.lookThrough(device);
    else this.picture.stage.look('corner');
  }

  /** Each press is a step: none takes another's place. */
  private step(verb: 'undo' | 'redo'): void {
    if (this.session) this.work.change(newGesture(), verb, {});
  }

  private pin(pinned: boolean): void {
    if (pinned) this.viewing.compare = 'difference';
    this.work.change(newGesture(), pinned ? 'pin' : 'unpin', {});
  }

  /** Make a device, and choose it. */
  private make(verb: string, body: object): void {
    this.awaited = new Set(this.shown.description!.devices.map((d) => d.name));
    this.work.change(newGesture(), verb, body);
  }

  /** A step along x that is seen. */
  private besideIt(): Vec3 {
    return [this.picture.stepBeside(this.shown), 0, 0];
  }

  private toggleTheme(): void {
    this.theme = this.theme === 'dark' ? 'light' : 'dark';
    localStorage.setItem('delos-theme', this.theme);
    this.colours = applyTheme(this.theme);
    this.picture.stage.background(this.colours.background);
    if (!this.shown.description) return;
    this.drawRoom();
    this.viewed();
  }

  private async save(): Promise<void> {
    await this.attempt(async () => {
      const name = download(await this.session!.text(), this.shown.description!.name);
      this.layout.say(`Saved as ${name}`, 'good');
    });
  }

  /** What was refused stays as it was: the panels show that again. */
  private failed(error: unknown): void {
    const lost = error instanceof TypeError;
    this.awaited = null;
    this.layout.say(lost ? 'The server has ended: start delos explore again.' : (error as Error).message, 'bad');
    this.described();
  }
}
