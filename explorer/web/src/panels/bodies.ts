// Surfaces and volumes of the field: where it has a value, or lies between two.
import { h } from '../dom';
import { Drawn, type Field } from '../field';
import { digits, percent, quantity, siOf } from '../quantity';
import type { Scale } from '../scale';
import type { Shapes } from '../shapes';
import { endsOf, type Viewing } from '../viewing';
import { check, choice } from './details';

/** A part of the colour bar as a slider, and its value as a text. */
class Level {
  readonly slider: HTMLInputElement;
  readonly box: HTMLInputElement;
  private scale: Scale | null = null;
  private unit = '1';

  constructor(id: string, label: string, set: (part: number) => void) {
    this.slider = h('input', { type: 'range', min: '0', max: '1', step: '0.0025', id, 'aria-label': label });
    this.slider.oninput = () => set(Number(this.slider.value));
    this.box = h('input', { type: 'text', className: 'level', spellcheck: false, autocomplete: 'off', 'aria-label': `${label}, value` });
    this.box.onchange = () => {
      const value = siOf(this.box.value, this.unit);
      if (this.scale && Number.isFinite(value)) set(Math.min(1, Math.max(0, this.scale.part(value))));
    };
  }

  show(part: number, scale: Scale, unit: string): void {
    this.scale = scale;
    this.unit = unit;
    this.slider.value = String(part);
    const text = quantity(scale.at(part), unit, 4);
    this.slider.setAttribute('aria-valuetext', text);
    if (document.activeElement !== this.box) this.box.value = text;
  }
}

/** How many samples have a value in an interval. */
export function countBetween(field: Field, low: number, high: number): { inside: number; all: number } {
  let inside = 0;
  let all = 0;
  field.values.forEach((value, i) => {
    if (field.mask[i] !== Drawn.inside) ++all;
    if (field.mask[i] === Drawn.value && value >= low && value <= high) ++inside;
  });
  return { inside, all };
}

export class BodiesPanel {
  readonly element: HTMLElement;
  private readonly surface: HTMLInputElement;
  private readonly surfaceRow: HTMLElement;
  private readonly level: Level;
  private readonly body: HTMLSelectElement;
  private readonly ends: [Level, Level];
  private readonly interval: HTMLElement;
  private readonly area = h('p', { className: 'hint', id: 'surface-area' });
  private readonly count = h('p', { className: 'hint', id: 'between-count' });

  constructor(
    private readonly viewing: Viewing,
    changed: () => void,
  ) {
    const set = (some: Partial<Viewing>) => {
      Object.assign(viewing, some);
      changed();
    };
    const [surfaceLabel, surface] = check('view-surface', 'Surface at', (on) => set({ surface: on }));
    this.surface = surface;
    this.level = new Level('level', 'Level of the surface', (level) => set({ level, surface: true }));
    const [bodyRow, body] = choice<Viewing['body']>(
      'view-body',
      'Volume',
      { none: 'not drawn', volume: 'as a cloud', between: 'between two values' },
      (word) => set({ body: word }),
    );
    this.body = body;
    const end = (k: 0 | 1) =>
      new Level(`between-${k}`, k === 0 ? 'Least value of the interval' : 'Greatest value of the interval', (part) => {
        const between: [number, number] = [...viewing.between];
        between[k] = part;
        set({ between: [Math.min(...between), Math.max(...between)], body: 'between' });
      });
    this.ends = [end(0), end(1)];
    this.interval = h(
      'div',
      {},
      ...this.ends.map((level, k) => h('div', { className: 'row wide' }, h('span', {}, k === 0 ? 'from' : 'to'), level.slider, level.box)),
      this.count,
    );
    this.surfaceRow = h('div', { className: 'row wide' }, surfaceLabel, this.level.slider, this.level.box);
    this.element = h(
      'div',
      {},
      this.surfaceRow,
      this.area,
      bodyRow,
      this.interval,
    );
  }

  /** @param shapes those that were made, whatever is asked for now */
  show(field: Field, scale: Scale | null, shapes: Shapes | null): void {
    const { viewing } = this;
    this.element.hidden = !scale;
    // Of what has no volume, samples between two values can be counted all the same.
    const grid = field.parts.some((p) => p.kind === 'grid');
    this.surfaceRow.hidden = !grid;
    this.surface.checked = viewing.surface;
    this.body.value = viewing.body;
    this.interval.hidden = viewing.body !== 'between';
    if (!scale) return;
    const { unit } = field.summary.metric;
    const surfaces = (shapes?.meshes ?? []).filter(({ asked }) => 'level' in asked && asked.of !== 'pinned');
    const area = surfaces.reduce((sum, mesh) => sum + mesh.area, 0);
    this.area.hidden = surfaces.length === 0;
    this.area.dataset.area = String(area);
    this.area.textContent = quantity(area, 'm^2', 4);
    this.level.show(viewing.level, scale, unit);
    this.ends.forEach((level, k) => level.show(viewing.between[k]!, scale, unit));
    if (viewing.body !== 'between') return;
    const [low, high] = endsOf(viewing, scale);
    const { inside, all } = countBetween(field, low ?? -Infinity, high ?? Infinity);
    this.count.dataset.count = String(inside);
    this.count.textContent = `${inside} of ${digits(all, 9)} samples, ${percent(inside / Math.max(1, all))}`;
  }
}
