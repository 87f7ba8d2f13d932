// The page around the picture.
import { h, iconButton } from './dom';
import type { Field } from './field';
import type { Place } from './gizmo';
import { ColourBar } from './panels/colourbar';
import { Devices } from './panels/devices';
import { Inspector, type Change } from './panels/inspector';
import { Report } from './panels/report';
import { Start } from './panels/start';
import { ViewingPanel, type Viewing } from './panels/viewing';
import { counted, quantity } from './quantity';
import type { Scale } from './scale';
import type { Description, Vec3 } from './server';
import type { ViewName } from './view/stage';

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
}

/** The words of a scene's `fusion`. */
const fusions = ['stacked', 'continuous', 'periodic', 'sequential', 'artemis'];

const shortcuts: [string, string][] = [
  ['Ctrl Z, Ctrl Y', 'undo, redo'],
  ['G, R', 'move, turn the chosen device'],
  ['Esc', 'let go of it'],
  ['F', 'look at the whole room'],
  ['7, 1, 3', 'look from above, from the front, from the side'],
  ['X, Y, Z', 'slice across an axis'],
  ['drag, wheel', 'turn, come nearer; right button: shift'],
];

export class Layout {
  readonly viewport = h('div', { className: 'viewport', id: 'viewport' });
  readonly start: Start;
  readonly devices: Devices;
  readonly report: Report;
  private readonly inspector: Inspector;
  private readonly viewingPanel: ViewingPanel;
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
  private readonly help: HTMLDialogElement;
  private silence = 0;

  constructor(
    root: HTMLElement,
    viewing: Viewing,
    private readonly actions: Actions,
  ) {
    this.start = new Start(actions.open);
    this.devices = new Devices(actions.select);
    this.inspector = new Inspector(actions.change, actions.place);
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
      h('dl', {}, ...shortcuts.flatMap(([keys, what]) => [h('dt', {}, keys), h('dd', {}, what)])),
    );
    this.tools = h(
      'div',
      { className: 'tools', role: 'toolbar', 'aria-label': 'View' },
      this.modes.translate,
      this.modes.rotate,
      iconButton('fit', 'Look at the whole room (F)', () => actions.look('corner')),
      ...(['top', 'front', 'side'] as const).map((from) =>
        h('button', { type: 'button', className: 'word', title: `Look from the ${from}`, onclick: () => actions.look(from) }, from),
      ),
    );
    root.append(this.header(), this.main(), this.start.element, this.help);
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
      iconButton('save', 'Save as a scene file', actions.save),
      iconButton('theme', 'Dark or light', actions.toggleTheme),
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
        { className: 'middle' },
        this.viewport,
        this.tools,
        this.bar.element,
        this.scaleNote,
        this.numbers,
        this.message,
      ),
      h(
        'aside',
        { 'aria-label': 'Chosen device and point' },
        h('section', { className: 'panel grow' }, this.inspector.element),
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
    this.inspector.show(description, selected);
  }

  field(field: Field, scale: Scale | null, level: number | null): void {
    const { summary } = field;
    this.bar.show(field, scale, level);
    this.viewingPanel.show(field, scale);
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

  keys(on: { translate: () => void; rotate: () => void; escape: () => void; ready: () => boolean }): void {
    const axis = (k: number) => () => this.viewingPanel.set({ axis: k });
    const plain: Record<string, () => void> = {
      g: on.translate,
      r: on.rotate,
      f: () => this.actions.look('corner'),
      7: () => this.actions.look('top'),
      1: () => this.actions.look('front'),
      3: () => this.actions.look('side'),
      x: axis(0),
      y: axis(1),
      z: axis(2),
      escape: on.escape,
      '?': () => this.help.showModal(),
    };
    document.addEventListener('keydown', (event) => {
      const key = event.key.toLowerCase();
      const { target } = event;
      // Letters in a text are the text's.
      const typing =
        (target instanceof HTMLInputElement && target.type === 'text') ||
        target instanceof HTMLSelectElement;
      const edited = target instanceof HTMLInputElement && typing && target.value !== target.defaultValue;
      if (!on.ready() || document.querySelector('dialog[open]')) return;
      if ((event.ctrlKey || event.metaKey) && !edited && (key === 'z' || key === 'y')) {
        event.preventDefault();
        if (key === 'y' || event.shiftKey) this.actions.redo();
        else this.actions.undo();
      } else if (!typing && !event.ctrlKey && !event.metaKey && !event.altKey && plain[key]) {
        event.preventDefault();
        plain[key]!();
      }
    });
  }
}
