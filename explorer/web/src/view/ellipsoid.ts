// What is known of a position as a body: an ellipsoid, or arrows along what has no end.
import { ArrowHelper, Group, Matrix4, Mesh, MeshLambertMaterial, SphereGeometry, Vector3 } from 'three';
import type { Ellipsoid, Lattice, Vec3 } from '../server';
import { paint } from './paint';

/** By how much ellipsoids are enlarged, so that the greatest is as long as wanted: a round
 * number. */
export function enlargement(greatest: number, wanted: number): number {
  if (!(greatest > 0)) return 0;
  const exact = wanted / greatest;
  const decade = 10 ** Math.floor(Math.log10(exact));
  return [5, 2, 1].find((m) => m * decade <= exact)! * decade;
}

/** @param scale standard deviations times their enlargement */
export function ellipsoidObject(at: Vec3, { axes, sigma }: Ellipsoid, scale: number, colour: string, fine = true): Mesh {
  const mesh = new Mesh(
    fine ? new SphereGeometry(1, 40, 24) : new SphereGeometry(1, 16, 10),
    paint(`ellipsoid ${colour}`, () => new MeshLambertMaterial({ color: colour, transparent: true, opacity: 0.6 })),
  );
  const [a, b, c] = axes.map((axis, k) => new Vector3(...axis).multiplyScalar(Math.max(1e-4, scale * sigma[k]!)));
  mesh.matrixAutoUpdate = false;
  mesh.matrix = new Matrix4().makeBasis(a!, b!, c!).setPosition(...at);
  return mesh;
}

/** To both sides, since a direction has no sign. */
export function lostArrows(at: Vec3, lost: Vec3[], length: number, colour: string): Group {
  const group = new Group();
  const head = 0.3 * length;
  for (const direction of lost)
    for (const sign of [1, -1]) {
      const way = new Vector3(...direction).multiplyScalar(sign);
      group.add(new ArrowHelper(way, new Vector3(...at), length, colour, head, 0.6 * head));
    }
  return group;
}

/** Bodies on a lattice, each at most `spacing` long. @returns how they are enlarged */
export function latticeObject(lattice: Lattice, sigmas: number, spacing: number, colour: string, lost: string): { group: Group; scale: number } {
  const group = new Group();
  const greatest = Math.max(0, ...lattice.points.flatMap(({ ellipsoid }) => ellipsoid?.sigma ?? []));
  const scale = enlargement(sigmas * greatest, 0.45 * spacing);
  for (const point of lattice.points) {
    if (point.ellipsoid) group.add(ellipsoidObject(point.at, point.ellipsoid, scale * sigmas, colour, false));
    else group.add(lostArrows(point.at, point.lost, 0.4 * spacing, lost));
  }
  return { group, scale };
}
