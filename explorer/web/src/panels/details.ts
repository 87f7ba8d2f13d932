// A part of a panel that opens and closes.
import { h } from '../dom';

type Child = Node | string;

export const details = (title: string, open: boolean, ...children: Child[]) =>
  h('details', { open, className: 'part' }, h('summary', {}, title), ...children);

/** A check box with its label. */
export function check(id: string, text: string, onchange: (checked: boolean) => void): [HTMLLabelElement, HTMLInputElement] {
  const box = h('input', { type: 'checkbox', id, onchange: () => onchange(box.checked) });
  return [h('label', { htmlFor: id }, box, text), box];
}

/** One of a few words. */
export function choice<Word extends string>(
  id: string,
  label: string,
  words: Record<Word, string>,
  onchange: (word: Word) => void,
): [HTMLElement, HTMLSelectElement] {
  const select = h(
    'select',
    { id, onchange: () => onchange(select.value as Word) },
    ...Object.entries<string>(words).map(([value, text]) => h('option', { value }, text)),
  );
  return [h('div', { className: 'pair' }, h('label', { htmlFor: id }, label), select), select];
}
