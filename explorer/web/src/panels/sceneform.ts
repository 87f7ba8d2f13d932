// Values of a scene as fields, whatever they are: the server says kind, unit and bounds of each.
import { h, iconButton } from '../dom';
import type { Act, Box, Setting, FormField } from '../server';
import { NumberField } from './number';

export interface FormActions {
  edit: (set: Setting[], gesture: string) => void;
  copyPart: (path: string) => void;
  renamePart: (path: string, name: string) => void;
  /** A part was opened. */
  open: (path: string) => void;
}

interface Shown {
  element: HTMLElement;
  update: (field: FormField) => void;
}

const metres = { name: 'm', factor: 1 };

/** What of a field its elements depend on; its value alone doesn't count. */
const structure = (field: FormField): unknown => [field.path, field.kind, field.known, field.add?.map((a) => a.path + a.label), field.members?.map(structure)];

/** What a member is made of is open with it. */
const isInner = (field: FormField) => field.path.split('.').length > 2 && !field.copy;

let ids = 0;

export class SceneForm {
  readonly element = h('div', { className: 'form' });
  private readonly opened = new Set<string>();
  private shown: Shown[] = [];
  private key = '';
  private room: Box = { min: [0, 0, 0], max: [1, 1, 1] };

  constructor(private readonly actions: FormActions) {}

  /** @param sections that are shown @param room how far sliders of places reach */
  show(sections: FormField[], room: Box): void {
    this.room = room;
    const key = JSON.stringify(sections.map(structure));
    if (key === this.key) return sections.forEach((section, k) => this.shown[k]!.update(section));
    this.key = key;
    const focused = this.element.contains(document.activeElement) ? document.activeElement!.getAttribute('data-field') : null;
    this.shown = sections.map((section) => this.field(section));
    this.element.replaceChildren(...this.shown.map((s) => s.element));
    if (focused) this.element.querySelector<HTMLElement>(`[data-field="${CSS.escape(focused)}"]`)?.focus();
  }

  /** Open a part and all that it is in. */
  reveal(path: string): void {
    const parts = path.split('.');
    parts.forEach((_, k) => this.opened.add(parts.slice(0, k + 1).join('.')));
    for (const details of this.element.querySelectorAll<HTMLDetailsElement>('details[data-part]')) {
      if (this.opened.has(details.dataset.part!)) details.open = true;
      if (details.dataset.part === path) details.scrollIntoView({ block: 'nearest' });
    }
  }

  private field(field: FormField): Shown {
    switch (field.kind) {
      case 'number':
      case 'integer':
        return field.value === null ? this.text(field) : this.number(field);
      case 'choice':
        return this.choice(field);
      case 'group':
        return this.group(field);
      case 'many':
        return { element: h('p', { className: 'hint' }, `${field.name}: ${field.value} of them, too many to be shown`), update: () => {} };
      default:
        return this.text(field);
    }
  }

  private set(field: FormField, value: string, gesture = ''): void {
    this.actions.edit([{ path: field.path, value }], gesture);
  }

  private number(field: FormField): Shown {
    const value = field.value as number;
    const place = field.unit === 'm' && /\.[xyz]$/.test(field.path);
    const size = Math.max(...this.room.max.map((x, k) => x - this.room.min[k]!), 1e-3);
    const whole = field.kind === 'integer';
    const shown = new NumberField(
      {
        label: field.name,
        help: field.help,
        unit: field.unit!,
        lower: field.lower ?? (place ? value - size / 2 : null),
        upper: field.upper ?? (place ? value + size / 2 : null),
        logarithmic: field.lower === 0 && field.upper === null && !whole,
        ...(place ? { display: metres } : {}),
        set: (text, gesture) => this.set(field, whole && gesture ? String(Math.round(Number(text))) : text, gesture),
      },
      value,
    );
    return { element: this.removable(field, shown.element), update: (f) => shown.update(f.value as number) };
  }

  private choice(field: FormField): Shown {
    const id = `form-${++ids}`;
    const select = h('select', { id, 'data-field': field.path, onchange: () => this.set(field, select.value) }, ...field.words!.map((word) => h('option', { value: word }, word)));
    const update = (f: FormField) => (select.value = String(f.value));
    update(field);
    return { element: this.row(field, id, select), update };
  }

