// What can be done, by name and by key.
import type { Command } from './commands';
import type { ViewName } from './view/eye';
import { methods } from './panels/through';
import type { Through, Viewing } from './viewing';

/** What commands do. */
export interface Doings {
  viewing: Viewing;
  viewed: () => void;
  look: (from: ViewName) => void;
  lookThrough: () => void;
  orthographic: () => void;
  move: (mode: 'translate' | 'rotate') => void;
  letGo: () => void;
  next: (step: number) => void;
  add: () => void;
  copy: () => void;
  array: () => void;
  mirror: (axis: 'x' | 'y') => void;
  remove: () => void;
  pin: (pinned: boolean) => void;
  undo: () => void;
  redo: () => void;
  save: () => void;
  open: () => void;
  theme: () => void;
  snap: () => void;
  turnToFaces: () => void;
  room: () => void;
  paint: () => void;
  nextBody: (step: number) => void;
  search: () => void;
  beginSearch: () => void;
  pauseSearch: () => void;
  keepSearch: () => void;
  rejectSearch: () => void;
  slice: (axis: number) => void;
  slant: () => void;
  commands: () => void;
  help: () => void;
  hasScene: () => boolean;
  hasDevice: () => boolean;
  hasBody: () => boolean;
  hasPin: () => boolean;
}

const throughs = Object.keys(methods) as Through['method'][];
const bodies: Viewing['body'][] = ['none', 'volume', 'between'];
const comparisons: Viewing['compare'][] = ['design', 'difference', 'beside'];
const views: [ViewName, string, string][] = [
  ['corner', 'f', 'Look at the whole room'],
  ['top', '7', 'Look from above'],
  ['below', 'ctrl+7', 'Look from below'],
  ['front', '1', 'Look from the front'],
  ['back', 'ctrl+1', 'Look from the back'],
  ['side', '3', 'Look from the right'],
  ['left', 'ctrl+3', 'Look from the left'],
];

const after = <T>(all: T[], one: T): T => all[(all.indexOf(one) + 1) % all.length]!;

export function commandsOf(doings: Doings): Command[] {
  const { viewing, hasScene, hasDevice, hasPin } = doings;
  const show = (name: string, keys: string[], change: () => void): Command => ({
    name,
    keys,
    ready: hasScene,
    run: () => {
      change();
      doings.viewed();
    },
  });
  const toggle = (name: string, key: string, what: 'surface' | 'lattice' | 'blind' | 'logarithmic' | 'frusta' | 'names' | 'reversed' | 'relief' | 'cells') =>
    show(name, key ? [key] : [], () => (viewing[what] = !viewing[what]));
  const device = (name: string, keys: string[], run: () => void): Command => ({ name, keys, run, ready: hasDevice });
  const held = (name: string, keys: string[], run: () => void): Command => ({ name, keys, run, ready: () => hasDevice() || doings.hasBody() });
  const scene = (name: string, keys: string[], run: () => void): Command => ({ name, keys, run, ready: hasScene });
  const level = (by: number) => () => (viewing.level = Math.min(1, Math.max(0, viewing.level + by)));
  return [
    { name: 'All commands', keys: ['ctrl+k', '/'], run: doings.commands },
    scene('Undo', ['ctrl+z'], doings.undo),
    scene('Redo', ['ctrl+y', 'ctrl+shift+z'], doings.redo),
    { name: 'Open a scene', keys: ['o'], run: doings.open },
    scene('Save as a scene file', ['ctrl+s'], doings.save),
    scene('Choose the next device', ['j'], () => doings.next(1)),
    scene('Choose the device before', ['k'], () => doings.next(-1)),
    scene('Let go', ['escape'], doings.letGo),
    scene('Add a device', ['a'], doings.add),
    device('Copy the chosen device', ['d'], doings.copy),
    device('Copy the chosen device along a row or around a circle', ['shift+d'], doings.array),
    device('Mirror the chosen device across x', ['m'], () => doings.mirror('x')),
    device('Mirror the chosen device across y', ['shift+m'], () => doings.mirror('y')),
    device('Remove the chosen device', ['delete'], doings.remove),
    held('Move the chosen device or body', ['g'], () => doings.move('translate')),
    held('Turn the chosen device, size the chosen box', ['r'], () => doings.move('rotate')),
    device('Look through the chosen device', ['0'], doings.lookThrough),
    scene('Snap to 5 cm, 5 degrees and faces', ['n'], doings.snap),
    scene('Turn a device to the face that it snaps to, or not', ['t'], doings.turnToFaces),
    scene('The room: open, close', ['w'], doings.room),
    scene('Draw a box on the slice or the floor', ['shift+b'], doings.paint),
    scene('Choose the next body or region', ['shift+j'], () => doings.nextBody(1)),
    scene('Choose the body or region before', [], () => doings.nextBody(-1)),
    ...views.map(([from, key, name]) => scene(name, [key], () => doings.look(from))),
    scene('Without perspective, or with', ['5'], doings.orthographic),
    ...['x', 'y', 'z'].map((axis, k) => scene(`Slice across ${axis}`, [axis], () => doings.slice(k))),
    scene('Add a slanted slice', ['shift+x'], doings.slant),
    toggle('Heights: slices as high as their values', 'h', 'relief'),
    toggle('Octree cells', 'shift+c', 'cells'),
    toggle('Surface', 'i', 'surface'),
    show('Raise the level of the surface', [']'], level(0.02)),
    show('Lower the level of the surface', ['['], level(-0.02)),
    show('Samples as a surface: by the next method', ['shift+i'], () => (viewing.through.method = after(throughs, viewing.through.method))),
    show('Volume: not drawn, a cloud, between two values', ['v'], () => (viewing.body = after(bodies, viewing.body))),
    toggle('Logarithmic colours', 'l', 'logarithmic'),
    toggle('Dark is good', '', 'reversed'),
    toggle('Ellipsoids and lost directions', 'e', 'lattice'),
    toggle('Blind regions', 'b', 'blind'),
    toggle('Frusta', 'shift+f', 'frusta'),
    toggle('Names', 'shift+n', 'names'),
    scene('Pin this design, or unpin', ['p'], () => doings.pin(!hasPin())),
    { ...show('Compare: the design, the difference, side by side', ['c'], () => (viewing.compare = after(comparisons, viewing.compare))), ready: hasPin },
    scene('Search for a better design: open, close', ['s'], doings.search),
    scene('Begin the search', ['ctrl+enter'], doings.beginSearch),
    scene('Pause the search, or go on', ['shift+s'], doings.pauseSearch),
    scene('Keep the best that the search found', ['shift+k'], doings.keepSearch),
    scene('Take back what the search found', ['shift+r'], doings.rejectSearch),
    { name: 'Dark or light', keys: ['shift+t'], run: doings.theme },
    { name: 'Keys and mouse', keys: ['?'], run: doings.help },
  ];
}
