// The picture of a report: all that can be looked at without asking anybody.
import { h, iconButton } from '../dom';
import { wordsOf } from '../field';
import { listenForClicks } from '../mouse';
import { ColourBar } from '../panels/colourbar';
import { ColouringPanel } from '../panels/colouring';
import { ComparePanel } from '../panels/compare';
import { check, details } from '../panels/details';
import { Devices } from '../panels/devices';
import { SlicesPanel } from '../panels/slices';
import { UncertaintyPanel } from '../panels/uncertainty';
import { Picture, type Shown } from '../picture';
import { quantity } from '../quantity';
import type { Worth } from '../server';
import { applyTheme, type Theme } from '../theme';
import { ViewCube } from '../view/viewcube';
import { firstViewing, middle } from '../viewing';
import { DeviceTable } from './devicetable';

/** Colours are logarithmic from the first where values span more than such a factor. */
const wide = 20;

export class FrozenPicture {
  readonly element: HTMLElement;
  private readonly viewing = firstViewing();
  private readonly picture: Picture;
  private readonly viewport = h('div', { className: 'viewport', id: 'viewport' });
  private readonly bar = new ColourBar();
  private readonly devices: Devices;
  private readonly chosen = new DeviceTable();
  private readonly slices: SlicesPanel;
  private readonly colouring: ColouringPanel;
  private readonly uncertainty: UncertaintyPanel;
  private readonly compare: ComparePanel;
  private readonly floor = h('div', { className: 'scale-note' });
  private colours;

  /** @throws where the browser draws no WebGL */
  constructor(
    private readonly shown: Shown,
    worth: Worth | null,
    theme: Theme,
  ) {
    const { viewing } = this;
    const { min } = shown.field!.summary;
    const max = shown.field!.summary.max?.value ?? 0;
    viewing.logarithmic = min !== null && min.value > 0 && max > wide * min.value;
    viewing.at = middle(shown.description!.box);
    this.colours = applyTheme(theme);
    const changed = () => this.viewed();
    this.devices = new Devices((name) => this.select(name), null);
    this.slices = new SlicesPanel(viewing, changed, false);
    this.colouring = new ColouringPanel(viewing, changed);
    this.uncertainty = new UncertaintyPanel(viewing, changed);
    this.compare = new ComparePanel(viewing, changed, null);
    this.picture = new Picture(this.viewport, viewing, null, () => {});
    const { stage } = this.picture;
    stage.background(this.colours.background);
    // The wheel scrolls the page until the picture is pressed.
    stage.orbit.enableZoom = false;
    stage.canvas.addEventListener('focus', () => (stage.orbit.enableZoom = true));
    stage.canvas.addEventListener('blur', () => (stage.orbit.enableZoom = false));
    listenForClicks(this.picture, { pressed: () => stage.canvas.focus({ preventScroll: true }), device: (name) => this.select(name), body: () => {}, place: () => {} });
    this.compare.element.hidden = shown.pinned === null;
    this.element = this.laidOut();
    this.devices.show(shown.description!, null);
    if (worth) this.devices.value(worth);
    else this.devices.unweighed();
  }

  private laidOut(): HTMLElement {
    const { viewing, picture, shown } = this;
    const toggle = (key: 'frusta' | 'names') =>
      check(`view-${key}`, key, (on) => {
        viewing[key] = on;
        this.viewed();
      });
    const toggles = (['frusta', 'names'] as const).map((key) => {
      const [label, box] = toggle(key);
      box.checked = viewing[key];
      return label;
    });
    const cube = new ViewCube(
      picture.stage,
      (from) => picture.stage.look(from),
      () => picture.stage.setOrthographic(!picture.stage.eye.orthographic),
    );
    const view = h(
      'section',
      { className: 'panel viewing', tabIndex: 0, 'aria-label': 'View' },
      h('h2', {}, 'View'),
      this.slices.element,
      h('div', { className: 'checks' }, ...toggles),
      details('Colours', false, this.colouring.element),
      ...(shown.lattice ? [details('Uncertainty', false, this.uncertainty.element)] : []),
    );
    return h(
      'section',
      { className: 'interactive', 'aria-label': 'Picture' },
      h('div', { className: 'side' }, this.devices.element, view),
      h(
        'div',
        { className: 'middle' },
        this.viewport,
        cube.element,
        h('div', { className: 'top-left' }, h('div', { className: 'tools' }, iconButton('fit', 'Look at the whole room', () => picture.stage.look('corner')))),
        this.bar.element,
        h('div', { className: 'bottom-left' }, this.compare.element, this.floor),
      ),
      h('div', { className: 'side' }, this.chosen.element),
    );
  }

  /** Draw, once it stands in the page. */
  begin(): void {
    this.room();
    this.picture.stage.look('corner', this.shown.description!.room);
    this.viewed();
  }

  paint(theme: Theme): void {
    this.colours = applyTheme(theme);
    this.picture.stage.background(this.colours.background);
    this.room();
    this.viewed();
  }

  private room(): void {
    this.floor.textContent = `floor squares ${quantity(this.picture.drawRoom(this.shown, this.colours), 'm')}`;
  }

  private select(name: string | null): void {
    this.shown.selected = name;
    this.described();
  }

  private described(): void {
    const { shown, picture } = this;
    this.devices.show(shown.description!, shown.selected);
    this.chosen.show(shown.description!, shown.selected);
    picture.drawDevices(shown, this.colours);
    picture.stage.draw();
  }

  private viewed(): void {
    const { shown, picture, viewing } = this;
    picture.drawUncertainty(shown, this.colours);
    const { drawn, scale, marks } = picture.drawField(shown, this.colours);
    this.bar.show(drawn, scale, marks, viewing.units);
    this.slices.show(drawn);
    this.colouring.show(drawn);
    this.uncertainty.show(shown.blind, picture.latticeEnlarged);
    this.compare.show(shown.pinned !== null, shown.difference?.summary ?? null);
    picture.stage.describe(wordsOf(drawn));
    this.described();
  }
}
