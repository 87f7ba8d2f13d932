// What of the field is shown, and how.
import type { Units } from './quantity';
import type { Colouring, Scale } from './scale';
import type { Box, Section, Vec3 } from './server';

/** A plane that isn't across an axis. */
export interface Slant {
  /** Which way its normal looks, from x towards y, and how far that is from z, radians. */
  azimuth: number;
  tilt: number;
  /** Where it cuts its normal through the room: 0 and 1 at the ends. */
  part: number;
}

/** How samples without a grid become a surface; as `Through` of the server. */
export interface Through {
  method: 'none' | 'natural-neighbour' | 'linear' | 'nearest' | 'inverse-distance' | 'minimum-curvature';
  over: 'x' | 'y' | 'z';
  /** By how much the greatest value is lifted above the least, metres. */
  relief: number;
  /** Of inverse distance; a radius of 0 is none. */
  power: number;
  radius: number;
}

export interface Viewing extends Colouring {
  /** Which slices across x, y and z there are. */
  slices: [boolean, boolean, boolean];
  /** Where the slice across each axis lies, metres. */
  at: Vec3;
  slants: Slant[];
  /** Slices and planes are as high as their values. */
  relief: boolean;
  /** How high the end of the bar is, as a part of the room. */
  reliefPart: number;
  /** Of an octree. */
  cells: boolean;
  through: Through;
  surface: boolean;
  /** Of the surface, as a part of the colour bar. */
  level: number;
  /** What is drawn of the whole volume. */
  body: 'none' | 'volume' | 'between';
  /** Ends of the interval, as parts of the colour bar. */
  between: [number, number];
  units: Units;
  compare: 'design' | 'difference' | 'beside';
  lattice: boolean;
  /** The number that slopes of the metric are shown of, by its path; empty: none. */
  sensitivity: string;
  blind: boolean;
  /** How many standard deviations ellipsoids show. */
  sigmas: number;
  frusta: boolean;
  names: boolean;
}

export const middle = ({ min, max }: Box) => min.map((x, k) => (x + max[k]!) / 2) as Vec3;

export const firstViewing = (): Viewing => ({
  slices: [false, false, true],
  at: [0, 0, 0],
  slants: [],
  relief: false,
  reliefPart: 0.2,
  cells: false,
  through: { method: 'none', over: 'z', relief: 0, power: 2, radius: 0 },
  surface: false,
  level: 0.35,
  body: 'none',
  between: [0, 0.3],
  units: 'auto',
  compare: 'design',
  lattice: false,
  sensitivity: '',
  blind: false,
  sigmas: 1,
  logarithmic: false,
  map: 'viridis',
  reversed: false,
  low: null,
  high: null,
  frusta: true,
  names: true,
});

/** The ends of the interval, SI. Those of the bar are values of samples: there it is open. */
export const endsOf = ({ between: [low, high] }: Viewing, scale: Scale): [number | null, number | null] => [
  low === 0 ? null : scale.at(low),
  high === 1 ? null : scale.at(high),
];

type Basis = { normal: Vec3; u: Vec3; v: Vec3 };

/** The plane's normal, the level direction in it, and the steepest one. */
function basisOf({ azimuth, tilt }: Slant): Basis {
  const [ca, sa, ct, st] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(tilt), Math.sin(tilt)];
  return { normal: [st * ca, st * sa, ct], u: [-sa, ca, 0], v: [-ct * ca, -ct * sa, st] };
}

/** The least parallelogram of a slanted plane that holds its cut through a box. */
export function sectionOf(slant: Slant, box: Box): Section | null {
  const { normal, u, v } = basisOf(slant);
  const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(
    (i) => [0, 1, 2].map((k) => ((i >> k) & 1 ? box.max : box.min)[k]!) as Vec3,
  );
  const heights = corners.map((c) => dot(c, normal));
  const low = Math.min(...heights);
  const height = low + slant.part * (Math.max(...heights) - low);
  // Where the plane crosses the edges of the box.
  const cut: Vec3[] = [];
  corners.forEach((a, i) =>
    [1, 2, 4].forEach((bit) => {
      if (i & bit) return;
      const b = corners[i | bit]!;
      const [ha, hb] = [heights[i]! - height, heights[i | bit]! - height];
      if (ha * hb > 0 || ha === hb) return;
      const t = ha / (ha - hb);
      cut.push(a.map((x, k) => x + t * (b[k]! - x)) as Vec3);
    }),
  );
  if (cut.length < 3) return null;
  const along = (axis: Vec3) => cut.map((p) => dot(p, axis));
  const [us, vs] = [along(u), along(v)];
  const [u0, u1, v0, v1] = [Math.min(...us), Math.max(...us), Math.min(...vs), Math.max(...vs)];
  if (!(u1 - u0 > 1e-9 && v1 - v0 > 1e-9)) return null;
  const place = (a: number, b: number, c: number) =>
    [0, 1, 2].map((k) => a * u[k]! + b * v[k]! + c * normal[k]!) as Vec3;
  return { origin: place(u0, v0, height), u: place(u1 - u0, 0, 0), v: place(0, v1 - v0, 0) };
}
