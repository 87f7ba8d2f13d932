// Plots of a few lines and points, drawn with the colours of the theme.

const space = 'http://www.w3.org/2000/svg';

export function svg<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Record<string, string | number>, ...children: (SVGElement | string)[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS(space, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

export interface Frame {
  width: number;
  height: number;
  x: [number, number];
  y: [number, number];
}

const margin = { left: 4, right: 4, top: 14, bottom: 14 };

/** Where a point of a frame is in its drawing. */
export function placed({ width, height, x, y }: Frame, [px, py]: readonly [number, number]): [number, number] {
  const part = (v: number, [low, high]: [number, number]) => (high > low ? (v - low) / (high - low) : 0.5);
  return [
    margin.left + part(px, x) * (width - margin.left - margin.right),
    height - margin.bottom - part(py, y) * (height - margin.top - margin.bottom),
  ];
}

export const rounded = (at: [number, number]) => at.map((v) => v.toFixed(1)).join(',');

/** Steps from value to value: each holds until the next one. */
export function steps(frame: Frame, points: readonly (readonly [number, number])[], end: number, className: string): SVGPathElement {
  let d = '';
  points.forEach(([x, y], k) => {
    const until = points[k + 1]?.[0] ?? end;
    d += `${k === 0 ? 'M' : 'L'}${rounded(placed(frame, [x, y]))}L${rounded(placed(frame, [until, y]))}`;
  });
  return svg('path', { d, class: className });
}

/** A picture that says in words what it shows. */
export function figure(frame: Frame, label: string, ...children: SVGElement[]): SVGSVGElement {
  const { width, height } = frame;
  return svg('svg', { viewBox: `0 0 ${width} ${height}`, class: 'plot', role: 'img', 'aria-label': label }, ...children);
}

export const note = (x: number, y: number, text: string, anchor: 'start' | 'middle' | 'end' = 'start') =>
  svg('text', { x, y, 'text-anchor': anchor }, text);

/** Ends of a list of numbers, a little apart. */
export function ends(values: number[]): [number, number] {
  const finite = values.filter(Number.isFinite);
  if (finite.length === 0) return [0, 1];
  const [low, high] = [Math.min(...finite), Math.max(...finite)];
  const room = high > low ? 0.04 * (high - low) : Math.abs(high) * 0.02 || 1;
  return [low - room, high + room];
}
