// The point that is asked about: where it is, and its ellipsoid.
import {
  Group,
  LineBasicMaterial,
  LineSegments,
  BufferGeometry,
  Vector3,
} from 'three';
import type { PointReport, Vec3 } from '../server';
import { ellipsoidObject, enlargement, lostArrows } from './ellipsoid';
import { paint } from './paint';
import { discard } from './room';

export class Probe {
  readonly group = new Group();

  clear(): void {
    for (const child of [...this.group.children]) discard(child);
  }

  /** @param size of the room, metres
   *  @returns how many times as large as it is the ellipsoid is drawn; 0: there is none */
  show(at: Vec3, report: PointReport | null, size: number, sigmas: number, colours: { probe: string; lost: string }): number {
    const colour = colours.probe;
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
    if (!report) return 0;
    this.group.add(lostArrows(at, report.lost, 0.06 * size, colours.lost));
    const { ellipsoid } = report;
    if (!ellipsoid) return 0;
    const scale = enlargement(sigmas * Math.max(...ellipsoid.sigma), 0.05 * size);
    if (scale > 0) this.group.add(ellipsoidObject(at, ellipsoid, scale * sigmas, colours.probe));
    return scale;
  }
}
