// Which scene? One click opens it.
import { h, iconButton } from '../dom';
import type { SceneList } from '../server';

export class Start {
  readonly element: HTMLDialogElement;
  private readonly grid = h('div', { className: 'scenes' });

  constructor(private readonly open: (id: string) => void) {
    this.element = h(
      'dialog',
      { className: 'start', 'aria-label': 'Choose a scene' },
      iconButton('close', 'Close', () => this.element.close()),
      h('h1', {}, 'Delos'),
      h(
        'p',
        { className: 'lead' },
        'The best accuracy that any algorithm could reach with a tracking system, throughout its room. Choose one to begin with.',
      ),
      this.grid,
    );
  }

  show(list: SceneList): void {
    this.grid.replaceChildren(
      ...list.scenes.map(({ id, about }) =>
        h(
          'button',
          {
            type: 'button',
            'data-scene': id,
            onclick: () => {
              this.element.close();
              this.open(id);
            },
          },
          h('b', {}, id.replace(/^(.*\/)?\d+-/, '$1').replaceAll('-', ' ')),
          h('span', {}, about),
        ),
      ),
    );
    if (!this.element.open) this.element.showModal();
    this.grid.querySelector('button')?.focus();
  }
}