  private text(field: FormField): Shown {
    const id = `form-${++ids}`;
    const known = field.known ?? [];
    const input = h('input', { type: 'text', id, 'data-field': field.path, spellcheck: false, autocomplete: 'off', onchange: () => this.set(field, input.value) });
    const update = (f: FormField) => {
      if (document.activeElement === input && input.value !== input.defaultValue && input.value !== String(f.value)) return;
      input.value = input.defaultValue = String(f.value ?? '');
    };
    update(field);
    if (known.length === 0) return { element: this.row(field, id, input), update };
    input.setAttribute('list', `${id}-known`);
    const names = h('datalist', { id: `${id}-known` }, ...known.map((value) => h('option', { value })));
    return { element: this.row(field, id, input, names), update };
  }

  private row(field: FormField, id: string, ...inputs: HTMLElement[]): HTMLElement {
    const label = h('label', { htmlFor: id, title: field.help }, field.name);
    return this.removable(field, h('div', { className: 'number wide' }, label, ...inputs));
  }

  /** What may be left out can be taken away. */
  private removable(field: FormField, element: HTMLElement): HTMLElement {
    const { remove } = field;
    if (!remove) return element;
    return h('div', { className: 'removable' }, element, iconButton('close', `Leave out ${field.path}`, () => this.actions.edit([remove], '')));
  }

  private group(field: FormField): Shown {
    const members = (field.members ?? []).map((member) => this.field(member));
    const update = (f: FormField) => members.forEach((m, k) => m.update(f.members![k]!));
    const inner = [this.doings(field), ...members.map((m) => m.element), this.adding(field)].filter((x) => x !== null);
    // Components of a place are lines of what they are in.
    const vector = members.length > 0 && members.length <= 4 && field.members!.every((m) => m.kind === 'number');
    if (vector && !field.rename)
      return { element: h('fieldset', { className: 'vector' }, h('legend', { title: field.help }, field.name), ...inner), update };
    const details = h(
      'details',
      {
        className: 'part',
        open: this.opened.has(field.path) || isInner(field),
        'data-part': field.path,
        ontoggle: () => {
          if (details.open === this.opened.has(field.path)) return;
          if (details.open) this.opened.add(field.path);
          else this.opened.delete(field.path);
          if (details.open) this.actions.open(field.path);
        },
      },
      h('summary', { title: field.help }, field.name),
      ...inner,
    );
    return { element: details, update };
  }

  /** What is done with a member as a whole. */
  private doings(field: FormField): HTMLElement | null {
    const { actions } = this;
    const { path, remove } = field;
    if (!remove && !field.copy && !field.rename) return null;
    if (remove && !field.copy && !field.rename) return iconButton('close', `Leave out ${path}`, () => actions.edit([remove], ''), 'icon leave');
    const name = h('input', { type: 'text', value: field.name, defaultValue: field.name, 'aria-label': `Name of ${path}`, spellcheck: false, autocomplete: 'off', onchange: () => actions.renamePart(path, name.value) });
    const button = (text: string, title: string, onclick: () => void) => h('button', { type: 'button', title, 'aria-label': title, onclick }, text);
    return h(
      'div',
      { className: 'actions', role: 'group', 'aria-label': path },
      field.rename ? name : null,
      field.copy ? button('Copy', `Copy ${path}`, () => actions.copyPart(path)) : null,
      remove ? button('Remove', `Remove ${path}`, () => actions.edit([remove], '')) : null,
    );
  }

  private adding(field: FormField): HTMLElement | null {
    const add = field.add ?? [];
    if (add.length === 0) return null;
    const what = h('select', { 'aria-label': `What to add to ${field.path}`, 'data-field': `${field.path} add` }, ...add.map((a, k) => h('option', { value: String(k), title: a.help }, a.label)));
    return h(
      'form',
      {
        className: 'vary',
        onsubmit: (event: Event) => {
          event.preventDefault();
          const act = add[Number(what.value)] as Act;
          this.opened.add(field.path);
          this.opened.add(act.path);
          this.actions.edit([{ path: act.path, value: act.value }], '');
        },
      },
      what,
      h('button', { type: 'submit', 'aria-label': `Add to ${field.path}` }, 'Add'),
    );
  }
}
