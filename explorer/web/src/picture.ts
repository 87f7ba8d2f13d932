// The picture: what is drawn of a design, and of the one that it is compared with.
import { Group, Matrix4, Object3D, Vector3, type Raycaster } from 'three';
import { Gizmo, type Place } from './gizmo';
import type { Field } from './field';
import type { Held } from './hand';
import { Scale } from './scale';
import type { Around, BlindRegions, Box, Description, Device, Lattice, PointReport, Solid, Vec3 } from './server';
import { nothingAsked, type FieldKind, type ShapeAsked, type Shapes, type ShapesAsked } from './shapes';
import type { Drawing } from './theme';
import { blindBoxes } from './view/blindboxes';
import { latticeObject } from './view/ellipsoid';
import { FieldView, type FieldOptions } from './view/fieldview';
import { Icons } from './view/icons';
import { Probe } from './view/probe';
import { discard, Room } from './view/room';
import { Stage } from './view/stage';
import { endsOf, type Viewing } from './viewing';

/** What colours are of; verbs of the server. */
export type Coloured = 'field' | 'difference' | 'sensitivity';

export const coloured = ({ sensitivity, compare }: Viewing, { description }: Shown): Coloured =>
  sensitivity ? 'sensitivity' : compare === 'difference' && description!.pinned !== null ? 'difference' : 'field';

/** What is known of a design. */
export interface Shown {
  description: Description | null;
  around: Around;
  field: Field | null;
  /** Slopes of the metric. */
  slopes: Field | null;
  /** Of the design minus what is pinned. */
  difference: Field | null;
  pinned: { description: Description; field: Field } | null;
  sections: Field | null;
  shapes: Shapes | null;
  /** A surface through samples without a grid, and these. */
  through: (Field & { of: Coloured }) | null;
  lattice: Lattice | null;
  blind: BlindRegions | null;
  selected: string | null;
  /** The body or region that is chosen, by its path. */
  body: string | null;
  asked: Vec3 | null;
  report: PointReport | null;
}

export const nothingShown = (): Shown => ({
  description: null,
  around: { occluders: [], regions: [], surfaces: [], beacons: [] },
  field: null,
  slopes: null,
  difference: null,
  pinned: null,
  sections: null,
  shapes: null,
  through: null,
  lattice: null,
  blind: null,
  selected: null,
  body: null,
  asked: null,
  report: null,
});

/** The diagonal of the room, metres. */
export const sizeOf = ({ room: { min, max } }: Description) => Math.hypot(...max.map((x, k) => x - min[k]!));

/** Ends of two fields together, so that their colours mean the same. */
function rangeOf(...fields: Field[]): { min: number; max: number; largerIsBetter: boolean } | null {
  const ends = fields.flatMap(({ summary: { min, max } }) => (min && max ? [min.value, max.value] : []));
  if (ends.length === 0) return null;
  return { min: Math.min(...ends), max: Math.max(...ends), largerIsBetter: fields[0]!.largerIsBetter };
}

export class Picture {
  readonly stage: Stage;
  readonly gizmo: Gizmo;
  private readonly room = new Room();
  private readonly design = new Group();
  private readonly baseline = new Group();
  private readonly uncertainty = new Group();
  private readonly fieldView = new FieldView();
  private readonly icons = new Icons();
  private readonly probe = new Probe();
  private readonly baselineView = new FieldView();
  private readonly baselineIcons = new Icons();
  /** What the gizmo holds instead of a body, in its middle. */
  private readonly handle = new Object3D();
  /** Whether a dragged device keeps to faces. */
  sticking = false;
  /** By how much ellipsoids are enlarged: that of the point. */
  enlarged = 0;
  /** That of the lattice's. */
  latticeEnlarged = 0;

  constructor(
    host: HTMLElement,
    private readonly viewing: Viewing,
    /** Null: nothing can be moved. */
    private readonly place: Place | null,
    dropped: () => void,
  ) {
    this.stage = new Stage(host);
    this.design.add(this.fieldView.group, this.icons.group, this.probe.group, this.uncertainty);
    this.baseline.add(this.baselineView.group, this.baselineIcons.group);
    this.baseline.visible = false;
    this.stage.scene.add(this.room.group, this.design, this.baseline);
    this.stage.through(this.fieldView.volume, this.baselineView.volume);
    this.gizmo = new Gizmo(this.stage, this.design, place ?? (() => {}), dropped);
  }

  /** Metres between the lines of the floor. */
  drawRoom({ description, around, body }: Shown, colours: Drawing): number {
    const { box, room } = description!;
    this.room.show(box, room, around, body, colours);
    return this.room.step;
  }

  /** The body that is chosen, in the hand. */
  private holdBody({ around, body }: Shown): boolean {
    const solid = [...around.occluders, ...around.regions].find((b) => b.path === body);
    if (!body || !solid) return false;
    if (this.gizmo.dragging) return true;
    this.design.add(this.handle);
    placeHandle(this.handle, solid);
    this.gizmo.hold(this.handle, solid.size);
    return true;
  }

