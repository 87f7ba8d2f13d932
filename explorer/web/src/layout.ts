// The page around the picture.
import { h, iconButton } from './dom';
import type { Field } from './field';
import type { Place } from './gizmo';
import { ColourBar } from './panels/colourbar';
import { Devices } from './panels/devices';
import type { Command } from './commands';
import { shownKey } from './commands';
import { AddDevice, type Add } from './panels/adddevice';
import { ArrayOfDevices, type DeviceArray } from './panels/array';
import { CommandPalette } from './panels/commandpalette';
import { ComparePanel } from './panels/compare';
import { Inspector, type Change } from './panels/inspector';
import { Report } from './panels/report';
import { RoomPanel, type RoomActions } from './panels/room';
import { SearchPanel, type SearchActions } from './panels/search';
import { Start } from './panels/start';
import { ViewingPanel } from './panels/viewing';
import { counted, quantity } from './quantity';
import type { Scale } from './scale';
import type { Description, Setting, Vec3 } from './server';
import { sizeOf, type Shown } from './picture';
import type { Viewing } from './viewing';
import type { ViewName } from './view/eye';

export interface Actions {
  open: (scene: string) => void;
  chooseScene: () => void;
  select: (device: string | null) => void;
  change: Change;
  place: Place;
  undo: () => void;
  redo: () => void;
  save: () => void;
  toggleTheme: () => void;
  viewed: () => void;
  ask: (at: Vec3) => void;
  clear: () => void;
  gizmo: (mode: 'translate' | 'rotate') => void;
  look: (from: ViewName) => void;
  askPalette: () => void;
  add: Add;
  copy: () => void;
  array: () => void;
  makeArray: (array: DeviceArray) => void;
  mirror: (axis: 'x' | 'y') => void;
  remove: () => void;
  pin: (pinned: boolean) => void;
  set: (setting: Setting) => void;
  snap: () => void;
  search: () => void;
  searching: SearchActions;
  room: () => void;
  rooming: RoomActions;
}

/** The words of a scene's `fusion`. */
const fusions = ['stacked', 'continuous', 'periodic', 'sequential', 'artemis'];

const mouse: [string, string][] = [
  ['drag, wheel', 'turn, come nearer; right button: shift'],
  ['G or R, then X, Y or Z and a number', 'move or turn by as much; twice the axis: the device\'s own'],
];

export class Layout {
  readonly viewport = h('div', { className: 'viewport', id: 'viewport' });
  readonly start: Start;
  readonly devices: Devices;
  readonly report: Report;
  readonly viewingPanel: ViewingPanel;
  readonly addDevice: AddDevice;
  readonly array: ArrayOfDevices;
  readonly palette: CommandPalette;
  readonly search: SearchPanel;
  readonly room: RoomPanel;
  readonly help: HTMLDialogElement;
  private readonly inspector: Inspector;
  private readonly compare: ComparePanel;
  private readonly snap: HTMLButtonElement;
  private readonly hand = h('div', { className: 'hand', id: 'hand', role: 'status' });
  private readonly bar = new ColourBar();
  private readonly scene: HTMLButtonElement;
  private readonly metric: HTMLSelectElement;
  private readonly fusion: HTMLSelectElement;
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly modes: Record<'translate' | 'rotate', HTMLButtonElement>;
  private readonly tools: HTMLElement;
  private readonly numbers = h('div', { className: 'numbers', id: 'numbers' });
  private readonly message = h('div', { className: 'message', role: 'alert' });
  private readonly scaleNote = h('div', { className: 'scale-note' });
  private silence = 0;

