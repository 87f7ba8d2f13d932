// Which colours values have, and how they are written.
import { h } from '../dom';
import type { Field } from '../field';
import { maps, type MapName } from '../maps';
import { quantity, siOf, type Units } from '../quantity';
import type { Viewing } from '../viewing';
import { check, choice } from './details';

export class ColouringPanel {
  readonly element: HTMLElement;
  private readonly logarithmic: HTMLInputElement;
  private readonly reversed: HTMLInputElement;
  private readonly map: HTMLSelectElement;
  private readonly units: HTMLSelectElement;
  private readonly ends: [HTMLInputElement, HTMLInputElement];
  private unit = '1';

  constructor(
    private readonly viewing: Viewing,
    private readonly changed: () => void,
  ) {
    const [logarithmicLabel, logarithmic] = check('view-logarithmic', 'log scale', (on) => this.set({ logarithmic: on }));
    const [reversedLabel, reversed] = check('view-reversed', 'dark is good', (on) => this.set({ reversed: on }));
    const names = Object.fromEntries(Object.keys(maps).map((name) => [name, name])) as Record<MapName, string>;
    const [mapRow, map] = choice<MapName>('view-map', 'Map', names, (name) => this.set({ map: name }));
    const [unitsRow, units] = choice<Units>('view-units', 'Units', { auto: 'with prefixes', si: 'SI', log10: 'log₁₀ of SI' }, (word) =>
      this.set({ units: word }),
    );
    [this.logarithmic, this.reversed, this.map, this.units] = [logarithmic, reversed, map, units];
    this.ends = [this.end('low', 'Colours from'), this.end('high', 'Colours to')];
    this.element = h(
      'div',
      {},
      h('div', { className: 'checks' }, logarithmicLabel, reversedLabel),
      mapRow,
      unitsRow,
      h('div', { className: 'pair' }, h('span', {}, 'Range'), h('span', { className: 'ends' }, ...this.ends)),
    );
  }

  set(some: Partial<Viewing>): void {
    Object.assign(this.viewing, some);
    this.changed();
  }

  show(field: Field): void {
    const { viewing } = this;
    this.unit = field.summary.metric.unit;
    this.logarithmic.checked = viewing.logarithmic;
    this.reversed.checked = viewing.reversed;
    this.map.value = viewing.map;
    this.units.value = viewing.units;
    ([viewing.low, viewing.high] as const).forEach((value, k) => {
      if (document.activeElement !== this.ends[k]) this.ends[k]!.value = value === null ? '' : quantity(value, this.unit, 5);
    });
  }

  /** An end of a range that stays; empty: the field's own. */
  private end(key: 'low' | 'high', label: string): HTMLInputElement {
    const box = h('input', { type: 'text', placeholder: key === 'low' ? 'least' : 'greatest', 'aria-label': label, spellcheck: false, autocomplete: 'off' });
    box.onchange = () => {
      const value = siOf(box.value, this.unit);
      this.set({ [key]: Number.isFinite(value) ? value : null });
    };
    return box;
  }
}
