// All commands by name, and any value of the scene by its path.
import type { Command } from '../commands';
import { shownKey } from '../commands';
import { h } from '../dom';
import type { Setting } from '../server';

/** "sample.volume.step = 1 cm" as a setting; null where it is none. */
export function settingOf(text: string): Setting | null {
  const match = /^\s*([\w.*+-][^=]*?)\s*=\s*(.+?)\s*$/.exec(text);
  return match ? { path: match[1]!, value: match[2]! } : null;
}

export class CommandPalette {
  readonly element: HTMLDialogElement;
  private readonly box: HTMLInputElement;
  private readonly list = h('ul', { className: 'commands', role: 'listbox', id: 'commands', 'aria-label': 'Commands' });
  private found: Command[] = [];
  private chosen = 0;

  constructor(
    private readonly commands: Command[],
    private readonly set: (setting: Setting) => void,
  ) {
    this.box = h('input', {
      type: 'text',
      placeholder: 'A command, or PATH = VALUE of the scene',
      'aria-label': 'Command',
      'aria-controls': 'commands',
      role: 'combobox',
      'aria-expanded': 'true',
      spellcheck: false,
      autocomplete: 'off',
      oninput: () => this.search(),
      onkeydown: (event: KeyboardEvent) => this.key(event),
    });
    this.element = h('dialog', { className: 'command', 'aria-label': 'Commands' }, this.box, this.list);
  }

  show(): void {
    this.box.value = '';
    this.search();
    this.element.showModal();
    this.box.focus();
  }

  private search(): void {
    const words = this.box.value.toLowerCase().split(/\s+/).filter(Boolean);
    const setting = settingOf(this.box.value);
    this.found = setting
      ? [{ name: `Set ${setting.path} to ${setting.value}`, keys: [], run: () => this.set(setting) }]
      : this.commands.filter((c) => (c.ready?.() ?? true) && words.every((w) => c.name.toLowerCase().includes(w)));
    this.chosen = 0;
    this.render();
  }

  private render(): void {
    this.list.replaceChildren(
      ...this.found.map((command, k) =>
        h(
          'li',
          {
            role: 'option',
            id: `command-${k}`,
            'aria-selected': String(k === this.chosen),
            onclick: () => this.run(command),
          },
          h('span', {}, command.name),
          h('kbd', {}, command.keys[0] ? shownKey(command.keys[0]) : ''),
        ),
      ),
    );
    this.box.setAttribute('aria-activedescendant', this.found.length > 0 ? `command-${this.chosen}` : '');
    this.list.children[this.chosen]?.scrollIntoView({ block: 'nearest' });
  }

  private key(event: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step && this.found.length > 0) {
      this.chosen = (this.chosen + step + this.found.length) % this.found.length;
      this.render();
    } else if (event.key === 'Enter' && this.found[this.chosen]) {
      this.run(this.found[this.chosen]!);
    } else return;
    event.preventDefault();
  }

  private run(command: Command): void {
    this.element.close();
    command.run();
  }
}
