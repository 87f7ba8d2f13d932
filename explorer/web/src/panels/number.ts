// A number as a slider and a text box.
import { h } from '../dom';
import { newGesture } from '../gesture';
import { displayUnit, quantity, typed, type DisplayUnit } from '../quantity';

export interface NumberSpec {
  label: string;
  help: string;
  unit: string;
  lower: number | null;
  upper: number | null;
  logarithmic: boolean;
  /** Which unit it is shown in; by default what reads best. */
  display?: DisplayUnit;
  /** @param text as a scene would write it @param gesture alike while one drag lasts */
  set: (text: string, gesture: string) => void;
}

let ids = 0;
const steps = 1000;

/** Where the slider runs from and to: the bounds of the number, but not farther from where
 * it begins than a hand can steer. */
function reach(spec: NumberSpec, value: number): { low: number; high: number; log: boolean } {
  const lower = spec.lower ?? -Infinity;
  const upper = spec.upper ?? Infinity;
  if (!spec.logarithmic) {
    const around = Math.max(1, 2 * Math.abs(value));
    return {
      low: Number.isFinite(lower) ? lower : value - around,
      high: Number.isFinite(upper) ? upper : value + around,
      log: false,
    };
  }
  if (!(value > 0)) return { low: Math.max(lower, 0), high: Math.min(upper, 1), log: false };
  return { low: Math.max(lower, value / 8), high: Math.min(upper, value * 8), log: true };
}

export class NumberField {
  readonly element: HTMLElement;
  private readonly slider: HTMLInputElement;
  private readonly box: HTMLInputElement;
  private readonly range: ReturnType<typeof reach>;
  private readonly as: (si: number) => DisplayUnit;
  private gesture = '';
  private sent = '';

  constructor(
    private readonly spec: NumberSpec,
    private value: number,
  ) {
    this.range = reach(spec, value);
    const id = `number-${++ids}`;
    const { low, high } = this.range;
    const ends = `${quantity(low, spec.unit)} to ${quantity(high, spec.unit)}`;
    this.as = (si) => spec.display ?? displayUnit(si, spec.unit);
    this.slider = h('input', {
      type: 'range',
      min: '0',
      max: String(steps),
      step: '1',
      'aria-label': `${spec.label}, ${ends}`,
      title: ends,
      oninput: () => this.slide(),
      onchange: () => (this.gesture = ''),
    });
    this.box = h('input', {
      type: 'text',
      id,
      spellcheck: false,
      autocomplete: 'off',
      onchange: () => this.type(),
      onkeydown: (event: KeyboardEvent) => {
        if (event.key === 'Escape') this.reset();
      },
    });
    this.element = h(
      'div',
      { className: 'number' },
      h('label', { htmlFor: id, title: spec.help }, spec.label),
      this.slider,
      this.box,
    );
    this.show();
  }

  update(value: number): void {
    this.value = value;
    this.show();
  }

  private shown(): string {
    return typed(this.value, this.spec.unit, this.as(this.value));
  }

  private show(): void {
    const { low, high, log } = this.range;
    const part = log
      ? Math.log(this.value / low) / Math.log(high / low)
      : (this.value - low) / (high - low);
    // A hand on the slider is ahead of what the server knows.
    if (this.gesture === '') this.slider.value = String(Math.round(steps * part));
    // What is being typed stays; what was sent has its answer now.
    const { box } = this;
    const typing = document.activeElement === box && box.value !== box.defaultValue;
    if (!typing || box.value.trim() === this.sent) this.reset();
    this.slider.setAttribute('aria-valuetext', quantity(this.value, this.spec.unit, 4));
  }

  private reset(): void {
    this.sent = '';
    this.box.value = this.box.defaultValue = this.shown();
  }

  private slide(): void {
    if (this.gesture === '') this.gesture = newGesture();
    const { low, high, log } = this.range;
    const part = Number(this.slider.value) / steps;
    const exact = log ? low * (high / low) ** part : low + part * (high - low);
    // Four digits are as fine as the slider is.
    const value = Math.min(high, Math.max(low, Number(exact.toPrecision(4))));
    this.value = value;
    this.reset();
    this.spec.set(String(value), this.gesture);
  }

  private type(): void {
    const text = this.box.value.trim();
    if (text === '') this.reset();
    else {
      this.sent = text;
      this.spec.set(text, '');
    }
  }
}
