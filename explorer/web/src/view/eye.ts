// Where the picture is looked at from: in perspective, in parallel, or as a device sees.
import { Camera, Matrix4, OrthographicCamera, PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { Box, Device } from '../server';

/** Where the camera looks from, as a direction towards it. */
const directions = {
  corner: new Vector3(-0.75, -1, 0.62),
  top: new Vector3(0, -1e-4, 1),
  front: new Vector3(0, -1, 0),
  side: new Vector3(1, 0, 0),
  below: new Vector3(0, -1e-4, -1),
  back: new Vector3(0, 1, 0),
  left: new Vector3(-1, 0, 0),
};
export type ViewName = keyof typeof directions;

/** Of the perspective, degrees. */
const fov = 40;
/** What the colour bar covers at the right, pixels. */
const barWidth = 110;
/** Half of the picture's height at a unit distance. */
const slope = Math.tan((fov * Math.PI) / 360);

export class Eye {
  readonly perspective = new PerspectiveCamera(fov, 1, 0.01, 100);
  readonly parallel = new OrthographicCamera();
  /** What it turns about. */
  readonly target = new Vector3();
  private flat = false;
  private through = false;
  private aspect = 1;
  private center = new Vector3();
  private radius = 1;

  constructor() {
    for (const camera of [this.perspective, this.parallel]) camera.up.set(0, 0, 1);
  }

  get camera(): PerspectiveCamera | OrthographicCamera {
    return this.flat && !this.through ? this.parallel : this.perspective;
  }
  /** Whether it looks as a device does. */
  get asDevice(): boolean {
    return this.through;
  }
  /** Whether it looks in parallel, but for when it looks as a device does. */
  get orthographic(): boolean {
    return this.flat;
  }
  /** Half of the diagonal of what is looked at, metres. */
  get size(): number {
    return this.radius;
  }

  /** In parallel, or in perspective: what is turned about stays as large. */
  setOrthographic(flat: boolean): void {
    if (flat === this.flat) return;
    const { target, parallel, perspective } = this;
    const from = this.camera;
    this.flat = flat;
    if (this.through) return; // until it looks freely again
    const way = from.position.clone().sub(target);
    const half = flat ? way.length() * slope : parallel.top / parallel.zoom;
    perspective.position.copy(target).addScaledVector(way.normalize(), half / slope);
    parallel.position.copy(perspective.position);
    for (const camera of [parallel, perspective]) camera.quaternion.copy(from.quaternion);
    this.spread(half);
  }

  /** How much the parallel picture shows. @param half of its height, metres */
  private spread(half: number): void {
    const { parallel, aspect } = this;
    [parallel.top, parallel.bottom] = [half, -half];
    [parallel.left, parallel.right] = [-half * aspect, half * aspect];
    parallel.zoom = 1;
    parallel.updateProjectionMatrix();
  }

  /** Look at a box as a whole, or at the last one. */
  look(from: ViewName, box?: Box): void {
    this.through = false;
    this.setFov(fov);
    if (box) {
      const low = new Vector3(...box.min);
      const high = new Vector3(...box.max);
      this.center = low.clone().add(high).multiplyScalar(0.5);
      this.radius = Math.max(1e-3, low.distanceTo(high) / 2);
    }
    const { radius, center, perspective, parallel } = this;
    const narrow = Math.min(1, this.aspect);
    const distance = (1.12 * radius) / Math.sin(Math.atan(slope * narrow));
    perspective.near = radius / 200;
    // In parallel, what is beside or behind the eye is seen as well.
    parallel.near = -40 * radius;
    for (const camera of [perspective, parallel]) {
      camera.far = 40 * radius;
      camera.position.copy(directions[from]).normalize().multiplyScalar(distance).add(center);
      camera.lookAt(center);
    }
    this.target.copy(center);
    perspective.updateProjectionMatrix();
    this.spread((1.12 * radius) / narrow);
  }

  /** Look as a device does: along its z axis, y down, with its field of view. */
  lookThrough({ pose, outline }: Device): void {
    const [x, y, z] = [0, 1, 2].map((k) => new Vector3(...pose!.R.map((row) => row[k]!))) as [Vector3, Vector3, Vector3];
    this.through = true;
    const { perspective } = this;
    perspective.position.set(...pose!.p);
    perspective.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(x, y.negate(), z.negate()));
    const tall = Math.max(0.2, ...(outline ?? []).map((p) => Math.max(Math.abs(p[1]), Math.abs(p[0]) / this.aspect) / p[2]));
    this.setFov((360 / Math.PI) * Math.atan(1.05 * tall));
  }

  /** Go around what is looked at. @param left, up radians */
  turn(left: number, up: number): void {
    const { camera, target } = this;
    // Spherical coordinates of three are about y.
    const { x, y, z } = camera.position.clone().sub(target);
    const way = new Spherical().setFromVector3(new Vector3(y, z, x));
    way.theta -= left;
    way.phi = Math.min(Math.PI - 1e-4, Math.max(1e-4, way.phi - up));
    const to = new Vector3().setFromSpherical(way);
    camera.position.set(target.x + to.z, target.y + to.x, target.z + to.y);
    camera.lookAt(target);
  }

  /** @param width, height of a picture, pixels */
  frame(width: number, height: number): void {
    this.aspect = width / height;
    this.perspective.aspect = this.aspect;
    // The room stands in the middle of what the colour bar leaves free.
    for (const camera of [this.perspective, this.parallel]) camera.setViewOffset(width, height, barWidth / 2, 0, width, height);
    const { zoom } = this.parallel;
    this.spread(this.parallel.top);
    this.parallel.zoom = zoom;
    this.parallel.updateProjectionMatrix();
  }

  /** So that a picture of another width shows as much. @param wider times as wide */
  comeNearer(wider: number): void {
    if (this.through) return;
    const part = (aspect: number) => Math.min(1, aspect);
    const factor = part(this.aspect) / part(this.aspect * wider);
    this.perspective.position.sub(this.target).multiplyScalar(factor).add(this.target);
    this.parallel.zoom /= factor;
    this.parallel.updateProjectionMatrix();
  }

  private setFov(degrees: number): void {
    this.perspective.fov = degrees;
    this.perspective.updateProjectionMatrix();
  }
}

/** Which way a camera looks, exactly; all rays of a parallel picture. */
export const sightOf = (camera: Camera) => new Vector3(0, 0, -1).transformDirection(camera.matrixWorld);
