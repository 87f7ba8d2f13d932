// The point that is asked about: where it is, and its ellipsoid.
import {
  Group,
  LineBasicMaterial,
  LineSegments,
  BufferGeometry,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import type { PointReport, Vec3 } from '../server';
import { paint } from './paint';
import { discard } from './room';

export class Probe {
  readonly group = new Group();

  clear(): void {
    for (const child of [...this.group.children]) discard(child);
  }

  /** @param size of the room, metres
   *  @returns how many times as large as it is the ellipsoid is drawn; 0: there is none */
  show(at: Vec3, report: PointReport | null, size: number, colour: string): number {
    this.clear();
    const arm = 0.018 * size;
    const cross = [0, 1, 2].flatMap((k) =>
      [-arm, arm].map((s) => {
        const p = new Vector3(...at);
        return p.setComponent(k, p.getComponent(k) + s);
      }),
    );
    const lines = new LineSegments(
      new BufferGeometry().setFromPoints(cross),
      paint(
        `cross ${colour}`,
        () => new LineBasicMaterial({ color: colour, depthTest: false }),
      ),
    );
    lines.renderOrder = 2;
    this.group.add(lines);
    const ellipsoid = report?.ellipsoid;
    if (!ellipsoid) return 0;
    const greatest = Math.max(...ellipsoid.sigma);
    if (!(greatest > 0)) return 0;
    const exact = (0.05 * size) / greatest;
    const decade = 10 ** Math.floor(Math.log10(exact));
    const scale = [5, 2, 1].find((m) => m * decade <= exact)! * decade;
    const mesh = new Mesh(
      new SphereGeometry(1, 40, 24),
      paint(
        `ellipsoid ${colour}`,
        () => new MeshLambertMaterial({ color: colour, transparent: true, opacity: 0.6 }),
      ),
    );
    const [a, b, c] = ellipsoid.axes.map((axis, k) =>
      new Vector3(...axis).multiplyScalar(Math.max(1e-4, scale * ellipsoid.sigma[k]!)),
    );
    mesh.matrixAutoUpdate = false;
    mesh.matrix = new Matrix4().makeBasis(a!, b!, c!).setPosition(...at);
    this.group.add(mesh);
    return scale;
  }
}
