// Samples without a grid as a surface: by which method, over which plane, how high.
import { h } from '../dom';
import { isScattered, type Field, type Summary } from '../field';
import { counted, percent, quantity, siOf } from '../quantity';
import type { Through, Viewing } from '../viewing';
import { choice } from './details';

export const methods: Record<Through['method'], string> = {
  none: 'no',
  'natural-neighbour': 'natural neighbours',
  linear: 'linear',
  nearest: 'nearest',
  'inverse-distance': 'inverse distance',
  'minimum-curvature': 'minimum curvature',
};

export class ThroughPanel {
  readonly element: HTMLElement;
  private readonly method: HTMLSelectElement;
  private readonly over: HTMLSelectElement;
  private readonly relief: HTMLInputElement;
  private readonly power: HTMLInputElement;
  private readonly radius: HTMLInputElement;
  private readonly how: HTMLElement;
  private readonly weights: HTMLElement;
  private readonly words = h('p', { className: 'hint', id: 'through-words' });

  constructor(
    private readonly viewing: Viewing,
    changed: () => void,
  ) {
    const set = (some: Partial<Through>) => {
      Object.assign(viewing.through, some);
      changed();
    };
    const [methodRow, method] = choice('through-method', 'As a surface', methods, (word) => set({ method: word }));
    const [overRow, over] = choice<Through['over']>('through-over', 'over', { z: 'x and y', y: 'x and z', x: 'y and z' }, (word) => set({ over: word }));
    const text = (id: string, label: string, read: (text: string) => void) => {
      const input = h('input', { type: 'text', id, spellcheck: false, autocomplete: 'off', onchange: () => read(input.value) });
      return [h('div', { className: 'pair' }, h('label', { htmlFor: id }, label), input), input] as const;
    };
    const length = (key: 'relief' | 'radius') => (typed: string) => {
      const value = siOf(typed, 'm');
      if (value >= 0) set({ [key]: value });
      else changed();
    };
    const [reliefRow, relief] = text('through-relief', 'greatest lifted by', length('relief'));
    const [radiusRow, radius] = text('through-radius', 'radius (0: none)', length('radius'));
    const [powerRow, power] = text('through-power', 'power', (typed) => {
      const value = Number(typed);
      if (value >= 1 && value <= 20) set({ power: value });
      else changed();
    });
    [this.method, this.over, this.relief, this.radius, this.power] = [method, over, relief, radius, power];
    this.weights = h('div', {}, powerRow, radiusRow);
    this.how = h('div', {}, overRow, reliefRow, this.weights, this.words);
    this.element = h('div', {}, methodRow, this.how);
  }

  /** @param drawn what is known of the surface */
  show(field: Field, drawn: Summary | null): void {
    const { through } = this.viewing;
    this.element.hidden = !field.parts.some(isScattered);
    this.how.hidden = through.method === 'none';
    this.weights.hidden = through.method !== 'inverse-distance';
    this.method.value = through.method;
    this.over.value = through.over;
    // What is being typed stays.
    const tell = (input: HTMLInputElement, text: string) => document.activeElement === input || (input.value = text);
    tell(this.relief, quantity(through.relief, 'm'));
    tell(this.radius, quantity(through.radius, 'm'));
    tell(this.power, String(through.power));
    const of = drawn?.through;
    if (!of) return void (this.words.textContent = '');
    const { unit } = drawn.metric;
    const range = of.min === null ? 'blind' : `${quantity(of.min, unit)} to ${quantity(of.max!, unit)}`;
    const blind = of.blind > 0 ? `, ${percent(of.blind / of.places)} blind` : '';
    Object.assign(this.words.dataset, { method: of.method, min: of.min ?? '', max: of.max ?? '', places: of.places, blind: of.blind });
    this.words.textContent = `Between ${counted(of.samples, 'sample')}: ${range}${blind}`;
  }
}
