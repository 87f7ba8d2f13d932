// A search, below the picture of the design that it came to.
import { h } from '../dom';
import type { Field } from '../field';
import { parallelCoordinates } from '../panels/parallel';
import { searchCurve } from '../panels/searchcurve';
import { counted, quantity } from '../quantity';
import type { StudyReport, VariableAnswer } from './frozen';
import { installersSheet } from './installation';
import { keyFigures } from './keyfigures';
import { listing, paragraph, said, saidChange, saidCount, section, table, verdict, type Cell } from './parts';
import { versions } from './provenance';
import { tradeoffSection } from './tradeoff';

const figure = (plot: SVGSVGElement, caption: string) => h('figure', {}, plot, h('figcaption', {}, caption));
const curve = { width: 760, height: 260 };

function question({ objective, variables, constraints, after }: StudyReport): HTMLElement[] {
  const locked = variables.filter((v) => v.locked).length;
  const text =
    `Make the ${objective.name} ${objective.maximize ? 'large' : 'small'} by changing ${counted(variables.length - locked, 'variable')} of ` +
    `${counted(after.description.devices.length, 'device')}${locked > 0 ? ` (${locked} more are locked)` : ''}`;
  if (constraints.length === 0) return [paragraph(`${text}.`)];
  return [paragraph(`${text}, such that`), h('ul', {}, ...constraints.map((c) => h('li', {}, h('b', {}, c.name), `: ${c.words}.`)))];
}

/** Acts end a round: where they stand among all evaluations. */
function actsOf({ study: { rounds, acts } }: StudyReport) {
  const before = (round: number) => rounds.filter((r) => r.round <= round).reduce((sum, r) => sum + r.evaluations, 0);
  return acts.map((a) => ({ evaluation: before(a.after_round), text: `${a.verb} ${a.argument}` }));
}

function convergence(report: StudyReport): HTMLElement[] {
  const { search, study, variables } = report;
  if (search.designs.length === 0) return [paragraph('Nothing has been evaluated so far.')];
  const unitOf = (path: string) => variables.find((v) => v.path === path)?.unit ?? '1';
  const rounds = study.rounds.length > 1 ? ' Every round begins anew; dashed lines are acts of a person.' : '';
  const lines = parallelCoordinates(search, unitOf, curve);
  return [
    figure(
      searchCurve(search, curve, actsOf(report)),
      `${search.objective.name}: what was best as steps, designs that were looked at as dots, start after start, on the samples of the search. ` +
        `Designs that were looked at with soft edges (faint), or that break a constraint, don’t count as best.${rounds}`,
    ),
    ...(lines ? [figure(lines, 'Variables from their least to their greatest value: all designs faint, those that were the best of their time clearer, the best strong.')] : []),
  ];
}

function constraints(report: StudyReport): HTMLElement {
  const rows = report.constraints.map((c): Cell[] => [c.name, c.words, verdict(c.satisfied, c.satisfied ? 'kept' : 'NOT kept'), said(c.slack, c.unit)]);
  return table('constraints', 'On all samples; below zero, so much is missing', ['constraint', 'demand', '', 'slack'], rows);
}

/** How far a variable may move, "−12 mm to +3 mm". */
const tolerance = (a: VariableAnswer, unit: string) =>
  `−${quantity(a.down, unit)}${a.down_is_bound ? ' (bound)' : ''} to +${quantity(a.up, unit)}${a.up_is_bound ? ' (bound)' : ''}`;

