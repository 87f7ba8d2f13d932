// The canvas: camera, light, and drawing only when something has changed.
import {
  AmbientLight,
  Color,
  DirectionalLight,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { CSS2DRenderer } from 'three/addons/renderers/CSS2DRenderer.js';
import type { Box } from '../server';

/** Where the camera looks from, as a direction towards it. */
const directions = {
  corner: new Vector3(-0.75, -1, 0.62),
  top: new Vector3(0, -1e-4, 1),
  front: new Vector3(0, -1, 0),
  side: new Vector3(1, 0, 0),
};
export type ViewName = keyof typeof directions;

/** What the colour bar covers at the right, pixels. */
const barWidth = 110;

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(40, 1, 0.01, 100);
  readonly orbit: OrbitControls;
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly labels = new CSS2DRenderer();
  private pending = false;
  private center = new Vector3();
  private radius = 1;

  constructor(private readonly host: HTMLElement) {
    // Kept after drawing, so that the picture can be saved from the browser.
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    this.describe('The room');
    this.labels.domElement.className = 'labels';
    host.append(this.canvas, this.labels.domElement);

    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, this.canvas);
    this.orbit.zoomToCursor = true;
    this.orbit.addEventListener('change', () => this.draw());
    const sun = new DirectionalLight(0xffffff, 2);
    sun.position.set(-1, -2, 3);
    const fill = new DirectionalLight(0xffffff, 0.7);
    fill.position.set(2, 1, -1);
    this.scene.add(sun, fill, new AmbientLight(0xffffff, 1.1));
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
  }

  /** Draw before the next frame is shown; asked often, done once. */
  draw(): void {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.renderer.render(this.scene, this.camera);
      this.labels.render(this.scene, this.camera);
    });
  }

  /** What the picture shows, for those who don't see it. */
  describe(text: string): void {
    this.canvas.setAttribute('aria-label', text);
  }

  background(colour: string): void {
    this.scene.background = new Color(colour);
    this.draw();
  }

  /** Look at a box as a whole. */
  look(from: ViewName, box?: Box): void {
    if (box) {
      const low = new Vector3(...box.min);
      const high = new Vector3(...box.max);
      this.center = low.clone().add(high).multiplyScalar(0.5);
      this.radius = Math.max(1e-3, low.distanceTo(high) / 2);
    }
    const narrow = Math.min(1, this.camera.aspect);
    const half = Math.atan(Math.tan((this.camera.fov * Math.PI) / 360) * narrow);
    const distance = (1.12 * this.radius) / Math.sin(half);
    this.camera.near = this.radius / 200;
    this.camera.far = 40 * this.radius;
    this.camera.position
      .copy(directions[from])
      .normalize()
      .multiplyScalar(distance)
      .add(this.center);
    this.camera.updateProjectionMatrix();
    this.orbit.target.copy(this.center);
    this.orbit.update();
    this.draw();
  }

  /** The ray through a point of the window. */
  ray(event: { clientX: number; clientY: number }): Raycaster {
    const frame = this.canvas.getBoundingClientRect();
    const at = new Vector2(
      (2 * (event.clientX - frame.left)) / frame.width - 1,
      1 - (2 * (event.clientY - frame.top)) / frame.height,
    );
    const caster = new Raycaster();
    caster.setFromCamera(at, this.camera);
    caster.params.Points = { threshold: this.radius / 60 };
    return caster;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    this.labels.setSize(width, height);
    this.camera.aspect = width / height;
    // The room stands in the middle of what the colour bar leaves free.
    this.camera.setViewOffset(width, height, barWidth / 2, 0, width, height);
    this.draw();
  }
}
