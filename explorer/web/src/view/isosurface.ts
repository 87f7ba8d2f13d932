// The surface on which a field over a grid has one value.
import { BufferAttribute, BufferGeometry } from 'three';
import { edgeTable, triTable } from 'three/addons/objects/MarchingCubes.js';
import { Drawn, type Field, type GridPart } from '../field';

/** Corners of a cell in the order of the tables, as steps along x, y and z. */
const corners = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 0, 1],
  [1, 1, 1],
  [0, 1, 1],
] as const;

/** The two corners that an edge joins. */
const edges = [
  [0, 1],
  [1, 2],
  [2, 3],
  [3, 0],
  [4, 5],
  [5, 6],
  [6, 7],
  [7, 4],
  [0, 4],
  [1, 5],
  [2, 6],
  [3, 7],
] as const;

/** Marching cubes (Lorensen & Cline, SIGGRAPH '87). Cells with a corner that has no value
 * have no surface: it ends where the field does. */
export function isosurface(field: Field, part: GridPart, level: number): BufferGeometry {
  const [nx, ny, nz] = part.counts;
  const steps = [1, nx, nx * ny];
  const offset = corners.map(([x, y, z]) => x + y * steps[1]! + z * steps[2]!);
  const positions: number[] = [];
  const triangles: number[] = [];
  const known = new Map<number, number>(); // vertices by edge

  /** The vertex where an edge of a cell crosses the level. */
  const vertex = (cell: number, x: number, y: number, z: number, edge: number): number => {
    const [c, d] = edges[edge]!;
    const a = cell + offset[c]!;
    const b = cell + offset[d]!;
    const key = 3 * Math.min(a, b) + steps.indexOf(Math.abs(a - b));
    const there = known.get(key);
    if (there !== undefined) return there;
    const va = field.values[part.first + a]!;
    const vb = field.values[part.first + b]!;
    const t = va === vb ? 0.5 : (level - va) / (vb - va);
    [x, y, z].forEach((n, k) => {
      const from = n + corners[c]![k]!;
      const to = n + corners[d]![k]!;
      positions.push(part.origin[k]! + (from + t * (to - from)) * part.step[k]!);
    });
    known.set(key, positions.length / 3 - 1);
    return positions.length / 3 - 1;
  };

  for (let z = 0; z < nz - 1; ++z)
    for (let y = 0; y < ny - 1; ++y)
      for (let x = 0; x < nx - 1; ++x) {
        const cell = x + y * nx + z * nx * ny;
        let kind = 0;
        let whole = true;
        for (let c = 0; c < 8; ++c) {
          const i = part.first + cell + offset[c]!;
          whole &&= field.mask[i] === Drawn.value;
          if (field.values[i]! < level) kind |= 1 << c;
        }
        if (!whole || edgeTable[kind] === 0) continue;
        for (let t = 16 * kind; triTable[t]! >= 0; ++t)
          triangles.push(vertex(cell, x, y, z, triTable[t]!));
      }

  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setIndex(triangles);
  geometry.computeVertexNormals();
  return geometry;
}
