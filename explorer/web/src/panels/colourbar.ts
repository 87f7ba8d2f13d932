// The colour bar: what the colours mean, from where to where.
import { h } from '../dom';
import type { Field } from '../field';
import { displayUnit, labelling, raised, type Units } from '../quantity';
import type { Scale } from '../scale';

export class ColourBar {
  readonly element: HTMLElement;
  private readonly title = h('div', { className: 'bar-title' });
  private readonly strip = h('div', { className: 'strip' });
  private readonly ticks = h('div', { className: 'ticks' });
  private readonly blind = h('div', { className: 'blind-key' });

  constructor() {
    this.element = h(
      'figure',
      { className: 'colour-bar', id: 'colour-bar', 'aria-label': 'Colour bar' },
      this.title,
      h('div', { className: 'bar-body' }, this.strip, this.ticks),
      this.blind,
    );
  }

  /** @param marks values that are shown: the surface's, the interval's ends */
  show(field: Field, scale: Scale | null, marks: number[], units: Units): void {
    const { summary } = field;
    this.element.dataset.min = scale ? String(scale.min) : '';
    this.element.dataset.max = scale ? String(scale.max) : '';
    this.element.dataset.level = field.level;
    const without = summary.samples - summary.finite;
    const { gained, lost } = summary;
    const key = (className: string, text: string) => [h('span', { className, 'aria-hidden': 'true' }), text];
    this.blind.replaceChildren(
      ...(gained === undefined || lost === undefined
        ? key('hatch', without > 0 ? `blind: ${without} of ${summary.samples}` : 'blind: none')
        : [
            ...key('hatch', `${summary.sensitivity ? 'no slope' : 'blind in both'}: ${without - gained - lost}`),
            ...key('hatch gained', `seen only ${summary.sensitivity ? 'with more' : 'now'}: ${gained}`),
            ...key('hatch lost', `seen only ${summary.sensitivity ? 'with less' : 'before'}: ${lost}`),
          ]),
    );
    if (!scale) {
      this.title.replaceChildren(h('b', {}, summary.metric.name), ' is finite nowhere');
      this.strip.style.background = '';
      this.ticks.replaceChildren();
      return;
    }
    const unit = displayUnit(scale.max, summary.metric.unit);
    const { name, of: label } = labelling(scale.difference && units === 'log10' ? 'si' : units, scale.max, summary.metric.unit);
    this.title.replaceChildren(
      summary.sensitivity ? 'slope of ' : scale.difference ? 'change of ' : '',
      h('b', {}, summary.metric.name),
      name ? ` in ${raised(name)}` : '',
    );
    const stops = Array.from({ length: 25 }, (_, k) => scale.css(scale.at(k / 24)));
    this.strip.style.background = `linear-gradient(to top, ${stops.join(', ')})`;
    const mark = (value: number, className: string, label: string) => {
      const tick = h('span', { className }, label);
      tick.style.bottom = `${100 * scale.part(value)}%`;
      return tick;
    };
    const ends = scale.max > scale.min ? [scale.min, scale.max] : [scale.min];
    const shown = [...(scale.difference ? [0] : []), ...marks];
    // A label gives way to one that matters more.
    const apart = (from: number[]) => (v: number) => from.every((other) => Math.abs(scale.part(v) - scale.part(other)) > 0.06);
    const round = units === 'log10' && scale.min > 0 ? scale.powers() : scale.ticks(unit.factor);
    const inner = round.filter(apart([...ends, ...shown]));
    this.ticks.replaceChildren(
      ...inner.map((v) => mark(v, 'tick', label(v))),
      ...ends.filter(apart(shown)).map((v) => mark(v, 'tick end', label(v))),
      ...(scale.difference ? [mark(0, 'level zero', '0')] : []),
      ...marks.map((level) => mark(level, 'level', label(level))),
    );
  }
}