  /** Whether the halves show two designs. */
  private besides({ pinned }: Shown): boolean {
    return this.viewing.compare === 'beside' && pinned !== null;
  }

  /** Where the body that is held stands. */
  get heldBody(): Held {
    const { x, y, z } = this.handle.position;
    const [X, Y, Z] = [0, 1, 2].map((k) => new Vector3().setFromMatrixColumn(new Matrix4().makeRotationFromQuaternion(this.handle.quaternion), k)) as [Vector3, Vector3, Vector3];
    const row = (k: 'x' | 'y' | 'z'): Vec3 => [X[k], Y[k], Z[k]];
    return { pose: { p: [x, y, z], R: [row('x'), row('y'), row('z')] } };
  }

  drawDevices(shown: Shown, colours: Drawing): void {
    const { description, selected, pinned } = shown;
    if (!description) return;
    if (this.gizmo.dragging) {
      // What sticks to a face stands where the server says.
      this.icons.move(description, this.sticking ? null : selected);
      return;
    }
    const { frusta, names: labels } = this.viewing;
    this.icons.show(description, { selected, frusta, labels }, colours);
    if (pinned) this.baselineIcons.show(pinned.description, { selected: null, frusta, labels: false }, colours);
    const device = description.devices.find((d) => d.name === selected);
    if (this.holdBody(shown)) return;
    this.gizmo.hold(!this.place || device?.surface || this.stage.eye.asDevice ? null : this.icons.find(selected));
  }

  drawProbe({ asked, report, description }: Shown, colours: Drawing): void {
    if (!asked || !description) return this.probe.clear();
    this.enlarged = this.probe.show(asked, report, sizeOf(description), this.viewing.sigmas, colours);
  }

  drawUncertainty({ lattice, blind }: Shown, colours: Drawing): void {
    for (const child of [...this.uncertainty.children]) discard(child);
    const { viewing } = this;
    if (viewing.blind && blind) this.uncertainty.add(blindBoxes(blind, colours.lost));
    if (!viewing.lattice || !lattice || lattice.points.length === 0) return;
    const spacing = spacingOf(lattice.points.map((p) => p.at));
    const { group, scale } = latticeObject(lattice, viewing.sigmas, spacing, colours.edge, colours.lost);
    this.latticeEnlarged = scale;
    this.uncertainty.add(group);
  }

  /** What the colours are of, and their scale; null: nothing has a value. */
  private coloured(shown: Shown): { drawn: Field; kind: FieldKind; scale: Scale | null } {
    const { viewing } = this;
    const [kind, difference]: [FieldKind, Field | null] = viewing.sensitivity
      ? ['sensitivity', shown.slopes]
      : ['difference', viewing.compare === 'difference' ? shown.difference : null];
    const drawn = difference ?? shown.field!;
    const range = rangeOf(drawn, ...(this.besides(shown) ? [shown.pinned!.field] : []));
    const scale = range && (difference ? Scale.ofDifference(range.min, range.max, range.largerIsBetter) : Scale.of(range, viewing));
    return { drawn, kind: difference ? kind : 'field', scale };
  }

  /** The shapes that are to be seen. */
  shapesAsked(shown: Shown): ShapesAsked {
    if (!shown.field || !shown.description) return nothingAsked;
    const { viewing } = this;
    const { drawn, kind, scale } = this.coloured(shown);
    const kinds: FieldKind[] = this.besides(shown) ? [kind, 'pinned'] : [kind];
    const shapes = scale ? kinds.flatMap((of) => this.shapesOf(of, drawn, scale, sizeOf(shown.description!))) : [];
    if (scale && shown.sections && viewing.relief && !viewing.sensitivity) shapes.push(this.relief('sections', scale, sizeOf(shown.description)));
    if (!viewing.cells || shown.field.leaves === 0) return { shapes };
    const axis = viewing.slices.indexOf(true);
    return { shapes, leaves: axis < 0 ? {} : { axis, at: viewing.at[axis]! } };
  }

  private shapesOf(of: FieldKind, drawn: Field, scale: Scale, size: number): ShapeAsked[] {
    const { viewing } = this;
    const shapes: ShapeAsked[] = [];
    const has = (kind: string) => drawn.parts.some((part) => part.kind === kind);
    if (has('grid') && viewing.surface) shapes.push({ of, level: scale.at(viewing.level) });
    if (has('grid') && viewing.body === 'between') shapes.push({ of, between: endsOf(viewing, scale) });
    if (!viewing.relief) return shapes;
    if (has('grid'))
      for (const axis of [0, 1, 2].filter((k) => viewing.slices[k])) shapes.push(this.relief(of, scale, size, { axis, at: viewing.at[axis]! }));
    if (has('plane')) shapes.push(this.relief(of, scale, size));
    return shapes;
  }

