// The list of devices, with what each is worth to the whole room.
import { h } from '../dom';
import { counted, percent } from '../quantity';
import type { Description, Worth } from '../server';

/** Parts that differ by no more are those of devices that mirror each other. */
const same = 1e-6;

type Entry = Worth['devices'][number];

/** The part by which the picture gets worse without a device: what goes blind counts as
 * lost altogether. */
const loss = (entry: Entry, samples: number) =>
  Math.max(0, entry.blinded / Math.max(1, samples) + Math.max(0, entry.rise ?? 0));

function words(entry: Entry, metric: string): string {
  const rise = entry.rise ?? 0;
  const mean =
    Math.abs(rise) < same
      ? ''
      : `the mean of ${metric} gets ${rise > 0 ? 'worse' : 'better'} by ${percent(Math.abs(rise))}`;
  const blind = entry.blinded > 0 ? `${counted(entry.blinded, 'sample')} more go blind` : '';
  return [mean, blind].filter(Boolean).join(' and ');
}

export class Devices {
  readonly element: HTMLElement;
  private readonly list = h('ul', { className: 'devices', 'aria-label': 'Devices' });
  private readonly verdict = h('p', { className: 'verdict', id: 'verdict', role: 'status' });
  private worth: Worth | null = null;
  private description: Description | null = null;
  private selected: string | null = null;

  constructor(
    private readonly select: (name: string | null) => void,
    /** Null: none can be added. */
    add: (() => void) | null,
  ) {
    this.element = h(
      'section',
      { className: 'panel grow' },
      h(
        'header',
        {},
        h('h2', {}, 'Devices'),
        add && h('button', { type: 'button', id: 'add-device', title: 'Add a device (A)', onclick: add }, 'Add…'),
      ),
      this.verdict,
      this.list,
    );
  }

  show(description: Description, selected: string | null): void {
    const names = (d: Description | null) =>
      d && [d.name, d.metric.name, ...d.devices.map((x) => x.name)].join('\n');
    const others = names(description) !== names(this.description);
    if (others) this.worth = null;
    const unchanged = !others && selected === this.selected;
    this.description = description;
    this.selected = selected;
    if (!unchanged) this.render();
  }

  /** What they are worth. */
  value(worth: Worth): void {
    this.worth = worth;
    this.element.dataset.stale = 'false';
    this.render();
  }

  /** Nobody has weighed them. */
  unweighed(): void {
    this.verdict.hidden = true;
    this.element.dataset.weighed = 'false';
  }

  /** Something has changed: what stands there is of before, until it is worked out anew. */
  stale(): void {
    this.element.dataset.stale = 'true';
  }

  private verdictOn(least: Entry[], metric: string): (Node | string)[] {
    if (this.worth?.devices.length === 0) return ['Its only device is worth all.'];
    if (least.length === 0) return [];
    const loses = words(least[0]!, metric) || 'nothing changes';
    const names = least.slice(0, 4).flatMap((d, k) => [k > 0 ? ', ' : '', h('b', {}, d.name)]);
    return least.length === 1
      ? [...names, ' is worth least: without it ', loses, '.']
      : [...names, least.length > 4 ? ', … ' : ' ', 'are worth least, each the same: without it ', loses, '.'];
  }

  private render(): void {
    if (!this.description) return;
    const { devices, metric } = this.description;
    const focused = this.list.contains(document.activeElement);
    const byName = new Map(this.worth?.devices.map((d) => [d.name, d]));
    const samples = this.worth?.samples ?? 1;
    const [least] = [...byName.values()].sort((a, b) => loss(a, samples) - loss(b, samples));
    const most = Math.max(
      1e-12,
      ...[...byName.values()].map((d) => loss(d, samples)),
    );
    const alike = least
      ? [...byName.values()].filter((d) => loss(d, samples) - loss(least, samples) < same)
      : [];
    this.verdict.replaceChildren(...this.verdictOn(alike, metric.name));
    this.verdict.dataset.least = least?.name ?? '';
    this.list.replaceChildren(
      ...devices.map((device) => {
        const entry = byName.get(device.name);
        const bar = h('span', { className: 'bar', 'aria-hidden': 'true' });
        if (entry) bar.style.setProperty('--part', String(loss(entry, samples) / most));
        const title = entry
          ? `Without ${device.name} ${words(entry, metric.name) || 'nothing changes'}`
          : device.type;
        const button = h(
          'button',
          {
            type: 'button',
            title,
            className: entry && alike.includes(entry) ? 'least' : '',
            'aria-pressed': String(device.name === this.selected),
            'data-device': device.name,
            onclick: () => this.select(device.name === this.selected ? null : device.name),
          },
          h('span', { className: 'name' }, device.name),
          h('span', { className: 'type' }, device.type.replaceAll('_', ' ')),
          bar,
        );
        return h('li', {}, button);
      }),
    );
    if (focused)
      this.list.querySelector<HTMLElement>(`[data-device="${CSS.escape(this.selected ?? '')}"]`)?.focus();
  }
}
