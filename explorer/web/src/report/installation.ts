// What somebody who hangs up the devices needs: a table, and a drawing of it.
import { h } from '../dom';
import { note, svg } from '../panels/plot';
import { Scale } from '../scale';
import type { Box, Vec3 } from '../server';
import type { Installation } from './frozen';
import { paragraph, table, type Cell } from './parts';

const metres = (value: number) => (Math.abs(value) < 5e-4 ? 0 : value).toFixed(3);
const place = (p: Vec3) => p.map(metres).join(', ');
const degrees = (angle: number | null): Cell => (angle === null ? '' : { text: `${((angle * 180) / Math.PI).toFixed(1)}°`, value: angle });

/** One view: what goes right and what goes up, metres. */
interface View {
  title: string;
  axes: [number, number];
  names: [string, string];
  left: number;
}

const size = { width: 860, height: 430 };
const margin = { left: 52, right: 14, top: 30, bottom: 44 };

type Spot = [number, number];

/** The convex hull, by Andrew's monotone chain. */
function hullOf(points: Spot[]): Spot[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (all: Spot[]) => {
    const hull: Spot[] = [];
    for (const p of all) {
      for (let n = hull.length; n >= 2; n = hull.length) {
        const [a, b] = [hull[n - 2]!, hull[n - 1]!];
        if ((b[0] - a[0]) * (p[1] - b[1]) - (b[1] - a[1]) * (p[0] - b[0]) > 0) break;
        hull.pop();
      }
      hull.push(p);
    }
    return hull.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** Around walls, samples and devices, with room to write. */
function extentOf({ walls, samples, devices }: Installation): Box {
  const points = [...(walls ? [walls.min, walls.max] : []), samples.min, samples.max, ...devices.map((d) => d.at)].filter((p) => p.every(Number.isFinite));
  const ends = (pick: (...all: number[]) => number) => [0, 1, 2].map((k) => pick(...points.map((p) => p[k]!))) as Vec3;
  const [min, max] = [ends(Math.min), ends(Math.max)];
  const border = 0.06 * Math.max(0.1, Math.hypot(...max.map((x, k) => x - min[k]!)));
  return { min: min.map((x) => x - border) as Vec3, max: max.map((x) => x + border) as Vec3 };
}

class Drawing {
  private readonly scale: number;
  private readonly extent: Box;

  constructor(
    private readonly installation: Installation,
    private readonly wide: number,
  ) {
    this.extent = extentOf(installation);
    const [x, y, z] = this.extent.max.map((v, k) => v - this.extent.min[k]!) as Vec3;
    this.scale = Math.min((wide - margin.left - margin.right) / x, (size.height - margin.top - margin.bottom) / Math.max(y, z));
  }

  private on({ axes: [a, b], left }: View, p: Vec3): Spot {
    const { min } = this.extent;
    return [left + margin.left + (p[a]! - min[a]!) * this.scale, size.height - margin.bottom - (p[b]! - min[b]!) * this.scale];
  }

  private box(view: View, { min, max }: Box, className: string): SVGRectElement {
    const [[x, bottom], [right, y]] = [this.on(view, min), this.on(view, max)];
    return svg('rect', { x: x.toFixed(1), y: y.toFixed(1), width: (right - x).toFixed(1), height: (bottom - y).toFixed(1), class: className });
  }

  /** Metres from the walls, or from where the world's axes begin. */
  private axes(view: View): SVGElement[] {
    const { min, max } = this.extent;
    const from = this.installation.walls?.min ?? [0, 0, 0];
    const bottom = size.height - margin.bottom;
    const left = view.left + margin.left;
    const top = this.on(view, max)[1];
    const right = this.on(view, max)[0];
    const [a, b] = view.axes;
    const ticks = (k: number) => new Scale(min[k]! - from[k]!, max[k]! - from[k]!, false, true).ticks(1);
    const at = (k: number, value: number) => min.map((x, j) => (j === k ? value + from[k]! : x)) as Vec3;
    const middle = (top + bottom) / 2;
    const upwards = note(view.left + 12, middle, view.names[1], 'middle');
    upwards.setAttribute('transform', `rotate(-90 ${view.left + 12} ${middle.toFixed(1)})`);
    return [
      svg('rect', { x: left, y: top.toFixed(1), width: (right - left).toFixed(1), height: (bottom - top).toFixed(1), class: 'frame' }),
      ...ticks(a).flatMap((value) => {
        const [x] = this.on(view, at(a, value));
        return [svg('line', { x1: x, x2: x, y1: bottom, y2: bottom + 4, class: 'tick' }), note(x, bottom + 16, String(Number(value.toFixed(6))), 'middle')];
      }),
      ...ticks(b).flatMap((value) => {
        const [, y] = this.on(view, at(b, value));
        return [svg('line', { x1: left - 4, x2: left, y1: y, y2: y, class: 'tick' }), note(left - 7, y + 4, String(Number(value.toFixed(6))), 'end')];
      }),
      note(left, top - 8, view.title),
      note((left + right) / 2, bottom + 34, view.names[0], 'middle'),
      upwards,
    ];
  }

  private sight(view: View, at: Vec3, edge: Vec3[]): SVGElement[] {
    if (edge.length === 0) return [];
    const points = hullOf([at, ...edge].map((p) => this.on(view, p)));
    return [svg('polygon', { points: points.map((p) => p.map((x) => x.toFixed(1)).join()).join(' '), class: 'sight' })];
  }

  /** Which way it looks: as long as it lies in the drawing. */
  private arrow(view: View, at: Vec3, aim: Vec3 | null): SVGElement[] {
    const way = aim?.map((x, k) => x - at[k]!) ?? [0, 0, 0];
    const length = Math.hypot(...way);
    if (length === 0) return [];
    const [x, y] = this.on(view, at);
    const [a, b] = view.axes;
    const [right, up] = [(26 * way[a]!) / length, (26 * way[b]!) / length];
    return [svg('line', { x1: x, y1: y, x2: x + right, y2: y - up, class: 'arrow' })];
  }

  /** Numbers of devices that fall on one spot stand together. */
  private numbers(view: View): SVGElement[] {
    const spots: { at: Spot; numbers: number[] }[] = [];
    this.installation.devices.forEach(({ at }, k) => {
      const [x, y] = this.on(view, at);
      const near = spots.find((s) => Math.hypot(s.at[0] - x, s.at[1] - y) < 12);
      if (near) near.numbers.push(k + 1);
      else spots.push({ at: [x, y], numbers: [k + 1] });
    });
    const middle = view.left + this.wide / 2;
    return spots.map(({ at: [x, y], numbers }) => note(x + (x > middle ? -8 : 8), y - 7, numbers.join(', '), x > middle ? 'end' : 'start'));
  }

  view(view: View): SVGElement[] {
    const { walls, samples, devices } = this.installation;
    const clip = `within-${view.left}`;
    const inside = svg('g', { 'clip-path': `url(#${clip})` }, ...devices.flatMap((d) => this.sight(view, d.at, d.view)));
    const numbers = svg('g', { class: 'numbers-of-devices' }, ...this.numbers(view));
    return [
      svg('clipPath', { id: clip }, this.box(view, this.extent, '')),
      inside,
      ...(walls ? [this.box(view, walls, 'walls')] : []),
      ...(samples.min.every(Number.isFinite) ? [this.box(view, samples, 'samples')] : []),
      ...this.axes(view),
      ...devices.flatMap((d, k) => {
        const [cx, cy] = this.on(view, d.at);
        return [...this.arrow(view, d.at, d.aim), svg('circle', { cx, cy, r: 4, class: 'device' }, svg('title', {}, `${k + 1}: ${d.name}`))];
      }),
      numbers,
    ];
  }
}

function drawing(installation: Installation): HTMLElement {
  const wide = size.width / 2;
  const all = new Drawing(installation, wide);
  const from = installation.walls ? ['m from the left wall', 'm from the front wall', 'm above the floor'] : ['x, m', 'y, m', 'z, m'];
  const views: View[] = [
    { title: 'plan, from above', axes: [0, 1], names: [from[0]!, from[1]!], left: 0 },
    { title: 'elevation, from the front', axes: [0, 2], names: [from[0]!, from[2]!], left: wide },
  ];
  const picture = svg(
    'svg',
    {
      viewBox: `0 0 ${size.width} ${size.height}`,
      class: 'rig',
      role: 'img',
      'aria-label': 'Where the devices stand and which way they look, from above and from the front, numbered as in the table; what they see half of the way to the samples',
    },
    ...views.flatMap((view) => all.view(view)),
  );
  const words = `Numbers are those of the table${installation.walls ? '; the walls are drawn thick' : ''}. The dashed box holds the samples. Shaded: what a device sees, half of the way to them.`;
  return h('figure', {}, picture, h('figcaption', {}, words));
}

export function installersSheet(installation: Installation): HTMLElement {
  const { devices, walls } = installation;
  if (devices.length === 0) return paragraph('The target carries all devices.');
  const head = ['no.', 'device', 'x, y, z [m]', ...(walls ? ['from the walls [m]'] : []), 'aim [m]', 'pan', 'tilt', 'roll'];
  const rows = devices.map((d, k): Cell[] => [
    String(k + 1),
    d.name,
    place(d.at),
    ...(walls ? [d.from.map(({ wall, distance }) => (wall === 'floor' ? `${metres(distance)} up` : `${metres(distance)} ${wall}`)).join(', ')] : []),
    d.aim ? place(d.aim) : 'all around',
    degrees(d.pan),
    degrees(d.tilt),
    degrees(d.roll),
  ]);
  const frame = walls
    ? ' Walls are those of the scene’s room: left and right across x, front and back across y, the nearer one of each; heights are above its floor.'
    : ' The scene has no room: measure from where its x, y and z begin.';
  return h(
    'div',
    {},
    drawing(installation),
    table(
      'installation',
      `Where each device is to stand and look. Pan is from x towards y, tilt above the horizon, roll clockwise as seen from behind; the aim is the point of its axis nearest to what it looks at.${frame}`,
      head,
      rows,
    ),
  );
}
