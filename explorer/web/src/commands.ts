// Everything that can be done without a mouse, by its name and its keys.
export interface Command {
  name: string;
  /** "ctrl+z", "shift+m", "g"; the first is shown. */
  keys: string[];
  run: () => void;
  /** Whether it can be done now; by default it can. */
  ready?: () => boolean;
}

/** A key as commands name it. */
export function keyOf(event: KeyboardEvent): string {
  const key = event.key.toLowerCase();
  const shift = event.shiftKey && (key.length > 1 || /[a-z]/.test(key));
  return `${event.ctrlKey || event.metaKey ? 'ctrl+' : ''}${event.altKey ? 'alt+' : ''}${shift ? 'shift+' : ''}${key}`;
}

/** "Ctrl Z" of "ctrl+z". */
export const shownKey = (key: string) =>
  key.split('+').filter(Boolean).map((part) => part[0]!.toUpperCase() + part.slice(1)).join(' ') || key;

/** Letters in a text are the text's, and so is undoing what is typed. */
const typingIn = (target: EventTarget | null) =>
  (target instanceof HTMLInputElement && target.type === 'text') || target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;

/** Listen for the keys of commands.
 * @param first asked before them: true where it took the key */
export function listenForKeys(commands: Command[], first: (event: KeyboardEvent) => boolean): void {
  document.addEventListener('keydown', (event) => {
    if (document.querySelector('dialog[open]')) return;
    const { target } = event;
    const typing = typingIn(target);
    const edited = target instanceof HTMLInputElement && typing && target.value !== target.defaultValue;
    const key = keyOf(event);
    if (typing && (edited || !key.startsWith('ctrl+'))) return;
    if (!typing && first(event)) return event.preventDefault();
    const command = commands.find((c) => c.keys.includes(key) && (c.ready?.() ?? true));
    if (!command) return;
    event.preventDefault();
    command.run();
  });
}
