// What stands in the room: its bounds, a floor with metres, bodies that hide, beacons.
import {
  Box3,
  Box3Helper,
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  EdgesGeometry,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Object3D,
  Points,
  PointsMaterial,
  type Raycaster,
  Vector3,
} from 'three';
import type { Around, Box, Solid } from '../server';
import { paint } from './paint';

export interface RoomColours {
  lines: string;
  faint: string;
  bodies: string;
  beacons: string;
  selected: string;
  region: string;
}

/** Free what an object and those in it hold of the graphics card, but for what they are
 * painted with. */
export function discard(object: Object3D): void {
  object.traverse((o) => {
    (o as Mesh).geometry?.dispose();
    // Labels are elements of the page.
    (o as { element?: HTMLElement }).element?.remove();
  });
  object.removeFromParent();
}

/** A round length, so that the floor has about ten squares. */
function floorStep(size: number): number {
  const rough = size / 10;
  const decade = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].find((m) => m * decade >= rough)! * decade;
}

const line = (color: string) => paint(`line ${color}`, () => new LineBasicMaterial({ color }));

function floor(box: Box, colours: RoomColours): { lines: LineSegments; step: number } {
  const size = Math.max(box.max[0] - box.min[0], box.max[1] - box.min[1], 1e-3);
  const step = floorStep(size);
  const low = [0, 1].map((k) => Math.floor(box.min[k]! / step) * step);
  const high = [0, 1].map((k) => Math.ceil(box.max[k]! / step) * step);
  // A little below the lowest samples, which would flicker with it.
  const z = box.min[2] - size / 100;
  const points: Vector3[] = [];
  for (let x = low[0]!; x <= high[0]! + step / 2; x += step)
    points.push(new Vector3(x, low[1]!, z), new Vector3(x, high[1]!, z));
  for (let y = low[1]!; y <= high[1]! + step / 2; y += step)
    points.push(new Vector3(low[0]!, y, z), new Vector3(high[0]!, y, z));
  const material = line(colours.faint);
  return { lines: new LineSegments(new BufferGeometry().setFromPoints(points), material), step };
}

/** Thin as air: only its edges are strong. */
function region(entry: Solid, colour: string): Object3D {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(entry.vertices), 3));
  geometry.setIndex(entry.triangles);
  const air = paint(`region ${colour}`, () => new MeshBasicMaterial({ color: colour, side: DoubleSide, transparent: true, opacity: 0.08, depthWrite: false }));
  const group = new Group();
  group.add(new Mesh(geometry, air), new LineSegments(new EdgesGeometry(geometry, 30), line(colour)));
  return group;
}

function body(entry: Around['occluders'][number], chosen: boolean, colours: RoomColours): Object3D {
  const color = chosen ? colours.selected : colours.bodies;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(entry.vertices), 3));
  geometry.setIndex(entry.triangles);
  const shell = geometry.toNonIndexed();
  shell.computeVertexNormals();
  const group = new Group();
  // The inside of a room is what one looks at: its walls are lines alone.
  if (!entry.room)
    group.add(
      new Mesh(
        shell,
        paint(
          `body ${color}`,
          () =>
            new MeshLambertMaterial({
              color,
              side: DoubleSide,
              transparent: true,
              opacity: 0.55,
              depthWrite: false,
              // Samples on its skin show their own colours.
              polygonOffset: true,
              polygonOffsetFactor: 4,
              polygonOffsetUnits: 4,
            }),
        ),
      ),
    );
  group.add(
    new LineSegments(
      new EdgesGeometry(geometry, 30),
      line(chosen ? colours.selected : colours.lines),
    ),
  );
  return group;
}

export class Room {
  readonly group = new Group();
  /** Metres between the lines of the floor. */
  step = 1;

  /** @param chosen path of a body or a region */
  show(samples: Box, room: Box, around: Around, chosen: string | null, colours: RoomColours): void {
    for (const child of [...this.group.children]) discard(child);
    const bounds = new Box3(new Vector3(...samples.min), new Vector3(...samples.max));
    const frame = new Box3Helper(bounds, new Color(colours.lines));
    const { lines, step } = floor(room, colours);
    this.step = step;
    this.group.add(frame, lines);
    // What moves with the target has no place of its own in the room.
    for (const entry of around.occluders)
      if (!entry.carried) this.add(body(entry, entry.path !== '' && entry.path === chosen, colours), entry.path);
    for (const entry of around.regions) this.add(region(entry, entry.path === chosen ? colours.selected : colours.region), entry.path);
    for (const points of around.surfaces)
      if (points.length > 1) this.group.add(new Line(new BufferGeometry().setFromPoints(points.map((p) => new Vector3(...p))), line(colours.region)));
    if (around.beacons.length > 0)
      this.group.add(
        new Points(
          new BufferGeometry().setFromPoints(around.beacons.map((p) => new Vector3(...p))),
          paint(
            `beacons ${colours.beacons}`,
            () => new PointsMaterial({ color: colours.beacons, size: 3, sizeAttenuation: false }),
          ),
        ),
      );
  }

  private add(object: Object3D, path: string): void {
    object.userData.path = path;
    this.group.add(object);
  }

  /** The body or region that a ray meets first, of those that a hand can change. */
  pick(ray: Raycaster): { path: string; distance: number } | null {
    for (const { object, distance } of ray.intersectObject(this.group, true)) {
      const path = object.parent?.userData.path as string | undefined;
      if (path && (object as Mesh).isMesh) return { path, distance };
    }
    return null;
  }
}
