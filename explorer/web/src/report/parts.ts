// What documents are made of: sections, and tables of words and numbers.
import { h } from '../dom';
import { quantity } from '../quantity';

/** A number as it is said, with its value for those who read the page with a program. */
export interface Said {
  text: string;
  value: number | null;
}
export type Cell = string | Node | Said;

const isSaid = (cell: Cell): cell is Said => typeof cell === 'object' && !(cell instanceof Node);

/** @param none what is said where there is no value */
export const said = (value: number | null | undefined, unit: string, count = 3, none = 'none'): Said =>
  value === null || value === undefined || !Number.isFinite(value)
    ? { text: none, value: null }
    : { text: quantity(value, unit, count), value };

export const saidCount = (value: number): Said => ({ text: String(value), value });

/** "+12 %", "−3 %". */
export function saidChange(part: number | null | undefined, none = ''): Said {
  if (part === null || part === undefined || !Number.isFinite(part)) return { text: none, value: null };
  const size = Number((100 * Math.abs(part)).toPrecision(3));
  return { text: size === 0 ? '0 %' : `${part < 0 ? '−' : '+'}${size} %`, value: part };
}

export const verdict = (good: boolean, text: string) => h('span', { className: good ? 'good' : 'bad' }, text);

function cellOf(tag: 'td' | 'th', cell: Cell, name: string): HTMLElement {
  if (!isSaid(cell)) return h(tag, {}, cell);
  return h(tag, { className: 'n', 'data-column': name, 'data-value': cell.value ?? '' }, cell.text);
}

/** A table with a caption; the first cell of a row says what it is about. */
export function table(id: string, caption: string, head: string[], rows: Cell[][]): HTMLElement {
  const numeric = (k: number) => rows.some((row) => isSaid(row[k]!));
  const names = head.map((name, k) => (name === '' ? h('td') : h('th', { scope: 'col', className: numeric(k) ? 'n' : '' }, name)));
  const body = rows.map((row) => {
    const [first, ...rest] = row as [Cell, ...Cell[]];
    const about = h('th', { scope: 'row' }, isSaid(first) ? first.text : first);
    return h('tr', { 'data-row': about.textContent }, about, ...rest.map((cell, k) => cellOf('td', cell, head[k + 1]!)));
  });
  return h(
    'div',
    { className: 'wide', role: 'region', 'aria-label': caption.split('.')[0], tabIndex: 0 },
    h('table', { id }, h('caption', {}, caption), head.some(Boolean) && h('thead', {}, h('tr', {}, ...names)), h('tbody', {}, ...body)),
  );
}

type Child = Node | string | null | false;

export const section = (heading: string, ...content: Child[]) => h('section', { 'aria-label': heading }, h('h2', {}, heading), ...content);
export const paragraph = (text: string, className = '') => h('p', { className }, text);
/** Text as it is written. */
export const listing = (label: string, text: string) => h('pre', { tabIndex: 0, role: 'region', 'aria-label': label }, text);
