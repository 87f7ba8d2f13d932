// A device more times: along a row, or around a circle.
import { h, iconButton } from '../dom';
import { siOf } from '../quantity';
import type { Description, Vec3 } from '../server';
import { middle } from '../viewing';

/** As the server takes it. */
export type DeviceArray = { copies: number; by: Vec3 } | { copies: number; around: Vec3 };

const axes = ['x', 'y', 'z'];

export class ArrayOfDevices {
  readonly element: HTMLDialogElement;
  private readonly title = h('h2');
  private readonly copies = h('input', { type: 'text', id: 'array-copies', inputMode: 'numeric' });
  private readonly circle = h('input', { type: 'checkbox', id: 'array-circle', onchange: () => this.begin() });
  private readonly words = h('p', { className: 'hint' });
  private readonly numbers = axes.map((axis) => h('input', { type: 'text', className: 'level', 'aria-label': axis, spellcheck: false }));
  private readonly problem = h('p', { className: 'hint', role: 'alert' });
  private description: Description | null = null;

  constructor(private readonly make: (array: DeviceArray) => void) {
    const form = h(
      'form',
      { method: 'dialog', onsubmit: (event: Event) => this.submit(event) },
      this.title,
      h('div', { className: 'pair' }, h('label', { htmlFor: 'array-copies' }, 'Copies'), this.copies),
      h('label', { htmlFor: 'array-circle' }, this.circle, 'around a circle'),
      this.words,
      h('div', { className: 'row wide' }, ...this.numbers),
      this.problem,
      h('button', { type: 'submit' }, 'Make them'),
    );
    this.element = h('dialog', { className: 'help', 'aria-label': 'Array of devices' }, iconButton('close', 'Close', () => this.element.close()), form);
  }

  show(description: Description, device: string): void {
    this.description = description;
    this.title.textContent = `${device}, more times`;
    this.copies.value = '3';
    this.circle.checked = false;
    this.begin();
    this.element.showModal();
    this.copies.select();
  }

  private begin(): void {
    const around = this.circle.checked;
    this.words.textContent = around
      ? 'Evenly around the upright axis through this point, each turned with it:'
      : 'Each so far from the one before:';
    const { box } = this.description!;
    const first = around ? middle(box) : [1, 0, 0];
    this.numbers.forEach((input, k) => (input.value = `${Number(first[k]!.toFixed(3))} m`));
    this.problem.textContent = '';
  }

  private submit(event: Event): void {
    event.preventDefault();
    const at = this.numbers.map((input) => siOf(input.value, 'm')) as Vec3;
    const copies = Number(this.copies.value);
    if (!at.every(Number.isFinite)) this.problem.textContent = 'Lengths are such as 0.5 m or 20 cm.';
    else if (!Number.isInteger(copies) || copies < 1) this.problem.textContent = 'Copies are a whole number from 1 on.';
    else {
      this.element.close();
      this.make(this.circle.checked ? { copies, around: at } : { copies, by: at });
    }
  }
}
