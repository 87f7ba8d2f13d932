// What the room is made of, and all else that a scene says beside its devices.
import { h, iconButton } from '../dom';
import type { Box, FormField } from '../server';
import { SceneForm, type FormActions } from './sceneform';

/** What a rectangle that is drawn becomes. */
export type Painted = 'region' | 'occluder' | 'samples';

export interface RoomActions extends FormActions {
  paint: (what: Painted) => void;
  close: () => void;
}

const painted: Record<Painted, string> = { region: 'a region', occluder: 'an occluder', samples: 'a set of samples' };

/** They stand in the search. */
const ofSearches = ['objective', 'constraints', 'selection'];

export class RoomPanel {
  readonly element: HTMLElement;
  private readonly form: SceneForm;
  private readonly what: HTMLSelectElement;

  constructor(actions: RoomActions) {
    this.form = new SceneForm(actions);
    this.what = h('select', { id: 'paint-what', 'aria-label': 'What to draw' }, ...Object.entries(painted).map(([value, text]) => h('option', { value }, text)));
    const draw = h('button', { type: 'button', id: 'paint', title: 'Drag a rectangle on the slice across z, or on the floor (Shift B)', onclick: () => actions.paint(this.chosen) }, 'Draw');
    this.element = h(
      'section',
      { className: 'panel grow room-panel', id: 'room', hidden: true, 'aria-label': 'The room', tabIndex: 0 },
      h('header', {}, h('h2', {}, 'Room'), iconButton('close', 'Close the room (W)', actions.close)),
      h('div', { className: 'vary' }, this.what, draw),
      this.form.element,
    );
  }

  get open(): boolean {
    return !this.element.hidden;
  }
  get chosen(): Painted {
    return this.what.value as Painted;
  }

  show(sections: FormField[], room: Box): void {
    this.form.show(sections.filter((s) => !ofSearches.includes(s.path)), room);
  }

  reveal(path: string): void {
    this.form.reveal(path);
  }
}
