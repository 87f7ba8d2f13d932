// What of the field is shown, and how.
import { h } from '../dom';
import type { Field, GridPart } from '../field';
import { digits, quantity } from '../quantity';
import type { Scale } from '../scale';
import type { Box, Vec3 } from '../server';
import { layerAt } from '../view/fieldview';

export interface Viewing {
  axis: number;
  /** Where the slice across each axis lies, metres. */
  at: Vec3;
  surface: boolean;
  /** Of the surface, as a part of the colour bar. */
  level: number;
  logarithmic: boolean;
  frusta: boolean;
  names: boolean;
}

export const middle = ({ min, max }: Box) => min.map((x, k) => (x + max[k]!) / 2) as Vec3;

const axes = ['x', 'y', 'z'];

export class ViewingPanel {
  readonly element: HTMLElement;
  private readonly buttons: HTMLButtonElement[];
  private readonly layer = h('input', { type: 'range', id: 'layer', 'aria-label': 'Place of the slice' });
  private readonly layerText = h('output');
  private readonly level = h('input', { type: 'range', min: '0', max: '100', step: '0.5', id: 'level', 'aria-label': 'Level of the surface' });
  private readonly levelText = h('output', {});
  private readonly gridOnly: HTMLElement;
  private readonly surfaceRow: HTMLElement;
  private readonly boxes: Record<'surface' | 'logarithmic' | 'frusta' | 'names', HTMLInputElement>;
  private grid: GridPart | null = null;

  constructor(
    private readonly viewing: Viewing,
    private readonly changed: () => void,
  ) {
    const choose = (axis: number) => () => this.set({ axis });
    this.buttons = [...axes, 'off'].map((name, k) =>
      h('button', { type: 'button', onclick: choose(k < 3 ? k : -1), 'aria-label': k < 3 ? `Slice across ${name}` : 'No slice' }, name),
    );
    this.layer.oninput = () => {
      const { origin, step } = this.grid!;
      const { axis } = this.viewing;
      this.viewing.at[axis] = origin[axis]! + Number(this.layer.value) * step[axis]!;
      this.changed();
    };
    this.level.oninput = () => this.set({ level: Number(this.level.value) / 100, surface: true });
    const toggle = (key: 'surface' | 'logarithmic' | 'frusta' | 'names') =>
      h('input', {
        type: 'checkbox',
        id: `view-${key}`,
        onchange: (event: Event) => this.set({ [key]: (event.target as HTMLInputElement).checked }),
      });
    this.boxes = {
      surface: toggle('surface'),
      logarithmic: toggle('logarithmic'),
      frusta: toggle('frusta'),
      names: toggle('names'),
    };
    const labelled = (key: keyof typeof this.boxes, text: string) =>
      h('label', { htmlFor: `view-${key}` }, this.boxes[key], text);
    this.surfaceRow = h(
      'div',
      { className: 'row' },
      labelled('surface', 'Surface at'),
      this.level,
      this.levelText,
    );
    this.gridOnly = h(
      'div',
      {},
      h(
        'div',
        { className: 'row' },
        h('span', {}, 'Slice'),
        h('div', { className: 'segments', role: 'group', 'aria-label': 'Slice' }, ...this.buttons),
      ),
      h('div', { className: 'row' }, h('span', {}, 'at'), this.layer, this.layerText),
      this.surfaceRow,
    );
    this.element = h(
      'section',
      { className: 'panel viewing' },
      h('h2', {}, 'View'),
      this.gridOnly,
      h(
        'div',
        { className: 'checks' },
        labelled('logarithmic', 'log scale'),
        labelled('frusta', 'frusta'),
        labelled('names', 'names'),
      ),
    );
  }

  set(some: Partial<Viewing>): void {
    Object.assign(this.viewing, some);
    this.changed();
  }

  show(field: Field, scale: Scale | null): void {
    const { viewing } = this;
    this.grid = field.parts.find((p): p is GridPart => p.kind === 'grid') ?? null;
    this.gridOnly.hidden = this.grid === null;
    for (const [key, box] of Object.entries(this.boxes))
      box.checked = viewing[key as keyof typeof this.boxes];
    this.buttons.forEach((button, k) => {
      button.setAttribute('aria-pressed', String(viewing.axis === (k < 3 ? k : -1)));
    });
    this.layer.disabled = viewing.axis < 0;
    if (this.grid && viewing.axis >= 0) {
      const { origin, step, counts } = this.grid;
      const n = layerAt(this.grid, viewing.axis, viewing.at[viewing.axis]!);
      this.layer.max = String(counts[viewing.axis]! - 1);
      this.layer.value = String(n);
      this.layerText.textContent = `${axes[viewing.axis]} ${digits(origin[viewing.axis]! + n * step[viewing.axis]!, 3)} m`;
      this.layer.setAttribute('aria-valuetext', this.layerText.textContent);
    } else {
      this.layerText.textContent = '';
    }
    this.surfaceRow.hidden = !scale;
    if (!scale) return;
    this.level.value = String(100 * viewing.level);
    this.levelText.textContent = quantity(scale.at(viewing.level), field.summary.metric.unit);
    this.level.setAttribute('aria-valuetext', this.levelText.textContent);
  }
}
