// One device more: of any plugin, or one that can be bought.
import { h, iconButton } from '../dom';
import type { Palette } from '../server';

export type Add = (type: string, preset: string) => void;

export class AddDevice {
  readonly element: HTMLDialogElement;
  private readonly grid = h('div', { className: 'scenes types' });

  constructor(private readonly add: Add) {
    this.element = h(
      'dialog',
      { className: 'start', 'aria-label': 'Add a device' },
      iconButton('close', 'Close', () => this.element.close()),
      h('h1', {}, 'Add a device'),
      h('p', { className: 'lead' }, 'It stands at the chosen point, or above the middle of the samples, and looks at their middle. What it needs to know has first values, which you then change.'),
      this.grid,
    );
  }

  show({ types, presets }: Palette): void {
    this.grid.replaceChildren(
      ...types.map(({ id, summary, ready }) =>
        h(
          'div',
          { className: 'type-card' },
          this.button(id, '', id.replaceAll('_', ' '), summary, ready),
          ...presets.filter((p) => p.type === id).map((p) => this.button(id, p.name, p.name, p.source, true)),
        ),
      ),
    );
    if (!this.element.open) this.element.showModal();
    this.grid.querySelector('button')?.focus();
  }

  private button(type: string, preset: string, name: string, about: string, ready: boolean): HTMLButtonElement {
    return h(
      'button',
      {
        type: 'button',
        className: preset ? 'preset' : '',
        disabled: !ready,
        title: about,
        'data-type': type,
        'data-preset': preset,
        onclick: () => {
          this.element.close();
          this.add(type, preset);
        },
      },
      h('b', {}, name),
      preset ? null : h('span', {}, about),
    );
  }
}
