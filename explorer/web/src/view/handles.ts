// The handles of a gizmo, whose rings turn with the hand from every view.
import { Plane, Quaternion, Raycaster, Vector2, Vector3 } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';

const units = { X: new Vector3(1, 0, 0), Y: new Vector3(0, 1, 0), Z: new Vector3(0, 0, 1) };

/** Rings that are seen flatter than this (the sine of their tilt) have no angle that a hand
 * could follow; three's own way, along the ring's nearest edge, is for them. */
const leastTilt = 0.35;

/** A ring in the hand. */
interface Turn {
  /** In the device's frame. */
  axis: Vector3;
  /** Of the ring, in the room. */
  plane: Plane;
  center: Vector3;
  first: Vector3;
  orientation: Quaternion;
}

export class Handles extends TransformControls {
  private turn: Turn | null = null;

  override pointerDown(pointer: PointerEvent | null): void {
    super.pointerDown(pointer);
    this.turn = this.dragging && pointer && this.mode === 'rotate' ? this.ringAt(pointer) : null;
  }

  override pointerMove(pointer: PointerEvent | null): void {
    if (!this.turn || !pointer || !this.dragging) return super.pointerMove(pointer);
    const { axis, plane, center, first, orientation } = this.turn;
    const now = this.towards(pointer, plane, center);
    if (!now) return;
    const angle = Math.atan2(first.clone().cross(now).dot(plane.normal), first.dot(now));
    const step = this.rotationSnap;
    const turned = step ? Math.round(angle / step) * step : angle;
    this.object.quaternion.copy(orientation).multiply(new Quaternion().setFromAxisAngle(axis, turned)).normalize();
    this.dispatchEvent({ type: 'change' });
    this.dispatchEvent({ type: 'objectChange' });
  }

  override pointerUp(pointer: PointerEvent | null): void {
    this.turn = null;
    super.pointerUp(pointer);
  }

  /** The ring under the pointer; null where it is seen too flatly, or is the eye's own. */
  private ringAt(pointer: PointerEvent): Turn | null {
    const axis = units[this.axis as keyof typeof units];
    if (!axis) return null;
    const orientation = this.object.quaternion.clone();
    const center = this.object.getWorldPosition(new Vector3());
    const normal = axis.clone().applyQuaternion(this.object.getWorldQuaternion(new Quaternion()));
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, center);
    const first = this.towards(pointer, plane, center);
    return first && { axis, plane, center, first, orientation };
  }

  /** From the middle of a ring to where the pointer's ray meets its plane. */
  private towards(pointer: { x: number; y: number }, plane: Plane, center: Vector3): Vector3 | null {
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(pointer.x, pointer.y), this.camera);
    if (Math.abs(caster.ray.direction.dot(plane.normal)) < leastTilt) return null;
    return caster.ray.intersectPlane(plane, new Vector3())?.sub(center) ?? null;
  }
}
