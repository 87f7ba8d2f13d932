// The whole answer about one point, in words and numbers.
import { h } from '../dom';
import { digits, percent, quantity } from '../quantity';
import type { Metric, PointReport, Vec3 } from '../server';

const share = (device: PointReport['point']['devices'][number], observable: boolean): string => {
  if (!device.visible) return "doesn't see it";
  if (device.share === null) return observable ? 'lost without it' : 'sees it';
  return `+${percent(device.share)}`;
};

export class Report {
  readonly element: HTMLElement;
  private readonly body = h('div', { className: 'report', id: 'report', 'aria-live': 'polite' });
  private readonly inputs: HTMLInputElement[];

  constructor(ask: (at: Vec3) => void, clear: () => void) {
    this.inputs = ['x', 'y', 'z'].map((axis) =>
      h('input', { type: 'text', 'aria-label': `${axis} of the point, metres`, placeholder: axis, inputMode: 'decimal' }),
    );
    const form = h(
      'form',
      {
        className: 'at',
        onsubmit: (event: Event) => {
          event.preventDefault();
          const at = this.inputs.map((input) => Number(input.value)) as Vec3;
          if (this.inputs.every((input) => input.value.trim() !== '') && at.every(Number.isFinite)) ask(at);
        },
      },
      ...this.inputs,
      h('button', { type: 'submit' }, 'Probe'),
    );
    this.element = h(
      'section',
      { className: 'panel probe' },
      h('h2', {}, 'One point'),
      form,
      this.body,
    );
    this.clear();
    this.inputs[0]!.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') clear();
    });
  }

  clear(): void {
    this.body.replaceChildren(
      h('p', { className: 'hint' }, 'Click a place in the picture, or type one, to ask all about it.'),
    );
    for (const input of this.inputs) input.value = '';
  }

  /** @param scale by which the ellipsoid is enlarged; 0: there is none */
  show(report: PointReport, metric: Metric, scale: number, sigmas: number): void {
    const { point, words } = report;
    point.at.forEach((x, k) => (this.inputs[k]!.value = digits(x, 4)));
    const rows = Object.entries(point.metrics)
      // Most devices have no pixels.
      .filter(([name, m]) => name !== 'footprint' || m.value !== null)
      .map(([name, m]) =>
        h(
          'tr',
          { className: name === metric.name ? 'chosen' : '', 'data-metric': name, 'data-value': m.value ?? '' },
          h('th', { scope: 'row' }, name),
          h('td', {}, quantity(m.value, m.unit)),
        ),
      );
    const most = Math.max(1e-12, ...point.devices.map((d) => d.share ?? 0));
    const devices = point.devices.map((d) => {
      const bar = h('span', { className: 'bar', 'aria-hidden': 'true' });
      bar.style.setProperty('--part', String(d.visible ? (d.share ?? (point.observable ? most : 0)) / most : 0));
      return h(
        'tr',
        { className: d.visible ? '' : 'unseen' },
        h('th', { scope: 'row' }, d.name, bar),
        h('td', {}, share(d, point.observable)),
      );
    });
    this.body.replaceChildren(
      h(
        'p',
        { className: point.observable ? 'state good' : 'state bad' },
        point.inside
          ? 'Inside a solid: no target can be here.'
          : point.observable
            ? 'Every direction is observed.'
            : 'Some directions are not observed.',
      ),
      ...words.map((line) => h('p', { className: 'lost' }, line)),
      h('table', {}, h('tbody', {}, ...rows)),
      h('h3', {}, `Without this device alone ${metric.name} gets worse by`),
      h('table', { className: 'shares' }, h('tbody', {}, ...devices)),
      ...(scale > 0
        ? [h('p', { className: 'hint' }, `The ellipsoid is ${sigmas} σ of the position, drawn ${digits(scale, 1)} times as large.`)]
        : []),
      ...(report.lost.length > 0 ? [h('p', { className: 'hint' }, 'Arrows point along what is lost of the position.')] : []),
    );
  }
}
