// Which number's influence on the metric is shown.
import { h } from '../dom';
import type { Description } from '../server';
import type { Viewing } from '../viewing';

/** Numbers of a device, as paths. */
function numbersOf(description: Description, name: string | null): string[] {
  const device = description.devices.find((d) => d.name === name) ?? description.devices[0];
  if (!device) return [];
  const path = `devices.${device.name}`;
  const numbers = description.types[device.type]!.params.filter(({ kind }) => kind === 'number');
  const places = device.coordinates ? [] : ['x', 'y', 'z'].map((axis) => `${path}.at.${axis}`);
  return [...numbers.map((p) => `${path}.params.${p.name}`), ...places, `${path}.rate`];
}

export class SensitivityPanel {
  readonly element: HTMLElement;
  private readonly path: HTMLInputElement;
  /** What is being typed stays. */
  private typing = false;
  private readonly known = h('datalist', { id: 'sensitivity-numbers' });

  constructor(
    private readonly viewing: Viewing,
    changed: () => void,
  ) {
    this.path = h('input', {
      id: 'sensitivity',
      type: 'text',
      spellcheck: false,
      autocomplete: 'off',
      placeholder: 'devices.NAME.at.z',
      title: 'How much the metric rises with a number: its path, or one of the chosen device; empty: the metric itself',
      oninput: () => (this.typing = true),
      onchange: () => {
        this.typing = false;
        viewing.sensitivity = this.path.value.trim();
        changed();
      },
    });
    this.path.setAttribute('list', 'sensitivity-numbers');
    this.element = h('div', { className: 'pair' }, h('label', { htmlFor: 'sensitivity' }, 'Slope'), this.path, this.known);
  }

  show(description: Description, selected: string | null): void {
    if (!this.typing) this.path.value = this.viewing.sensitivity;
    const paths = numbersOf(description, selected);
    if (this.known.dataset.paths === paths.join()) return;
    this.known.dataset.paths = paths.join();
    this.known.replaceChildren(...paths.map((value) => h('option', { value })));
  }
}
