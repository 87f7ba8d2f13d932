// The field in the room: layers of its grid, shapes of it, what has no grid.
import {
  BufferGeometry,
  Group,
  Intersection,
  LineBasicMaterial,
  LineLoop,
  Object3D,
  Raycaster,
  ShaderMaterial,
  Vector3,
} from 'three';
import { isScattered, placeOf, type Field, type GridPart, type Part, type PointsPart, type SurfacePart } from '../field';
import type { Scale } from '../scale';
import type { Box, Vec3 } from '../server';
import type { MadeMesh, Shapes } from '../shapes';
import { paint } from './paint';
import { discard } from './room';
import { scatteredObject } from './scattered';
import { leavesObject, shapeObject } from './shapes';
import { Sheet, type SheetData } from './sheet';
import { applyScale } from './uniforms';
import { Volume } from './volume';

/** More samples than these would hide the surface through them. */
const mostRinged = 500;

export interface FieldOptions {
  /** Where layers across axes lie, metres; the nearest ones of the grid are shown. */
  slices: { axis: number; at: number }[];
  /** Layers and planes stand as high as their values. */
  raised: boolean;
  /** The whole volume as a cloud. */
  cloud: boolean;
  /** What the server made of it. */
  meshes: MadeMesh[];
  leaves: Shapes['leaves'];
  /** Cuts of their own, shown within a box. */
  sections: Field | null;
  /** A surface through samples without a grid. */
  through: Field | null;
  box: Box;
}

/** The layer of a grid nearest to a place along an axis. */
export function layerAt(part: GridPart, axis: number, at: number): number {
  const n = Math.round((at - part.origin[axis]!) / part.step[axis]!);
  return Math.min(part.counts[axis]! - 1, Math.max(0, n));
}

function layerOf(part: GridPart, axis: number, layer: number): SheetData {
  const [a, b] = [0, 1, 2].filter((k) => k !== axis) as [number, number];
  const strides = [1, part.counts[0], part.counts[0] * part.counts[1]];
  const origin = new Vector3(...part.origin);
  origin.setComponent(axis, part.origin[axis]! + layer * part.step[axis]!);
  const side = (k: number) => {
    const n = part.counts[k]!;
    // A single row of samples is drawn as wide as its step.
    if (n === 1) origin.setComponent(k, origin.getComponent(k) - part.step[k]! / 2);
    return new Vector3().setComponent(k, Math.max(1, n - 1) * part.step[k]!);
  };
  return {
    origin,
    u: side(a),
    v: side(b),
    counts: [part.counts[a]!, part.counts[b]!],
    index: (i, j) => part.first + layer * strides[axis]! + i * strides[a]! + j * strides[b]!,
  };
}

const planeOf = (part: Part & { kind: 'plane' }): SheetData => ({
  origin: new Vector3(...part.origin),
  u: new Vector3(...part.u),
  v: new Vector3(...part.v),
  counts: part.counts,
  index: (i, j) => part.first + i + j * part.counts[0],
});

const inside = (box: Box | null, p: Vector3) =>
  !box || p.toArray().every((x, k) => x >= box.min[k]! - 1e-6 && x <= box.max[k]! + 1e-6);

export class FieldView {
  readonly group = new Group();
  private field: Field | null = null;
  private readonly sheets = new Map<Object3D, { sheet: Sheet; field: Field; within: Box | null }>();
  readonly volume = new Volume();
  /** Sheets that were shown before: their programs stay compiled. */
  private readonly spare: Sheet[] = [];
  private readonly scattered = new Map<Object3D, { part: Part; of: Field }>();

  constructor() {
    this.group.add(this.volume.mesh);
  }

