// Slices and planes as surfaces that are as high as their values.
import { h } from '../dom';
import { quantity } from '../quantity';
import type { Viewing } from '../viewing';
import { check } from './details';

export class ReliefPanel {
  readonly element: HTMLElement;
  private readonly raised: HTMLInputElement;
  private readonly size: HTMLInputElement;
  private readonly text = h('output', {});

  constructor(
    private readonly viewing: Viewing,
    changed: () => void,
  ) {
    const [label, raised] = check('view-relief', 'Heights', (on) => {
      viewing.relief = on;
      changed();
    });
    this.raised = raised;
    this.size = h('input', { type: 'range', min: '-1', max: '1', step: '0.02', id: 'relief-size', 'aria-label': 'How high the end of the bar is' });
    this.size.oninput = () => {
      Object.assign(viewing, { relief: true, reliefPart: Number(this.size.value) });
      changed();
    };
    this.element = h('div', { className: 'row wide' }, label, this.size, this.text);
  }

  /** @param size of the room, metres @param flat whether anything is there to be raised */
  show(size: number, flat: boolean): void {
    const { viewing } = this;
    this.element.hidden = !flat;
    this.raised.checked = viewing.relief;
    this.size.value = String(viewing.reliefPart);
    const text = quantity(viewing.reliefPart * size, 'm', 2);
    this.text.textContent = text;
    this.size.setAttribute('aria-valuetext', text);
  }
}
