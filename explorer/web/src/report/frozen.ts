// A report's data, frozen into the page.
import { unpack, type Field } from '../field';
import { nothingShown, type Shown } from '../picture';
import type { ValueSearch } from '../searches';
import type { Around, BlindRegions, Box, Description, Lattice, Metric, Vec3, Worth } from '../server';

/** As reports pack a design; its field in base64. */
interface Design {
  description: Description;
  around: Around;
  field: string;
}

export interface Installation {
  walls: Box | null;
  samples: Box;
  devices: {
    name: string;
    at: Vec3;
    from: { wall: string; distance: number }[];
    /** Null: it looks all around, and has no angles. */
    aim: Vec3 | null;
    pan: number | null;
    tilt: number | null;
    roll: number | null;
    view: Vec3[];
  }[];
}

interface Common {
  headline: string;
  file: string;
  versions: { part: string; version: string }[];
  /** The scene, in SI units. */
  text: string;
  installation: Installation;
}

/** A region with what each device is to it, counted in samples. */
export type Region = BlindRegions['regions'][number] & {
  views: { device: string; sees: number; hidden: number; beyond: number }[];
};

export interface SceneReport extends Common {
  kind: 'scene';
  design: Design;
  /** The part of the samples that each device sees. */
  sees: Record<string, number>;
  worth: Worth;
  blind: { samples: number; count: number; regions: Region[] };
  lattice: Lattice;
}

export interface VariableAnswer {
  slope: number | null;
  down: number;
  up: number;
  down_is_bound: boolean;
  up_is_bound: boolean;
}

export interface Tradeoff {
  across: Pick<Metric, 'name' | 'unit'>;
  of_limit: boolean;
  objective: Pick<Metric, 'name' | 'unit'>;
  points: { across: number; used: number; objective: number; kept: boolean; dominated: boolean }[];
  cheapest: { devices: number; price: number } | null;
}

interface Act {
  verb: string;
  argument: string;
}

export interface StudyReport extends Common {
  kind: 'study';
  commands: string;
  before: Design;
  after: Design;
  difference: string;
  objective: Pick<Metric, 'name' | 'unit'> & { before: number | null; after: number | null; maximize: boolean };
  constraints: { name: string; words: string; satisfied: boolean; slack: number | null; unit: string }[];
  variables: { path: string; unit: string; before: number; after: number; lower: number; upper: number; locked: boolean }[];
  search: Pick<ValueSearch, 'rounds' | 'evaluations' | 'incumbents' | 'designs' | 'objective' | 'best'>;
  study: {
    rounds: { round: number; ended: boolean; evaluations: number; initial: number | null; best: number | null }[];
    acts: (Act & { act: number; after_round: number })[];
    waiting: Act[];
  };
  answers: { loss: number; variables: Record<string, VariableAnswer>; without: Record<string, number | null> } | null;
  consensus: {
    starts: number;
    layouts: { objective: number | null; distance: number }[];
    devices: Record<string, { pose: string; at: Vec3; shift: number; turn: number; part_of_chance: number }>;
  } | null;
  tradeoffs: Tradeoff[];
}

export type FrozenReport = SceneReport | StudyReport;

/** The report that this page is; null: it is the explorer itself. */
export function frozenReport(): FrozenReport | null {
  const text = document.getElementById('frozen')?.textContent;
  return text ? JSON.parse(text) : null;
}

const fieldOf = (base64: string): Field => unpack(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);

/** What has no history, and is changed by nobody. */
const described = (description: Description, pinned: number | null): Description => ({ ...description, revision: 0, undo: 0, redo: 0, surroundings: 0, pinned });

/** All that the picture shows of it; of a study the design that it came to, and the one that it
 * began with to compare with. */
export function shownOf(report: FrozenReport): Shown {
  if (report.kind === 'scene') {
    const { design, lattice, blind } = report;
    return { ...nothingShown(), description: described(design.description, null), around: design.around, field: fieldOf(design.field), lattice, blind };
  }
  const { before, after, difference } = report;
  return {
    ...nothingShown(),
    description: described(after.description, 0),
    around: after.around,
    field: fieldOf(after.field),
    difference: fieldOf(difference),
    pinned: { description: described(before.description, null), field: fieldOf(before.field) },
  };
}