  show(field: Field, options: FieldOptions, scale: Scale | null, edge: string): void {
    for (const child of [...this.group.children]) if (child !== this.volume.mesh) discard(child);
    this.spare.push(...[...this.sheets.values()].map(({ sheet }) => sheet));
    this.volume.hide();
    this.sheets.clear();
    this.scattered.clear();
    this.field = field;
    for (const part of field.parts) {
      if (part.kind === 'grid') {
        for (const { axis, at } of options.slices)
          this.sheet(field, layerOf(part, axis, layerAt(part, axis, at)), scale, edge, options.raised);
        if (scale && options.cloud) this.volume.show(field, part, scale);
      } else if (part.kind === 'plane') {
        this.sheet(field, planeOf(part), scale, edge, options.raised);
      } else {
        this.withoutGrid(field, part, scale);
      }
    }
    for (const part of options.through?.parts ?? [])
      if (part.kind === 'surface' || (part.kind === 'points' && part.count <= mostRinged)) this.withoutGrid(options.through!, part, scale);
    for (const part of options.sections?.parts ?? [])
      if (part.kind === 'plane') this.sheet(options.sections!, planeOf(part), scale, edge, options.raised, options.box);
    if (scale) for (const mesh of options.meshes) this.group.add(shapeObject(mesh, scale));
    if (options.leaves) this.group.add(leavesObject(options.leaves, edge));
  }

  private withoutGrid(of: Field, part: PointsPart | SurfacePart, scale: Scale | null): void {
    const object = scatteredObject(of, part, of !== this.field && part.kind === 'points');
    if (scale) applyScale(object.material, scale);
    this.scattered.set(object, { part, of });
    this.group.add(object);
  }

  /** The nearest sample that a ray meets. */
  pick(ray: Raycaster): Vec3 | null {
    const objects = [...this.sheets.keys(), ...this.scattered.keys()];
    const hits = ray.intersectObjects(objects, false).filter(({ object, point }) => inside(this.sheets.get(object)?.within ?? null, point));
    const hit = hits[0];
    if (!hit || !this.field) return null;
    const scattered = this.scattered.get(hit.object);
    if (scattered && scattered.of !== this.field) return this.under(hit.point, scattered.of);
    // Of points that a ray goes by, the one that it goes by nearest.
    const met = hits
      .filter(({ object }) => object === hit.object && hit.distanceToRay !== undefined)
      .reduce((a, b) => (b.distanceToRay! < a.distanceToRay! ? b : a), hit);
    const field = this.sheets.get(hit.object)?.field ?? this.field;
    const sample = this.sampleOf(met);
    const part = field.parts.find((p) => sample >= p.first && sample < p.first + p.count);
    return part ? placeOf(part, sample - part.first) : null;
  }

  /** Of the samples that a surface goes through, the nearest as seen along its axis. */
  private under(p: Vector3, through: Field): Vec3 | null {
    const axis = 'xyz'.indexOf(through.summary.through!.over);
    const places = this.field!.parts.filter(isScattered).flatMap((part) => Array.from({ length: part.count }, (_, i) => placeOf(part, i)));
    const apart = (q: Vec3) => Math.hypot(...p.toArray().map((x, k) => (k === axis ? 0 : x - q[k]!)));
    return places.reduce<Vec3 | null>((a, b) => (a && apart(a) <= apart(b) ? a : b), null);
  }

  private sampleOf(hit: Intersection): number {
    const sheet = this.sheets.get(hit.object)?.sheet;
    if (sheet) return sheet.nearest(hit.uv!);
    const { part } = this.scattered.get(hit.object)!;
    if (!hit.face) return part.first + hit.index!;
    const distance = (i: number) => hit.point.distanceToSquared(new Vector3(...placeOf(part, i)));
    const corners = [hit.face.a, hit.face.b, hit.face.c].sort((i, j) => distance(i) - distance(j));
    return part.first + corners[0]!;
  }

  private sheet(field: Field, data: SheetData, scale: Scale | null, edge: string, raised: boolean, within: Box | null = null): void {
    const { values, mask, summary } = field;
    const sheet = this.spare.pop() ?? new Sheet();
    // Half a device sees nothing: counts don't blend.
    sheet.show(data, values, mask, summary.metric.name !== 'coverage', within, raised);
    if (scale) applyScale(sheet.mesh.material as ShaderMaterial, scale);
    this.sheets.set(sheet.mesh, { sheet, field, within });
    this.group.add(sheet.mesh);
    if (within) return; // its corners aren't seen
    const { origin, u, v } = data;
    const corners = [
      origin,
      origin.clone().add(u),
      origin.clone().add(u).add(v),
      origin.clone().add(v),
    ];
    const outline = new LineLoop(
      new BufferGeometry().setFromPoints(corners),
      paint(`line ${edge}`, () => new LineBasicMaterial({ color: edge })),
    );
    this.group.add(outline);
  }
}
