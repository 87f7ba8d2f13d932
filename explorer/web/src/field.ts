// A field as the server packs it: "DLF1", a JSON text, and arrays where it says.
import { counted, quantity } from './quantity';
import type { Vec3 } from './server';

/** What stands at a sample; as `Drawn` of the server. */
export const enum Drawn {
  blind = 0,
  value = 1,
  inside = 2,
  /** Of a difference: only the second has a value, or only the first. */
  gained = 3,
  lost = 4,
}

interface Range {
  name: string;
  first: number;
  count: number;
}
export interface GridPart extends Range {
  kind: 'grid';
  origin: Vec3;
  step: Vec3;
  counts: Vec3;
}
export interface PlanePart extends Range {
  kind: 'plane';
  origin: Vec3;
  u: Vec3;
  v: Vec3;
  counts: [number, number];
}
export interface PointsPart extends Range {
  kind: 'points';
  positions: Float32Array;
}
export interface SurfacePart extends Range {
  kind: 'surface';
  positions: Float32Array;
  triangles: Uint32Array;
}
export type Part = GridPart | PlanePart | PointsPart | SurfacePart;

interface Extreme {
  value: number;
  at: Vec3;
}

/** As `delos field --json` prints it. */
export interface Summary {
  metric: { name: string; unit: string };
  samples: number;
  observable: number;
  finite: number;
  one_short?: number;
  inside?: number;
  min: Extreme | null;
  max: Extreme | null;
  mean: number | null;
  median: number | null;
  p95: number | null;
  /** Of a difference: the part of the samples that are better, and how many only one of the two
   * sees. */
  better?: number;
  gained?: number;
  lost?: number;
  definition?: string;
  /** Of slopes: of which number. */
  sensitivity?: { path: string; value: number; unit: string };
  /** Of a surface through samples: what it is, and its own range. */
  through?: { method: string; over: string; samples: number; places: number; blind: number; min: number | null; max: number | null };
  /** Of what was pinned, where that is another one. */
  pinned_definition?: string | null;
}

export interface Field {
  revision: number;
  level: 'coarse' | 'full';
  largerIsBetter: boolean;
  definition: string;
  summary: Summary;
  /** NaN where there is no value to draw. */
  values: Float32Array;
  mask: Uint8Array;
  parts: Part[];
  /** Of the octree that it was read from; 0: of none. */
  leaves: number;
}

export function unpack(buffer: ArrayBuffer): Field {
  const view = new DataView(buffer);
  const magic = String.fromCharCode(...new Uint8Array(buffer, 0, 4));
  if (magic !== 'DLF1') throw new Error('the field is of another version; reload the page');
  const length = view.getUint32(4, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, length)));
  const base = 8 + length;
  const parts = head.parts.map((part: any): Part => {
    if (part.positions === undefined) return part;
    const positions = new Float32Array(buffer, base + part.positions, 3 * part.count);
    return part.kind === 'surface'
      ? {
          ...part,
          positions,
          triangles: new Uint32Array(buffer, base + part.triangles, part.corners),
        }
      : { ...part, positions };
  });
  return {
    revision: head.revision,
    level: head.level,
    largerIsBetter: head.larger_is_better,
    definition: head.definition,
    summary: head.summary,
    values: new Float32Array(buffer, base + head.values.at, head.values.count),
    mask: new Uint8Array(buffer, base + head.mask.at, head.mask.count),
    parts,
    leaves: head.leaves,
  };
}

/** Where a sample of a part stands. @param i counted from the part's first */
export function placeOf(part: Part, i: number): Vec3 {
  switch (part.kind) {
    case 'grid': {
      const [nx, ny] = part.counts;
      const n: Vec3 = [i % nx, Math.floor(i / nx) % ny, Math.floor(i / (nx * ny))];
      return n.map((k, a) => part.origin[a]! + k * part.step[a]!) as Vec3;
    }
    case 'plane': {
      const [nu, nv] = part.counts;
      const a = (i % nu) / Math.max(1, nu - 1);
      const b = Math.floor(i / nu) / Math.max(1, nv - 1);
      return part.origin.map((o, k) => o + a * part.u[k]! + b * part.v[k]!) as Vec3;
    }
    default:
      return [0, 1, 2].map((k) => part.positions[3 * i + k]!) as Vec3;
  }
}

/** Without neighbours on a grid. */
export const isScattered = (part: Part): part is PointsPart | SurfacePart => part.kind === 'points' || part.kind === 'surface';

/** The picture in one sentence. */
export function wordsOf({ summary }: Field): string {
  const { metric, min, max, samples, finite } = summary;
  const from =
    min && max
      ? `${metric.name} from ${quantity(min.value, metric.unit)} to ${quantity(max.value, metric.unit)}`
      : `${metric.name} is finite nowhere`;
  return `The room: ${from}; ${samples - finite} of ${counted(samples, 'sample')} blind`;
}
