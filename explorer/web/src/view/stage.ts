// The canvas: camera, light, and drawing only when something has changed.
import {
  AmbientLight,
  Color,
  DepthTexture,
  DirectionalLight,
  Matrix4,
  Object3D,
  PerspectiveCamera,
  Raycaster,
  Scene,
  UnsignedIntType,
  Vector2,
  Vector3,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { CSS2DRenderer } from 'three/addons/renderers/CSS2DRenderer.js';
import type { Box, Device } from '../server';
import type { Volume } from './volume';

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

/** What the colour bar covers at the right, pixels. */
const barWidth = 110;

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(40, 1, 0.01, 100);
  readonly orbit: OrbitControls;
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly labels = new CSS2DRenderer();
  /** What is opaque, for rays that go through volumes. */
  private readonly opaque = new WebGLRenderTarget(1, 1, { depthTexture: new DepthTexture(1, 1, UnsignedIntType) });
  private readonly fov = 40;
  private beside: { left: Object3D; right: Object3D } | null = null;
  private volumes: Volume[] = [];
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
      this.renderNow();
    });
  }

  /** Bodies of the scene that rays go through. */
  through(...volumes: Volume[]): void {
    this.volumes = volumes;
  }

  /** Two halves with one camera; null: one picture. @param left, right shown in one of them */
  split(halves: { left: Object3D; right: Object3D } | null): void {
    const others = (halves === null) !== (this.beside === null);
    this.beside = halves;
    if (!others) return;
    this.comeNearer(halves ? 0.5 : 2);
    this.resize();
  }

  /** So that a picture of another width shows as much. @param wider times as wide */
  private comeNearer(wider: number): void {
    const { camera, orbit } = this;
    const part = (aspect: number) => Math.min(1, aspect);
    const factor = part(camera.aspect) / part(camera.aspect * wider);
    if (orbit.enabled) camera.position.sub(orbit.target).multiplyScalar(factor).add(orbit.target);
  }
  get halved(): boolean {
    return this.beside !== null;
  }

  private renderNow(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    const half = width / 2;
    this.renderer.setScissorTest(this.beside !== null);
    if (this.beside) {
      const { left, right } = this.beside;
      [left.visible, right.visible] = [true, false];
      this.renderPart(0, half, height);
      [left.visible, right.visible] = [false, true];
      this.renderPart(half, half, height);
    } else {
      this.renderPart(0, width, height);
    }
    this.labels.render(this.scene, this.camera);
  }

  /** @param x, width, height of the part, pixels of the page */
  private renderPart(x: number, width: number, height: number): void {
    const { renderer, camera } = this;
    renderer.setViewport(x, 0, width, height);
    renderer.setScissor(x, 0, width, height);
    const volumes = this.volumes.filter(({ mesh }) => shown(mesh));
    if (volumes.length > 0) {
      const ratio = renderer.getPixelRatio();
      const corner = new Vector2(x, 0).multiplyScalar(ratio).floor();
      const picture = new Vector2(width, height).multiplyScalar(ratio).floor();
      this.depthBelow(volumes, corner, picture);
      camera.updateMatrixWorld();
      for (const volume of volumes) volume.prepare(camera, this.opaque.depthTexture!, corner, picture);
    }
    renderer.render(this.scene, camera);
  }

  private depthBelow(volumes: Volume[], corner: Vector2, picture: Vector2): void {
    const { renderer, opaque } = this;
    const { x: width, y: height } = renderer.getDrawingBufferSize(new Vector2());
    opaque.setSize(width, height);
    opaque.viewport.set(corner.x, corner.y, picture.x, picture.y);
    opaque.scissor.set(corner.x, corner.y, picture.x, picture.y);
    opaque.scissorTest = true;
    for (const { mesh } of volumes) mesh.visible = false;
    renderer.setRenderTarget(opaque);
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
    for (const { mesh } of volumes) mesh.visible = true;
  }

  /** What the picture shows, for those who don't see it. */
  describe(text: string): void {
    this.canvas.setAttribute('aria-label', text);
  }

  background(colour: string): void {
    this.scene.background = new Color(colour);
    this.draw();
  }

  /** Look as a device does: along its z axis, y down, with its field of view. */
  lookThrough({ pose, outline }: Device): void {
    const [x, y, z] = [0, 1, 2].map((k) => new Vector3(...pose!.R.map((row) => row[k]!))) as [Vector3, Vector3, Vector3];
    const position = new Vector3(...pose!.p);
    this.orbit.enabled = false;
    this.camera.position.copy(position);
    this.camera.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(x, y.negate(), z.negate()));
    const tall = Math.max(0.2, ...(outline ?? []).map((p) => Math.max(Math.abs(p[1]), Math.abs(p[0]) / this.camera.aspect) / p[2]));
    this.setFov((360 / Math.PI) * Math.atan(1.05 * tall));
    this.draw();
  }
  /** Whether it looks as a device does. */
  get asDevice(): boolean {
    return !this.orbit.enabled && this.camera.fov !== this.fov;
  }

  private setFov(degrees: number): void {
    this.camera.fov = degrees;
    this.camera.updateProjectionMatrix();
  }

  /** Look at a box as a whole. */
  look(from: ViewName, box?: Box): void {
    this.orbit.enabled = true;
    this.setFov(this.fov);
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
    const width = this.beside ? frame.width / 2 : frame.width;
    const at = new Vector2(
      (2 * ((event.clientX - frame.left) % width)) / width - 1,
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
    const part = this.beside ? width / 2 : width;
    this.labels.setSize(part, height);
    this.labels.domElement.style.left = `${width - part}px`;
    this.camera.aspect = part / height;
    // The room stands in the middle of what the colour bar leaves free.
    this.camera.setViewOffset(part, height, barWidth / 2, 0, part, height);
    this.draw();
  }
}

/** Whether an object and all that it is in are visible. */
function shown(object: Object3D): boolean {
  for (let o: Object3D | null = object; o; o = o.parent) if (!o.visible) return false;
  return true;
}