function design({ variables, answers, objective }: StudyReport): HTMLElement {
  const rows = variables.map((v): Cell[] => {
    const note = v.locked ? ' (locked)' : v.after === v.lower ? ' (least)' : v.after === v.upper ? ' (greatest)' : '';
    const after = said(v.after, v.unit, 4);
    const row: Cell[] = [v.path, said(v.before, v.unit, 4), { ...after, text: after.text + note }, `${quantity(v.lower, v.unit, 4)} to ${quantity(v.upper, v.unit, 4)}`];
    if (!answers) return row;
    const answer = answers.variables[v.path];
    // How much of the objective the whole range would be worth at this slope.
    const worth = answer && answer.slope !== null && objective.after ? (answer.slope * (v.upper - v.lower)) / Math.abs(objective.after) : null;
    return [...row, answer ? tolerance(answer, v.unit) : '', worth === null ? '' : { text: `${Number((100 * worth).toPrecision(2))} %`, value: worth }];
  });
  const told = answers
    ? `. May move by: alone, for under ${Number((100 * answers.loss).toPrecision(3))} % loss and with all constraints kept. Slope: of the objective, relative to it, times the variable’s whole range`
    : '';
  return table('variables', `All variables${told}`, ['variable', 'before', 'after', 'bounds', ...(answers ? ['may move by', 'slope'] : [])], rows);
}

function failures({ answers }: StudyReport): HTMLElement | null {
  const all = Object.entries(answers?.without ?? {});
  if (all.length === 0) return null;
  const rows = all.map(([name, rise]): Cell[] => [name, saidChange(rise, 'undefined')]);
  return section('If one device fails', table('failures', 'Rise of the objective where a device alone is missing', ['device', 'objective'], rows));
}

function consensus({ consensus, objective }: StudyReport): HTMLElement | null {
  if (!consensus) return null;
  const layouts = consensus.layouts.map((l, k): Cell[] => [String(k + 1), said(l.objective, objective.unit), said(l.distance, 'm')]);
  const devices = Object.entries(consensus.devices).map(([name, d]): Cell[] => [
    name,
    d.pose,
    { text: `${Number((100 * d.part_of_chance).toPrecision(2))} %`, value: d.part_of_chance },
    said(d.shift, 'm'),
    said(d.turn, 'rad'),
    `(${d.at.map((x) => Number(x.toPrecision(3))).join(', ')}) m`,
  ]);
  return section(
    'What the best layouts have in common',
    table('layouts', `Distinct layouts among the best designs of ${counted(consensus.starts, 'start')}; devices of one kind are interchangeable`, ['layout', 'objective', 'from the best'], layouts),
    layouts.length < 2
      ? paragraph('One layout says nothing of what is settled.')
      : table(
          'settled',
          'Settled: a device varies over these layouts less than a quarter as much as over random designs; free: more than three fifths',
          ['device', 'pose', 'varies', 'moves by', 'turns by', 'in the best, at'],
          devices,
        ),
  );
}

function history({ study: { rounds, acts, waiting }, objective }: StudyReport): HTMLElement[] {
  const words = (all: { verb: string; argument: string }[]) => all.map((a) => `${a.verb} ${a.argument}`).join('; ');
  const rows = rounds.map((r): Cell[] => {
    const value = (v: number | null) => (r.ended ? said(v, objective.unit) : 'not at its end');
    return [String(r.round), words(acts.filter((a) => a.after_round === r.round - 1)) || '—', saidCount(r.evaluations), value(r.initial), value(r.best)];
  });
  return [
    table('rounds', 'Rounds, each with the acts that it began with', ['round', 'acts', 'evaluations', 'from', 'to'], rows),
    ...(waiting.length > 0 ? [paragraph(`For the next round: ${words(waiting)}.`)] : []),
  ];
}

export function studyDocument(report: StudyReport, before: Field, after: Field, stills: HTMLElement): HTMLElement {
  return h(
    'article',
    {},
    section('The question', ...question(report)),
    section('Before and after', keyFigures([before, after], ['before', 'after']), stills),
    section('Convergence', ...convergence(report)),
    report.constraints.length > 0 && section('Constraints', constraints(report)),
    section('The design', design(report)),
    failures(report),
    section('To install it', installersSheet(report.installation)),
    consensus(report),
    ...report.tradeoffs.map(tradeoffSection),
    section('Rounds and acts', ...history(report)),
    section(
      'To compute it again',
      paragraph('Acts hold from the end of a round here, and a round that was cut short by an act ends where it was.'),
      listing('Commands', report.commands),
      versions(report.versions),
      h('h3', {}, 'The best scene, in SI units'),
      listing('Scene file', report.text),
    ),
  );
}
