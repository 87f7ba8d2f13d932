// Devices as icons that stand and look as they do, with what they see.
import {
  BufferGeometry,
  BoxGeometry,
  ConeGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineLoop,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Object3D,
  SphereGeometry,
  Vector3,
} from 'three';
import { CSS2DObject } from 'three/addons/renderers/CSS2DRenderer.js';
import type { Description, Device } from '../server';
import { paint } from './paint';
import { discard } from './room';

export interface IconColours {
  device: string;
  selected: string;
  sight: string;
}

/** How far frusta are drawn, of the outline's depth. */
const frustum = { all: 0.28, selected: 1 };

function bodyOf(device: Device, size: number, material: MeshStandardMaterial): Group {
  const group = new Group();
  if (!device.outline || device.outline.length === 0) {
    group.add(new Mesh(new SphereGeometry(0.42 * size, 20, 14), material));
    return group;
  }
  // A housing behind the pose's origin, and a lens that opens along z.
  const housing = new Mesh(new BoxGeometry(0.8 * size, 0.6 * size, 0.9 * size), material);
  housing.position.z = -0.6 * size;
  const lens = new Mesh(new ConeGeometry(0.38 * size, 0.55 * size, 20, 1, true), material);
  lens.rotation.x = -Math.PI / 2;
  lens.position.z = 0.05 * size;
  group.add(housing, lens);
  return group;
}

/** Where the outline has corners: where it is farthest from the axis; of a round one, some
 * points of it. */
function ribs(outline: Vector3[]): Vector3[] {
  const radius = outline.map((p) => Math.hypot(p.x, p.y));
  const least = Math.min(...radius);
  const n = outline.length;
  const near = 3;
  const corners = outline.filter((_, i) => {
    for (let d = -near; d <= near; ++d)
      if (d !== 0 && radius[(i + d + n) % n]! > radius[i]! - (d < 0 ? 1e-9 : 0)) return false;
    return radius[i]! > 1.02 * least;
  });
  return corners.length >= 3 ? corners : outline.filter((_, i) => i % (n / 6) === 0);
}

function sightOf(outline: Vector3[], selected: boolean, colours: IconColours): Group {
  const part = selected ? frustum.selected : frustum.all;
  const edge = outline.map((p) => p.clone().multiplyScalar(part));
  const color = selected ? colours.selected : colours.sight;
  const material = paint(
    `sight ${color}`,
    () => new LineBasicMaterial({ color, transparent: true, opacity: selected ? 0.95 : 0.5 }),
  );
  const rays = ribs(edge).flatMap((p) => [new Vector3(), p]);
  const group = new Group();
  group.add(
    new LineLoop(new BufferGeometry().setFromPoints(edge), material),
    new LineSegments(new BufferGeometry().setFromPoints(rays), material),
  );
  if (selected) {
    const points = [new Vector3(), ...edge];
    const sides = new BufferGeometry().setFromPoints(points);
    sides.setIndex(edge.flatMap((_, i) => [0, i + 1, ((i + 1) % edge.length) + 1]));
    group.add(
      new Mesh(
        sides,
        paint(
          `seen ${color}`,
          () =>
            new MeshBasicMaterial({
              color,
              transparent: true,
              opacity: 0.07,
              side: DoubleSide,
              depthWrite: false,
            }),
        ),
      ),
    );
  }
  return group;
}

function labelOf(device: Device, size: number, selected: boolean): CSS2DObject {
  const element = document.createElement('div');
  element.className = selected ? 'tag selected' : 'tag';
  element.textContent = device.name;
  const label = new CSS2DObject(element);
  label.position.set(0, 0, 0);
  label.center.set(0.5, 2);
  label.userData.size = size;
  return label;
}

export interface IconOptions {
  selected: string | null;
  frusta: boolean;
  labels: boolean;
}

export class Icons {
  readonly group = new Group();
  private readonly byName = new Map<string, Object3D>();

  show(description: Description, options: IconOptions, colours: IconColours): void {
    for (const child of [...this.group.children]) discard(child);
    this.byName.clear();
    const { min, max } = description.room;
    const size = 0.032 * Math.max(1e-3, Math.hypot(...max.map((x, k) => x - min[k]!)));
    const placed = description.devices.filter((d) => d.pose);
    // Beyond some dozens, names hide the picture.
    const labels = options.labels && placed.length <= 40;
    for (const device of placed) {
      const selected = device.name === options.selected;
      const icon = new Group();
      icon.name = device.name;
      const color = selected ? colours.selected : colours.device;
      const material = paint(
        `device ${color}`,
        () => new MeshStandardMaterial({ color, roughness: 0.55, side: DoubleSide }),
      );
      icon.add(bodyOf(device, placed.length > 60 ? size / 2 : size, material));
      if (device.outline!.length > 0 && (selected || (options.frusta && placed.length <= 60)))
        icon.add(sightOf(device.outline!.map((p) => new Vector3(...p)), selected, colours));
      if (labels || selected) icon.add(labelOf(device, size, selected));
      this.group.add(icon);
      this.byName.set(device.name, icon);
      place(icon, device);
    }
  }

  /** Move icons to where their devices stand; the others stay as they are. */
  move(description: Description, but: string | null): void {
    for (const device of description.devices) {
      const icon = this.byName.get(device.name);
      if (!icon || !device.pose) continue;
      if (device.name === but) turn(icon, device);
      else place(icon, device);
    }
  }

  find(name: string | null): Object3D | null {
    return name === null ? null : (this.byName.get(name) ?? null);
  }

  hide(name: string): void {
    const icon = this.find(name);
    if (icon) icon.visible = false;
  }

  /** The device that a hit object belongs to. */
  nameOf(object: Object3D | null): string | null {
    for (let o = object; o; o = o.parent) if (o.parent === this.group) return o.name;
    return null;
  }
}

function turn(icon: Object3D, device: Device): void {
  const [x, y, z] = device.pose!.R;
  const rotation = new Matrix4().set(...x, 0, ...y, 0, ...z, 0, 0, 0, 0, 1);
  icon.quaternion.setFromRotationMatrix(rotation);
}

function place(icon: Object3D, device: Device): void {
  icon.position.set(...device.pose!.p);
  turn(icon, device);
}