  constructor(
    root: HTMLElement,
    viewing: Viewing,
    private readonly actions: Actions,
    commands: Command[],
  ) {
    this.start = new Start(actions.open);
    this.devices = new Devices(actions.select, actions.askPalette);
    this.inspector = new Inspector(actions.change, actions.place, actions);
    this.addDevice = new AddDevice(actions.add);
    this.array = new ArrayOfDevices(actions.makeArray);
    this.palette = new CommandPalette(commands, actions.set);
    this.compare = new ComparePanel(viewing, actions.viewed, actions.pin);
    this.search = new SearchPanel(actions.searching);
    this.room = new RoomPanel(actions.rooming);
    this.report = new Report(actions.ask, actions.clear);
    this.viewingPanel = new ViewingPanel(viewing, actions.viewed);
    this.scene = h('button', { type: 'button', className: 'scene', id: 'scene', title: 'Open another scene', onclick: actions.chooseScene }, 'Open a scene');
    this.metric = h('select', {
      id: 'metric',
      onchange: () => actions.change([{ path: 'metric', value: this.metric.value }], ''),
    });
    this.fusion = h(
      'select',
      {
        id: 'fusion',
        title: 'How the readings of several devices come together',
        onchange: () => actions.change([{ path: 'fusion', value: this.fusion.value }], ''),
      },
      ...fusions.map((name) => h('option', { value: name }, name)),
    );
    this.undo = iconButton('undo', 'Undo (Ctrl Z)', actions.undo);
    this.redo = iconButton('redo', 'Redo (Ctrl Y)', actions.redo);
    this.modes = {
      translate: iconButton('move', 'Move the chosen device (G)', () => actions.gizmo('translate')),
      rotate: iconButton('turn', 'Turn the chosen device (R)', () => actions.gizmo('rotate')),
    };
    this.help = h(
      'dialog',
      { className: 'help', 'aria-label': 'Keys' },
      iconButton('close', 'Close', () => this.help.close()),
      h('h2', {}, 'Keys and mouse'),
      h(
        'dl',
        {},
        ...commands.filter((c) => c.keys.length > 0).flatMap((c) => [h('dt', {}, c.keys.map(shownKey).join(', ')), h('dd', {}, c.name)]),
        ...mouse.flatMap(([keys, what]) => [h('dt', {}, keys), h('dd', {}, what)]),
      ),
    );
    this.snap = h('button', { type: 'button', className: 'word', title: 'Snap to 5 cm, 5° and faces (N); turned to them (T)', 'aria-pressed': 'false', onclick: actions.snap }, 'snap');
    this.tools = h(
      'div',
      { className: 'tools', role: 'toolbar', 'aria-label': 'View' },
      this.modes.translate,
      this.modes.rotate,
      this.snap,
      iconButton('fit', 'Look at the whole room (F)', () => actions.look('corner')),
    );
    root.append(this.header(), this.main(), this.start.element, this.addDevice.element, this.array.element, this.palette.element, this.help);
  }

  private header(): HTMLElement {
    const { actions } = this;
    return h(
      'header',
      { className: 'top' },
      h('span', { className: 'brand' }, 'Delos'),
      this.scene,
      h('label', { className: 'metric', htmlFor: 'metric' }, 'Metric', this.metric),
      h('label', { className: 'metric', htmlFor: 'fusion' }, 'Fusion', this.fusion),
      h('span', { className: 'space' }),
      this.undo,
      this.redo,
      h('button', { type: 'button', className: 'word', id: 'room-open', title: 'What the room is made of (W)', onclick: actions.room }, 'Room'),
      h('button', { type: 'button', className: 'word', id: 'search-open', title: 'Search for a better design (S)', 'aria-pressed': 'false', onclick: actions.search }, 'Search'),
      iconButton('save', 'Save as a scene file', actions.save),
      iconButton('theme', 'Dark or light', actions.toggleTheme),
      h('button', { type: 'button', className: 'word', title: 'All commands (Ctrl K)', onclick: () => this.palette.show() }, 'Commands'),
      iconButton('help', 'Keys and mouse (?)', () => this.help.showModal()),
    );
  }

