// Clicks in the picture: on a device, or on a place of the field.
import type { Picture } from './picture';
import type { Vec3 } from './server';

export interface Clicks {
  /** Before anything else of a press. */
  pressed: () => void;
  device: (name: string | null) => void;
  body: (path: string) => void;
  place: (at: Vec3) => void;
}

/** A press that moves is for the camera, one on a handle for the gizmo. */
export function listenForClicks(picture: Picture, clicks: Clicks): void {
  let pressed: { x: number; y: number } | null = null;
  const { stage, gizmo } = picture;
  stage.canvas.addEventListener('pointerdown', (event) => {
    clicks.pressed();
    pressed = gizmo.hovered || event.button !== 0 ? null : { x: event.clientX, y: event.clientY };
  });
  stage.canvas.addEventListener('pointerup', (event) => {
    const still = pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < 4;
    pressed = null;
    const met = still && picture.pick(stage.ray(event));
    if (!met) return;
    if ('device' in met) clicks.device(met.device);
    else if ('body' in met) clicks.body(met.body);
    else clicks.place(met.at);
  });
}
