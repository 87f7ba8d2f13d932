// Which planes cut the field, and where.
import { h, iconButton } from '../dom';
import { Drawn, type Field, type GridPart } from '../field';
import { digits, quantity } from '../quantity';
import type { Viewing, Slant } from '../viewing';
import { layerAt } from '../view/fieldview';

const axes = ['x', 'y', 'z'];

/** A slider with its name and what it says. */
function slider(label: string, text: string, value: number, max: number, step: number, oninput: (value: number) => void): HTMLElement {
  const input = h('input', { type: 'range', min: '0', max: String(max), step: String(step), 'aria-label': label, 'aria-valuetext': text });
  input.value = String(value);
  input.oninput = () => oninput(Number(input.value));
  return input;
}

/** The least and the greatest value in a layer; null: it has none. */
export function rangeOfLayer(field: Field, part: GridPart, axis: number, layer: number): [number, number] | null {
  const strides = [1, part.counts[0], part.counts[0] * part.counts[1]];
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < part.count; ++i) {
    if (Math.floor(i / strides[axis]!) % part.counts[axis]! !== layer || field.mask[part.first + i] !== Drawn.value) continue;
    const value = field.values[part.first + i]!;
    [low, high] = [Math.min(low, value), Math.max(high, value)];
  }
  return low <= high ? [low, high] : null;
}

export class SlicesPanel {
  readonly element: HTMLElement;
  private readonly buttons: HTMLButtonElement[];
  private readonly layers = h('div');
  private readonly slants = h('div');
  private shown = '';
  private field: Field | null = null;
  /** What tells the range of each layer. */
  private tellers: (() => void)[] = [];

  constructor(
    private readonly viewing: Viewing,
    private readonly changed: () => void,
    /** Whether others than those of the samples can be asked for. */
    slanted = true,
  ) {
    this.buttons = axes.map((name, k) =>
      h('button', { type: 'button', onclick: () => this.toggle(k), 'aria-label': `Slice across ${name}` }, name),
    );
    const slant = h('button', { type: 'button', 'aria-label': 'Add a slanted slice', onclick: () => this.addSlant() }, '+ /');
    this.element = h(
      'div',
      {},
      h(
        'div',
        { className: 'row' },
        h('span', {}, 'Slices'),
        h('div', { className: 'segments', role: 'group', 'aria-label': 'Slices' }, ...this.buttons, slanted && slant),
      ),
      this.layers,
      this.slants,
    );
  }

  toggle(axis: number): void {
    this.viewing.slices[axis] = !this.viewing.slices[axis];
    this.changed();
  }

  addSlant(): void {
    if (this.viewing.slants.length >= 4) return;
    this.viewing.slants.push({ azimuth: Math.PI / 4, tilt: Math.PI / 4, part: 0.5 });
    this.changed();
  }

  show(field: Field): void {
    const { viewing } = this;
    const grid = field.parts.find((p): p is GridPart => p.kind === 'grid') ?? null;
    this.element.hidden = grid === null;
    if (!grid) return;
    this.buttons.forEach((button, k) => button.setAttribute('aria-pressed', String(viewing.slices[k])));
    // What is being dragged stays.
    const key = JSON.stringify([viewing.slices, grid.origin, grid.step, grid.counts, viewing.slants.length]);
    if (key !== this.shown) {
      this.shown = key;
      this.tellers = [];
      this.layers.replaceChildren(...[0, 1, 2].filter((k) => viewing.slices[k]).map((k) => this.layer(grid, k)));
      this.slants.replaceChildren(...viewing.slants.map((slant, k) => this.slant(slant, k)));
    }
    this.field = field;
    for (const tell of this.tellers) tell();
  }

  private layer(grid: GridPart, axis: number): HTMLElement {
    const { viewing } = this;
    const place = (n: number) => grid.origin[axis]! + n * grid.step[axis]!;
    const words = (n: number) => `${axes[axis]} ${digits(place(n), 3)} m`;
    const n = layerAt(grid, axis, viewing.at[axis]!);
    const text = h('output', {}, words(n));
    const ends = h('p', { className: 'hint slice-range', 'data-axis': axes[axis] });
    const tell = (layer: number) => {
      const found = rangeOfLayer(this.field!, grid, axis, layer);
      const { unit } = this.field!.summary.metric;
      ends.dataset.min = String(found?.[0] ?? '');
      ends.dataset.max = String(found?.[1] ?? '');
      ends.textContent = found ? `${quantity(found[0], unit, 4)} to ${quantity(found[1], unit, 4)}` : 'blind';
    };
    this.tellers.push(() => tell(layerAt(grid, axis, viewing.at[axis]!)));
    const input = slider(`Place of the slice across ${axes[axis]}`, words(n), n, grid.counts[axis]! - 1, 1, (value) => {
      viewing.at[axis] = place(value);
      text.textContent = words(value);
      input.setAttribute('aria-valuetext', words(value));
      this.changed();
    });
    return h('div', {}, h('div', { className: 'row' }, h('span', {}, 'at'), input, text), ends);
  }

  private slant(slant: Slant, which: number): HTMLElement {
    const part = (key: keyof Slant, label: string, max: number, step: number, words: () => string) => {
      const text = h('output', {}, words());
      const input = slider(`${label} of slanted slice ${which + 1}`, words(), slant[key], max, step, (value) => {
        slant[key] = value;
        text.textContent = words();
        input.setAttribute('aria-valuetext', words());
        this.changed();
      });
      return h('div', { className: 'row' }, h('span', {}, label), input, text);
    };
    const degrees = (angle: number) => `${Math.round((angle * 180) / Math.PI)}°`;
    return h(
      'fieldset',
      { className: 'slant' },
      h('legend', {}, `slanted ${which + 1} `, iconButton('close', `Take slanted slice ${which + 1} away`, () => {
        this.viewing.slants.splice(which, 1);
        this.shown = '';
        this.changed();
      })),
      part('azimuth', 'turn', 2 * Math.PI, Math.PI / 36, () => degrees(slant.azimuth)),
      part('tilt', 'tilt', Math.PI, Math.PI / 36, () => degrees(slant.tilt)),
      part('part', 'at', 1, 0.01, () => `${Math.round(100 * slant.part)} %`),
    );
  }
}