  private main(): HTMLElement {
    return h(
      'main',
      {},
      h('aside', { 'aria-label': 'Devices and view' }, this.devices.element, this.viewingPanel.element),
      h(
        'div',
        { className: 'centre' },
        h(
          'div',
          { className: 'middle' },
          this.viewport,
          h('div', { className: 'top-left' }, this.tools, this.compare.element),
          this.bar.element,
          h('div', { className: 'bottom-left' }, this.message, this.hand, this.scaleNote, this.numbers),
        ),
        this.search.element,
      ),
      h(
        'aside',
        { 'aria-label': 'Chosen device and point' },
        h('section', { className: 'panel grow' }, this.inspector.element),
        this.room.element,
        this.report.element,
      ),
    );
  }

  describe(description: Description, selected: string | null): void {
    document.title = `${description.name} · Delos`;
    this.scene.textContent = description.name;
    this.undo.disabled = description.undo === 0;
    this.redo.disabled = description.redo === 0;
    if (this.metric.dataset.names !== description.metrics.join()) {
      this.metric.dataset.names = description.metrics.join();
      this.metric.replaceChildren(
        ...description.metrics.map((name) => h('option', { value: name }, name)),
      );
    }
    this.metric.value = description.metric.name;
    this.metric.title = description.definition;
    this.fusion.value = description.fusion;
    this.devices.show(description, selected);
    this.viewingPanel.sensitivity.show(description, selected);
    this.inspector.show(description, selected);
  }

  /** @param drawn what the colours are of: the design's field, or its difference
   *  @param marks values that are marked on the bar */
  field(shown: Shown, drawn: Field, scale: Scale | null, marks: number[], viewing: Viewing, enlarged: number): void {
    const field = shown.field!;
    const { summary } = field;
    this.bar.show(drawn, scale, marks, viewing.units);
    this.viewingPanel.show(drawn, shown.through, scale, shown.blind, enlarged, sizeOf(shown.description!), shown.shapes);
    this.compare.show(shown.description!.pinned !== null, shown.difference?.summary ?? null);
    const unit = summary.metric.unit;
    const best = field.largerIsBetter ? summary.max : summary.min;
    const worst = field.largerIsBetter ? summary.min : summary.max;
    const one = (name: string, value: number | null | undefined) =>
      h('span', { 'data-number': name, 'data-value': value ?? '' }, `${name} `, h('b', {}, quantity(value, unit)));
    this.numbers.dataset.level = field.level;
    this.numbers.dataset.revision = String(field.revision);
    this.numbers.title = field.definition;
    this.numbers.replaceChildren(
      one('best', best?.value),
      one('mean', summary.mean),
      one('median', summary.median),
      one('worst', worst?.value),
      h('span', {}, counted(summary.samples, 'sample'), field.level === 'coarse' ? ', refining…' : ''),
    );
  }

  /** Something that lies on the picture. */
  overPicture(element: HTMLElement): void {
    this.viewport.after(element);
  }

  floor(step: number): void {
    this.scaleNote.textContent = `floor squares ${quantity(step, 'm')}`;
  }

  gizmoMode(mode: 'translate' | 'rotate', held: boolean): void {
    for (const [name, button] of Object.entries(this.modes)) {
      button.disabled = !held;
      button.setAttribute('aria-pressed', String(name === mode));
    }
  }

  busy(busy: boolean): void {
    document.body.dataset.busy = String(busy);
  }

  say(text: string, mood: 'good' | 'bad'): void {
    this.message.textContent = text;
    this.message.dataset.mood = mood;
    clearTimeout(this.silence);
    this.silence = window.setTimeout(() => (this.message.textContent = ''), mood === 'bad' ? 12000 : 4000);
  }

  /** What is typed of a movement. */
  handSays(text: string): void {
    this.hand.textContent = text;
  }

  snapping(on: boolean, turning: boolean): void {
    this.snap.textContent = turning ? 'snap, turned' : 'snap';
    this.snap.setAttribute('aria-pressed', String(on));
  }
}
