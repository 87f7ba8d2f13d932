// A device in the hand: dragged and turned in the picture.
import { Object3D, Vector3 } from 'three';
import { newGesture } from './gesture';
import { Handles } from './view/handles';
import type { Stage } from './view/stage';

/** @param p world, metres; @param q unit quaternion (w, x, y, z), device to world */
export type Place = (change: { p?: number[]; q?: number[]; size?: number[]; ray?: Ray }, gesture: string) => void;

/** From the eye through the pointer, where nothing keeps a movement to an axis. */
export interface Ray {
  from: number[];
  along: number[];
}

export class Gizmo {
  private readonly controls: Handles;
  private gesture = '';
  /** Of the box that is held, where it is one. */
  private size: number[] | null = null;
  private pointer: PointerEvent | null = null;

  /** @param home what the handles are drawn with */
  constructor(
    private readonly stage: Stage,
    home: Object3D,
    place: Place,
    ended: () => void,
  ) {
    this.controls = new Handles(stage.camera, stage.canvas);
    this.controls.setSize(0.8);
    home.add(this.controls.getHelper());
    this.controls.addEventListener('change', () => stage.draw());
    this.controls.addEventListener('axis-changed', () => {
      stage.canvas.style.cursor = this.hovered ? 'grab' : '';
    });
    this.controls.addEventListener('dragging-changed', ({ value }) => {
      stage.orbit.enabled = !value;
      this.gesture = value ? newGesture() : '';
      if (!value) ended();
    });
    stage.canvas.addEventListener('pointermove', (event) => (this.pointer = event), true);
    this.controls.addEventListener('objectChange', () => {
      const { object, mode } = this.controls;
      if (mode === 'translate') place({ p: rounded(object.position), ...this.ray() }, this.gesture);
      else if (mode === 'scale') place({ size: this.size!.map((s, k) => Number(Math.abs(s * object.scale.getComponent(k)).toFixed(4))) }, this.gesture);
      else {
        const { w, x, y, z } = object.quaternion;
        place({ q: [w, x, y, z] }, this.gesture);
      }
    });
  }

  private ray(): { ray?: Ray } {
    if (this.controls.axis !== 'XYZ' || !this.pointer) return {};
    const { origin, direction } = this.stage.ray(this.pointer).ray;
    return { ray: { from: origin.toArray(), along: direction.toArray() } };
  }

  /** Steps of 5 cm and 5°. */
  snap(on: boolean): void {
    this.controls.setTranslationSnap(on ? 0.05 : null);
    this.controls.setRotationSnap(on ? Math.PI / 36 : null);
  }

  /** While it is dragged: along one axis, or not at all.
   * @returns whether the key was for it */
  take({ key }: KeyboardEvent, cancelled: () => void): boolean {
    if (!this.dragging) return false;
    const axis = key.toUpperCase();
    if (/^[XYZ]$/.test(axis)) this.controls.axis = axis as 'X' | 'Y' | 'Z';
    else if (key !== 'Escape') return false;
    else {
      this.controls.reset();
      this.controls.pointerUp(null);
      cancelled();
    }
    return true;
  }

  get dragging(): boolean {
    return this.controls.dragging;
  }
  /** Whether the pointer is on a handle, so that a click isn't for what lies behind. */
  get hovered(): boolean {
    return this.controls.axis !== null;
  }
  get mode(): 'translate' | 'rotate' {
    return this.controls.mode === 'translate' ? 'translate' : 'rotate';
  }

  /** @param size of a box, which is sized instead of turned; undefined: it is turned */
  hold(object: Object3D | null, size?: number[] | null): void {
    this.size = size ?? null;
    const turning = size === undefined ? 'rotate' : size ? 'scale' : 'translate';
    this.controls.setMode(this.mode === 'translate' ? 'translate' : turning);
    this.controls.setSpace(this.mode === 'translate' ? 'world' : 'local');
    this.controls.camera = this.stage.camera;
    this.controls.viewport = this.stage.designPart;
    if (object) this.controls.attach(object);
    else this.controls.detach();
  }

  /** Along which axes: the world's, or, turning, the device's own. */
  use(mode: 'translate' | 'rotate'): void {
    this.controls.setMode(mode === 'rotate' && this.size ? 'scale' : mode);
    this.controls.setSpace(mode === 'translate' ? 'world' : 'local');
    this.stage.draw();
  }
}

/** To a tenth of a millimetre, which no hand is finer than. */
const rounded = (p: Vector3) => p.toArray().map((x) => Math.round(x * 1e4) / 1e4);
