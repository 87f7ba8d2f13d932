// A scene as it stands, below its picture.
import { h } from '../dom';
import type { Field } from '../field';
import { counted } from '../quantity';
import type { Box, Description, Vec3 } from '../server';
import type { Region, SceneReport } from './frozen';
import { installersSheet } from './installation';
import { keyFigures } from './keyfigures';
import { listing, paragraph, saidChange, saidCount, section, table, type Cell } from './parts';
import { quoted, versions } from './provenance';

const coordinates = (p: Vec3) => `(${p.map((x) => Number(x.toPrecision(3))).join(', ')})`;
const between = ({ min, max }: Box) => `${coordinates(min)} to ${coordinates(max)} m`;

/** "8 pinhole_camera, 1 imu" */
function kinds({ devices }: Description): string {
  const counts = new Map<string, number>();
  for (const { type } of devices) counts.set(type, (counts.get(type) ?? 0) + 1);
  return [...counts].map(([type, n]) => `${n} ${type}`).join(', ');
}

function facts({ design: { description, around } }: SceneReport, field: Field): HTMLElement {
  const { summary } = field;
  const rows: Cell[][] = [
    ['metric', `${summary.metric.name} of the ${field.definition}`],
    ['devices', kinds(description)],
    ['samples', `${summary.samples} within ${between(description.box)}`],
    ['hides the view', around.occluders.length > 0 ? around.occluders.map((o) => o.name).join(', ') : 'nothing'],
    ...(around.beacons.length > 0 ? [['beacons', counted(around.beacons.length, 'beacon')]] : []),
  ];
  return table('facts', 'The scene', ['', ''], rows);
}

function devices({ design: { description }, sees, worth }: SceneReport): HTMLElement {
  const of = new Map(worth.devices.map((d) => [d.name, d]));
  const rise = (name: string): Cell => {
    const one = of.get(name);
    if (!one) return '';
    return one.rise === null ? { text: one.blinded > 0 ? 'all is lost' : 'undefined', value: null } : saidChange(one.rise);
  };
  const rows = description.devices.map((d): Cell[] => [
    d.name,
    d.type,
    d.pose ? `${coordinates(d.pose.p)} m` : `on the target, ${coordinates(d.at)} m`,
    { text: `${Number((100 * (sees[d.name] ?? 0)).toPrecision(3))} %`, value: sees[d.name] ?? 0 },
    of.has(d.name) ? saidCount(of.get(d.name)!.lost) : '',
    rise(d.name),
  ]);
  const alone = worth.devices.length === 0 ? '. There is but one, which is worth all' : `, both over ${counted(worth.samples, 'sample')}`;
  return table(
    'devices',
    `What each device sees, and what its failure alone would cost: samples that are no longer observable, and by how much the mean of ${description.metric.name} over those that remain gets worse${alone}`,
    ['device', 'type', 'at', 'sees', 'samples lost', 'mean'],
    rows,
  );
}

function those({ samples, views }: Region, key: 'sees' | 'hidden' | 'beyond'): string {
  const all = views.filter((v) => v[key] > 0).map((v) => v.device + (v[key] === samples ? '' : ` (${v[key]})`));
  return all.length > 0 ? all.join(', ') : '—';
}

function blindRegions({ blind }: SceneReport): HTMLElement[] {
  const { regions } = blind;
  if (regions.length === 0) return [paragraph('None: every sample outside solids is observable.')];
  const rows = regions.map((r): Cell[] => [String(r.samples), between(r.box), r.why, those(r, 'sees'), those(r, 'hidden'), those(r, 'beyond')]);
  const rest = blind.samples - regions.reduce((sum, r) => sum + r.samples, 0);
  return [
    table(
      'blind',
      'Neighbouring samples that aren’t observable, the largest region first. Numbers in brackets: samples of the region, where it isn’t all of it',
      ['samples', 'from, to', 'why', 'seen by', 'hidden from', 'outside the view of'],
      rows,
    ),
    ...(rest > 0 ? [paragraph(`And ${counted(blind.count - regions.length, 'smaller region')} with ${counted(rest, 'sample')}.`, 'note')] : []),
  ];
}

export function sceneDocument(report: SceneReport, field: Field, stills: HTMLElement): HTMLElement {
  const file = quoted(report.file);
  const drawn = field.values.length < field.summary.samples ? paragraph(`The picture is of ${field.values.length} samples; the figures are of all.`, 'note') : null;
  return h(
    'article',
    {},
    section('The field', facts(report, field), stills, drawn, keyFigures([field], [field.summary.metric.name])),
    section('Devices', devices(report)),
    section('To install it', installersSheet(report.installation)),
    section('Blind regions, and why', ...blindRegions(report)),
    section(
      'To compute it again',
      listing('Commands', `delos field ${file}\ndelos report ${file} -o report.html`),
      versions(report.versions),
      h('h3', {}, 'The scene, in SI units'),
      listing('Scene file', report.text),
    ),
  );
}
