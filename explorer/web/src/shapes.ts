// Surfaces, bodies, reliefs and octree cells of the field, which the server makes.

/** A field that the server keeps, by the verb that drew it. */
export type FieldKind = 'field' | 'pinned' | 'difference' | 'sensitivity' | 'sections';

/** What is wanted of a field, by its values, SI. */
export type ShapeAsked = { of: FieldKind } & (
  | { level: number }
  /** null: without an end. */
  | { between: [number | null, number | null] }
  /** As high as the values: a layer across an axis, or, without one, planes. */
  | { relief: { axis?: number; at?: number; low: number; high: number; log10: boolean; size: number } }
);

export interface ShapesAsked {
  shapes: ShapeAsked[];
  /** Octree cells that a plane cuts, or all. */
  leaves?: { axis?: number; at?: number };
}

export interface MadeMesh {
  asked: ShapeAsked;
  positions: Float32Array;
  normals: Float32Array;
  values: Float32Array;
  triangles: Uint32Array;
  /** From this corner on triangles are flat. */
  caps: number;
  /** m² */
  area: number;
}

export interface Shapes {
  /** What was asked for, as a text to compare. */
  asked: string;
  meshes: MadeMesh[];
  leaves: { count: number; positions: Float32Array } | null;
}

export const nothingAsked: ShapesAsked = { shapes: [] };
export const textOf = (asked: ShapesAsked) => JSON.stringify(asked);

export const noShapes = (asked: ShapesAsked): Shapes => ({ asked: textOf(asked), meshes: [], leaves: null });
export const isNothing = ({ shapes, leaves }: ShapesAsked) => shapes.length === 0 && !leaves;

export function unpackShapes(buffer: ArrayBuffer, asked: ShapesAsked): Shapes {
  const magic = String.fromCharCode(...new Uint8Array(buffer, 0, 4));
  if (magic !== 'DLS1') throw new Error('the shapes are of another version; reload the page');
  const length = new DataView(buffer).getUint32(4, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, length)));
  const base = 8 + length;
  const floats = (at: number, count: number) => new Float32Array(buffer, base + at, count);
  const meshes = head.meshes.map(
    (m: any): MadeMesh => ({
      asked: asked.shapes[m.shape]!,
      positions: floats(m.positions, 3 * m.vertices),
      normals: floats(m.normals, 3 * m.vertices),
      values: floats(m.values, m.vertices),
      triangles: new Uint32Array(buffer, base + m.triangles, m.corners),
      caps: m.caps,
      area: m.area,
    }),
  );
  const leaves = head.leaves && { count: head.leaves.count, positions: floats(head.leaves.positions, 6 * head.leaves.lines) };
  return { asked: textOf(asked), meshes, leaves };
}
