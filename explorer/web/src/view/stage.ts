// The canvas: camera, light, and drawing only when something has changed.
import {
  AmbientLight,
  Color,
  DepthTexture,
  DirectionalLight,
  Object3D,
  Raycaster,
  Scene,
  UnsignedIntType,
  Vector2,
  Vector4,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { CSS2DRenderer } from 'three/addons/renderers/CSS2DRenderer.js';
import type { Box, Device } from '../server';
import { Eye, type ViewName } from './eye';
import type { Volume } from './volume';

export class Stage {
  readonly scene = new Scene();
  readonly eye = new Eye();
  readonly orbit: OrbitControls;
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly labels = new CSS2DRenderer();
  /** What is opaque, for rays that go through volumes. */
  private readonly opaque = new WebGLRenderTarget(1, 1, { depthTexture: new DepthTexture(1, 1, UnsignedIntType) });
  private beside: { left: Object3D; right: Object3D } | null = null;
  private volumes: Volume[] = [];
  private pending = false;
  /** Of the host, pixels of the page: asking it anew would lay the page out. */
  private readonly size = new Vector2();
  /** Called when it has drawn. */
  readonly drew: (() => void)[] = [];

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

    this.orbit = new OrbitControls(this.camera, this.canvas);
    this.orbit.target = this.eye.target;
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
    this.eye.comeNearer(halves ? 0.5 : 2);
    this.resize();
  }

  get camera() {
    return this.eye.camera;
  }
  get halved(): boolean {
    return this.beside !== null;
  }
  /** Of the canvas, where the design is drawn: of two, the right one; pixels from below. */
  get designPart(): Vector4 | null {
    const { x: width, y: height } = this.size;
    return this.beside && new Vector4(width / 2, 0, width / 2, height);
  }

  private renderNow(): void {
    const { x: width, y: height } = this.size;
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
    for (const heard of this.drew) heard();
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

  /** Look as a device does. */
  lookThrough(device: Device): void {
    this.eye.lookThrough(device);
    this.orbit.enabled = false;
    this.draw();
  }

  /** Look at a box as a whole, or at the last one. */
  look(from: ViewName, box?: Box): void {
    this.eye.look(from, box);
    this.freely();
  }

  /** Go around what is looked at. @param left, up radians */
  turn(left: number, up: number): void {
    if (this.eye.asDevice) return;
    this.eye.turn(left, up);
    this.freely();
  }

  /** In parallel, or in perspective. */
  setOrthographic(flat: boolean): void {
    this.eye.setOrthographic(flat);
    if (this.eye.asDevice) return;
    this.freely();
  }

  private freely(): void {
    this.orbit.object = this.camera;
    this.orbit.enabled = true;
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
    caster.params.Points = { threshold: this.eye.size / 60 };
    return caster;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    this.size.set(width, height);
    this.renderer.setSize(width, height);
    const part = this.beside ? width / 2 : width;
    this.labels.setSize(part, height);
    this.labels.domElement.style.left = `${width - part}px`;
    this.eye.frame(part, height);
    this.draw();
  }
}

/** Whether an object and all that it is in are visible. */
function shown(object: Object3D): boolean {
  for (let o: Object3D | null = object; o; o = o.parent) if (!o.visible) return false;
  return true;
}
