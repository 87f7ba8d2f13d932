// A cube that stands as the room does: its faces look at it from there, arrow keys turn it.
import { Matrix4, Vector3 } from 'three';
import { h } from '../dom';
import type { ViewName } from './eye';
import type { Stage } from './stage';

const side = 46; // pixels
const step = Math.PI / 12;

/** Which way a face looks, and which way its text runs. */
const faces: { view: ViewName; word: string; name: string; normal: Vector3; right: Vector3 }[] = [
  { view: 'top', word: 'top', name: 'Look from above (7)', normal: new Vector3(0, 0, 1), right: new Vector3(1, 0, 0) },
  { view: 'front', word: 'front', name: 'Look from the front (1)', normal: new Vector3(0, -1, 0), right: new Vector3(1, 0, 0) },
  { view: 'side', word: 'right', name: 'Look from the right (3)', normal: new Vector3(1, 0, 0), right: new Vector3(0, 1, 0) },
  { view: 'back', word: 'back', name: 'Look from the back (Ctrl 1)', normal: new Vector3(0, 1, 0), right: new Vector3(-1, 0, 0) },
  { view: 'left', word: 'left', name: 'Look from the left (Ctrl 3)', normal: new Vector3(-1, 0, 0), right: new Vector3(0, -1, 0) },
  { view: 'below', word: 'below', name: 'Look from below (Ctrl 7)', normal: new Vector3(0, 0, -1), right: new Vector3(1, 0, 0) },
];
const turns: Record<string, [number, number]> = {
  ArrowLeft: [-step, 0],
  ArrowRight: [step, 0],
  ArrowUp: [0, step],
  ArrowDown: [0, -step],
};

export class ViewCube {
  readonly element: HTMLElement;
  private readonly buttons: HTMLButtonElement[];
  private readonly flat: HTMLButtonElement;

  constructor(
    private readonly stage: Stage,
    look: (from: ViewName) => void,
    orthographic: () => void,
  ) {
    this.buttons = faces.map(({ view, word, name }) =>
      h('button', { type: 'button', className: 'face', title: name, 'aria-label': name, 'data-view': view, onclick: () => look(view) }, word),
    );
    this.flat = h(
      'button',
      { type: 'button', className: 'flat', id: 'orthographic', title: 'Without perspective (5)', 'aria-pressed': 'false', onclick: orthographic },
      'orthographic',
    );
    const cube = h('div', { className: 'cube', role: 'group', 'aria-label': 'View from; arrow keys turn' }, ...this.buttons);
    cube.addEventListener('keydown', (event) => {
      const way = turns[event.key];
      if (!way) return;
      event.preventDefault();
      stage.turn(...way);
    });
    this.element = h('div', { className: 'view-cube' }, cube, this.flat);
    stage.drew.push(() => this.turnFaces());
  }

  private turnFaces(): void {
    const { camera, eye } = this.stage;
    this.flat.setAttribute('aria-pressed', String(eye.orthographic));
    const toEye = new Matrix4().makeRotationFromQuaternion(camera.quaternion).transpose();
    // Of the page, y is downwards.
    const seen = (v: Vector3) => {
      const { x, y, z } = v.clone().applyMatrix4(toEye);
      return new Vector3(x, -y, z);
    };
    faces.forEach(({ normal, right }, k) => {
      const n = seen(normal);
      const r = seen(right);
      const down = seen(right.clone().cross(normal));
      const centre = n.clone().multiplyScalar(side / 2);
      const numbers = [r, down, n, centre].flatMap((v, j) => [...v.toArray(), j === 3 ? 1 : 0]);
      const button = this.buttons[k]!;
      button.style.transform = `matrix3d(${numbers.map((x) => x.toFixed(4)).join(',')})`;
      button.dataset.away = String(n.z < 0.05);
    });
  }
}
