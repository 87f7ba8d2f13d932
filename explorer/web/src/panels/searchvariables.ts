// What a search may change: variables with their bounds and locks.
import { h, iconButton } from '../dom';
import { quantity, typed } from '../quantity';
import type { Device, DeviceType } from '../server';
import type { Task } from '../searching';

type Variable = Task['variables'][number];

export interface VariableActions {
  /** Make numbers variables, or give a variable other bounds: quantities, as scenes write them. */
  vary: (body: { path: string; lower?: string; upper?: string }) => void;
  fix: (path: string) => void;
  /** A variable, or "devices.NAME" for all of a device's. */
  lock: (path: string, locked: boolean) => void;
}

const ownerOf = (path: string) => path.split('.').slice(0, 2).join('.');

/** What of a device can be a variable, as paths from the device on. */
function numbersOf(device: Device, type: DeviceType | undefined): string[] {
  const place = device.surface ? ['coordinates'] : ['at'];
  const facing = device.facing ? [device.facing] : [];
  const params = (type?.params ?? []).filter((p) => p.kind === 'number').map((p) => `params.${p.name}`);
  return [...place, ...facing, ...params, 'rate'];
}

export class SearchVariables {
  readonly element: HTMLElement;
  private readonly list = h('div', { className: 'variables' });
  private readonly whose = h('select', { id: 'vary-whose', 'aria-label': 'Whose number may change' });
  private readonly what = h('select', { id: 'vary-what', 'aria-label': 'Which number may change' });
  private shown = '';

  constructor(private readonly actions: VariableActions) {
    this.element = h(
      'section',
      { className: 'search-column', 'aria-label': 'What may change' },
      h('h3', {}, 'What may change'),
      this.list,
      h(
        'form',
        {
          className: 'vary',
          onsubmit: (event: Event) => {
            event.preventDefault();
            actions.vary({ path: `${this.whose.value}.${this.what.value}` });
          },
        },
        this.whose,
        this.what,
        h('button', { type: 'submit', id: 'vary' }, 'Let it change'),
      ),
    );
  }

  /** Whose numbers are offered. */
  offer(device: Device | null, type: DeviceType | undefined, all: Device[], types: Record<string, DeviceType>): void {
    const of = device ?? all[0];
    if (!of) return;
    const before = this.what.value;
    const alike = all.filter((d) => d.type === of.type).length > 1;
    this.whose.replaceChildren(
      h('option', { value: `devices.${of.name}` }, of.name),
      ...(alike ? [h('option', { value: 'devices.*' }, 'all devices')] : []),
    );
    const numbers = numbersOf(of, type ?? types[of.type]);
    this.what.replaceChildren(...numbers.map((n) => h('option', { value: n }, n.replace('params.', ''))));
    if (numbers.includes(before)) this.what.value = before;
  }

  /** @param locked paths */
  show(task: Task, locked: string[]): void {
    const now = JSON.stringify([task.variables, locked]);
    if (now === this.shown) return;
    const { activeElement } = document;
    const focused = this.list.contains(activeElement) ? activeElement!.id : '';
    this.shown = now;
    const owners = [...new Set(task.variables.map((v) => ownerOf(v.path)))];
    this.list.replaceChildren(
      ...owners.map((owner) => this.group(owner, task.variables.filter((v) => ownerOf(v.path) === owner), locked)),
      ...(owners.length === 0 ? [h('p', { className: 'hint' }, 'Nothing may change yet: choose a number below.')] : []),
    );
    if (focused) document.getElementById(focused)?.focus();
  }

  private group(owner: string, variables: Variable[], locked: string[]): HTMLElement {
    const isLocked = (v: Variable) => locked.includes(v.path);
    const all = variables.every(isLocked);
    return h(
      'fieldset',
      { className: 'owner', 'data-owner': owner },
      h('legend', {}, this.check(owner, all, `Lock all of ${owner.split('.')[1]}`), h('b', {}, owner.split('.')[1] ?? owner)),
      ...variables.map((v) => this.row(v, isLocked(v))),
    );
  }

  private check(path: string, on: boolean, label: string): HTMLInputElement {
    const box = h('input', {
      type: 'checkbox',
      id: `lock ${path}`,
      checked: on,
      title: label,
      'aria-label': label,
      'data-lock': path,
      onchange: () => this.actions.lock(path, box.checked),
    });
    return box;
  }

  private row(v: Variable, locked: boolean): HTMLElement {
    const name = v.path.split('.').slice(2).join('.').replace(/^(params|at)\./, '').replace('coordinates.', 'on it ');
    const bound = (key: 'lower' | 'upper', word: string) => {
      const text = v[key] === null ? '' : typed(v[key], v.unit);
      const box = h('input', { type: 'text', id: `${key} ${v.path}`, value: text, defaultValue: text, 'aria-label': `${word} of ${v.path}`, autocomplete: 'off', spellcheck: false });
      box.onchange = () => this.actions.vary({ path: v.path, [key]: box.value });
      return box;
    };
    return h(
      'div',
      { className: locked ? 'variable locked' : 'variable', 'data-variable': v.path },
      this.check(v.path, locked, `Lock ${v.path}`),
      h('span', { className: 'name', title: v.followers > 0 ? `${v.path}, which ${v.followers} more follow` : v.path }, name),
      bound('lower', 'Least value'),
      h('output', {}, v.value === null ? '' : quantity(v.value, v.unit)),
      bound('upper', 'Greatest value'),
      iconButton('close', `${v.path} may not change any more`, () => this.actions.fix(v.path)),
    );
  }
}
