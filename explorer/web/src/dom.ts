// Elements in one expression.

type Child = Node | string | null | false;

/** An element with properties, listeners ("onclick") and attributes ("aria-…", "data-…"). */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Record<string, unknown> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (value === undefined || value === null) continue;
    if (/^(aria-|data-|role$|for$)/.test(key)) element.setAttribute(key, String(value));
    else (element as unknown as Record<string, unknown>)[key] = value;
  }
  element.append(...children.filter((c): c is Node | string => c !== null && c !== false));
  return element;
}

/** Icons of 16 by 16, drawn with lines. */
const paths: Record<string, string> = {
  undo: 'M5 3 2 6l3 3M2 6h7a4 4 0 0 1 0 8H6',
  redo: 'M11 3l3 3-3 3M14 6H7a4 4 0 0 0 0 8h3',
  save: 'M8 2v8M5 7l3 3 3-3M2 12v2h12v-2',
  open: 'M2 13V3h4l2 2h6v8z',
  theme: 'M8 2a6 6 0 1 0 0 12zM8 2a6 6 0 0 1 0 12',
  help: 'M6 6a2 2 0 1 1 2.6 1.9c-.4.2-.6.5-.6 1.1v.5M8 12v.5',
  move: 'M8 1v14M1 8h14M8 1 6 3M8 1l2 2M8 15l-2-2M8 15l2-2M1 8l2-2M1 8l2 2M15 8l-2-2M15 8l-2 2',
  turn: 'M13 5A6 6 0 1 0 14 9M13 1v4H9',
  fit: 'M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4',
  close: 'M3 3l10 10M13 3 3 13',
};

export function icon(name: keyof typeof paths): SVGSVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', paths[name]!);
  svg.append(path);
  return svg;
}

/** A button that is an icon with a name. */
export function iconButton(
  name: keyof typeof paths,
  label: string,
  onclick: () => void,
  className = 'icon',
): HTMLButtonElement {
  return h(
    'button',
    { type: 'button', className, title: label, 'aria-label': label, onclick },
    icon(name),
  );
}
