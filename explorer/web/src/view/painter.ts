// A rectangle drawn by hand on a level plane of the room.
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineLoop, Plane, Vector3 } from 'three';
import type { Vec3 } from '../server';
import { paint } from './paint';
import type { Stage } from './stage';

export interface Drawn {
  min: Vec3;
  max: Vec3;
}

export class Painter {
  private readonly line = new LineLoop(new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(12), 3)));
  private plane: Plane | null = null;
  private first: Vector3 | null = null;
  private drawn: ((box: Drawn | null) => void) | null = null;

  constructor(private readonly stage: Stage) {
    this.line.frustumCulled = false;
    const { canvas } = stage;
    // Before the camera's own listeners.
    canvas.addEventListener('pointerdown', (event) => this.begin(event), true);
    canvas.addEventListener('pointermove', (event) => this.move(event), true);
    canvas.addEventListener('pointerup', (event) => this.end(event), true);
  }

  get at(): boolean {
    return this.drawn !== null;
  }

  /** @param z of the plane @param drawn told once, with null where it was given up */
  start(z: number, colour: string, drawn: (box: Drawn | null) => void): void {
    this.cancel();
    this.plane = new Plane(new Vector3(0, 0, 1), -z);
    this.drawn = drawn;
    this.line.material = paint(`line ${colour}`, () => new LineBasicMaterial({ color: colour }));
    this.stage.orbit.enabled = false;
    this.stage.canvas.style.cursor = 'crosshair';
  }

  cancel(): void {
    if (this.drawn) this.finish(null);
  }

  private finish(box: Drawn | null): void {
    const { drawn } = this;
    [this.plane, this.first, this.drawn] = [null, null, null];
    this.line.removeFromParent();
    this.stage.orbit.enabled = true;
    this.stage.canvas.style.cursor = '';
    this.stage.draw();
    drawn?.(box);
  }

  private meet(event: PointerEvent): Vector3 | null {
    return this.plane && this.stage.ray(event).ray.intersectPlane(this.plane, new Vector3());
  }

  private begin(event: PointerEvent): void {
    if (!this.plane || event.button !== 0) return;
    event.stopImmediatePropagation();
    this.first = this.meet(event);
  }

  private move(event: PointerEvent): void {
    const now = this.first && this.meet(event);
    if (!now) return;
    const { x, y, z } = this.first!;
    const corners = this.line.geometry.getAttribute('position') as BufferAttribute;
    corners.set([x, y, z, now.x, y, z, now.x, now.y, z, x, now.y, z]);
    corners.needsUpdate = true;
    this.stage.scene.add(this.line);
    this.stage.draw();
  }

  private end(event: PointerEvent): void {
    if (!this.plane) return;
    event.stopImmediatePropagation();
    const now = this.first && this.meet(event);
    if (!now || now.distanceTo(this.first!) < 1e-3) {
      this.first = null;
      return;
    }
    const { x, y, z } = this.first!;
    const tidy = (v: number) => Number(v.toFixed(3));
    this.finish({ min: [Math.min(x, now.x), Math.min(y, now.y), z].map(tidy) as Vec3, max: [Math.max(x, now.x), Math.max(y, now.y), z].map(tidy) as Vec3 });
  }
}