  /** Of a difference no change has no height. */
  private relief(of: FieldKind, scale: Scale, size: number, layer: { axis?: number; at?: number } = {}): ShapeAsked {
    const low = scale.difference ? 0 : scale.min;
    return { of, relief: { ...layer, low, high: scale.max, log10: scale.logarithmic, size: this.viewing.reliefPart * size } };
  }

  /** Draw the field. @returns what the colours are of, their scale, and which values are marked */
  drawField(shown: Shown, colours: Drawing): { drawn: Field; scale: Scale | null; marks: number[] } {
    const { viewing } = this;
    const { drawn, scale } = this.coloured(shown);
    const besides = this.besides(shown);
    const options = this.optionsOf(drawn, shown.description!.box);
    const meshes = (pinned: boolean) => (shown.shapes?.meshes ?? []).filter(({ asked }) => (asked.of === 'pinned') === pinned);
    const sections = viewing.sensitivity ? null : shown.sections;
    this.fieldView.show(drawn, { ...options, sections, through: this.throughOf(shown), meshes: meshes(false), leaves: shown.shapes?.leaves ?? null }, scale, colours.edge);
    if (besides) this.baselineView.show(shown.pinned!.field, { ...options, meshes: meshes(true) }, scale, colours.edge);
    this.stage.split(besides ? { left: this.baseline, right: this.design } : null);
    this.baseline.visible = besides;
    this.design.visible = true;
    return { drawn, scale, marks: scale ? this.marks(drawn, scale) : [] };
  }

  private marks(field: Field, scale: Scale): number[] {
    const { viewing } = this;
    if (!field.parts.some((part) => part.kind === 'grid')) return [];
    const ends = viewing.body === 'between' ? endsOf(viewing, scale).filter((end) => end !== null) : [];
    return [...(viewing.surface ? [scale.at(viewing.level)] : []), ...ends];
  }

  /** The surface through samples, where it is of what is shown now. */
  private throughOf(shown: Shown): Field | null {
    const { viewing } = this;
    return viewing.through.method !== 'none' && shown.through?.of === coloured(viewing, shown) ? shown.through : null;
  }

  private optionsOf(field: Field, box: Box): FieldOptions {
    const { viewing } = this;
    return {
      slices: [0, 1, 2].filter((k) => viewing.slices[k]).map((axis) => ({ axis, at: viewing.at[axis]! })),
      raised: viewing.relief,
      cloud: viewing.body === 'volume' && field.parts.some((part) => part.kind === 'grid'),
      meshes: [],
      leaves: null,
      sections: null,
      through: null,
      box,
    };
  }

  /** The device, or the place of the field, that a ray meets. */
  pick(ray: Raycaster): { device: string | null } | { body: string } | { at: Vec3 } | null {
    const hit = ray
      .intersectObject(this.icons.group, true)
      .find(({ object }) => 'isMesh' in object && !seeThrough(object));
    if (hit) return { device: this.icons.nameOf(hit.object) };
    const at = this.fieldView.pick(ray);
    const body = this.room.pick(ray);
    const nearer = body && (!at || body.distance < ray.ray.origin.distanceTo(new Vector3(...at)));
    return nearer ? { body: body.path } : at && { at };
  }

  /** A distance that is seen: some sizes of an icon, rounded. */
  stepBeside({ description }: Shown): number {
    return Number((0.06 * sizeOf(description!)).toPrecision(1));
  }

  hasIcon(name: string | null): boolean {
    return this.icons.find(name) !== null;
  }

  lookThrough(device: Device): void {
    this.gizmo.hold(null);
    // From inside its housing nothing is seen.
    for (const icons of [this.icons, this.baselineIcons]) icons.hide(device.name);
    this.stage.lookThrough(device);
  }
}

/** In the middle of a body's bounds, turned as it is. */
function placeHandle(handle: Object3D, { vertices, R }: Solid): void {
  const ends = (k: number) => vertices.filter((_, i) => i % 3 === k).reduce(([low, high], x) => [Math.min(low!, x), Math.max(high!, x)], [Infinity, -Infinity]);
  handle.position.set(...([0, 1, 2].map((k) => (ends(k)[0]! + ends(k)[1]!) / 2) as Vec3));
  const [x, y, z] = R;
  handle.quaternion.setFromRotationMatrix(new Matrix4().set(...x, 0, ...y, 0, ...z, 0, 0, 0, 0, 1));
  handle.scale.set(1, 1, 1);
}

/** A frustum is no thing to click on. */
const seeThrough = (object: object) => (object as { material?: { transparent?: boolean } }).material?.transparent === true;

/** The least distance between two points of a lattice. */
function spacingOf(points: Vec3[]): number {
  const first = points[0]!;
  return Math.min(Infinity, ...points.slice(1).map((p) => Math.hypot(...p.map((x, k) => x - first[k]!)))) || 1;
}
