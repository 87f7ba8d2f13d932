// What the server answers, and how it is asked.

export type Vec3 = [number, number, number];

/** A row of a plugin's table of parameters. */
export interface ParamSpec {
  name: string;
  kind: 'number' | 'choice' | 'vector' | 'matrix' | 'text';
  unit: string;
  default: number | string | null;
  scale?: 'linear' | 'log';
  choices?: string;
  lower: number | null;
  upper: number | null;
  help: string;
}

export interface DeviceType {
  id: string;
  summary: string;
  params: ParamSpec[];
}

export type ParamValue = number | string | number[] | number[][] | null;

export interface Device {
  name: string;
  type: string;
  rate: number;
  mount: 'world' | 'target';
  group: string;
  surface?: string;
  coordinates?: number[];
  at: Vec3;
  facing: '' | 'aim' | 'rpy' | 'quaternion_wxyz';
  value: number[];
  /** In the world; of what the target carries there is none. */
  pose?: { p: Vec3; R: [Vec3, Vec3, Vec3] };
  outline?: Vec3[];
  params: Record<string, ParamValue>;
}

export interface Box {
  min: Vec3;
  max: Vec3;
}

export interface Metric {
  name: string;
  unit: string;
  larger_is_better: boolean;
}

export interface Description {
  session?: string;
  revision: number;
  /** Another number whenever what stands around the devices is another. */
  surroundings: number;
  undo: number;
  redo: number;
  name: string;
  metric: Metric;
  metrics: string[];
  definition: string;
  fusion: string;
  box: Box;
  room: Box;
  devices: Device[];
  types: Record<string, DeviceType>;
  /** The revision that others are compared with; null: none. */
  pinned: number | null;
}

/** A body or a region, in the world. */
export interface Solid {
  name: string;
  /** "": a hand can't change it. */
  path: string;
  /** Of a box, along the axes of R. */
  size: Vec3 | null;
  R: [Vec3, Vec3, Vec3];
  vertices: number[];
  triangles: number[];
}

export interface Around {
  occluders: (Solid & { carried: boolean; room: boolean })[];
  regions: Solid[];
  /** Outlines and rails. */
  surfaces: Vec3[][];
  beacons: Vec3[];
}

/** A change that is offered. */
export interface Act {
  path: string;
  value: string;
  label: string;
  help: string;
}

/** A value of a scene, or a group of them: scene_form() of the server. */
export interface FormField {
  path: string;
  name: string;
  help: string;
  kind: 'number' | 'integer' | 'text' | 'choice' | 'group' | 'many';
  value?: number | string | null;
  unit?: string;
  lower?: number | null;
  upper?: number | null;
  words?: string[];
  known?: string[];
  members?: FormField[];
  add?: Act[];
  remove?: Setting;
  copy?: boolean;
  rename?: boolean;
}

export interface FormAnswer {
  sections: FormField[];
}

export interface PointReport {
  point: {
    at: Vec3;
    observable: boolean;
    inside: boolean;
    metrics: Record<string, { value: number | null; unit: string }>;
    devices: { name: string; type: string; visible: boolean; share: number | null }[];
  };
  words: string[];
  ellipsoid: Ellipsoid | null;
  lost: Vec3[];
}

/** Of one standard deviation of the position. */
export interface Ellipsoid {
  sigma: Vec3;
  axes: [Vec3, Vec3, Vec3];
}

export interface Lattice {
  points: { at: Vec3; ellipsoid: Ellipsoid | null; lost: Vec3[] }[];
}

export interface BlindRegions {
  samples: number;
  regions: { samples: number; box: Box; why: string }[];
}

/** A parallelogram origin + a·u + b·v. */
export interface Section {
  origin: Vec3;
  u: Vec3;
  v: Vec3;
}

/** What can be put into a scene. */
export interface Palette {
  types: { id: string; summary: string; ready: boolean }[];
  presets: { name: string; type: string; source: string }[];
}

export interface Worth {
  samples: number;
  devices: { name: string; blinded: number; lost: number; rise: number | null }[];
}

export interface SceneList {
  first: string | null;
  scenes: { id: string; about: string }[];
}

/** One value of the scene, by the path that `--set` would use. */
export interface Setting {
  path: string;
  value: string;
}

/** The server refused, and says why. */
export class Refusal extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
  }
}

async function post(verb: string, body: object, signal?: AbortSignal): Promise<Response> {
  const response = await fetch(`/api/${verb}`, {
    method: 'POST',
    headers: { 'Content-Type': 'application/json' },
    body: JSON.stringify(body),
    ...(signal ? { signal } : {}),
  });
  if (response.ok) return response;
  const text = await response.text();
  let message = text;
  try {
    const { error } = JSON.parse(text);
    const findings: string[] = error.findings.map((f: { message: string }) => f.message);
    message = findings.length > 0 ? findings.join('\n') : error.message;
  } catch {
    // Not the explorer's own words: shown as they are.
  }
  throw new Refusal(response.status, message);
}

export async function listScenes(): Promise<SceneList> {
  return (await fetch('/api/scenes')).json();
}

/** A design on the server, by the name of its session. */
export class Session {
  private constructor(readonly name: string) {}

  static async open(scene: string): Promise<[Session, Description]> {
    const description: Description = await (await post('open', { scene })).json();
    return [new Session(description.session!), description];
  }

  /** Go on with a design that an earlier load of the page had opened. */
  static async resume(name: string): Promise<[Session, Description]> {
    const session = new Session(name);
    return [session, await session.ask<Description>('describe')];
  }

  async ask<T>(verb: string, more: object = {}, signal?: AbortSignal): Promise<T> {
    return (await post(verb, { session: this.name, ...more }, signal)).json();
  }
  async bytes(verb: string, more: object, signal: AbortSignal): Promise<ArrayBuffer> {
    return (await post(verb, { session: this.name, ...more }, signal)).arrayBuffer();
  }
  async text(): Promise<string> {
    return (await post('text', { session: this.name })).text();
  }
}
