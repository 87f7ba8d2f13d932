// The design beside one that was kept.
import { h } from '../dom';
import type { Summary } from '../field';
import { percent, quantity } from '../quantity';
import type { Viewing } from '../viewing';

const modes: [Viewing['compare'], string, string][] = [
  ['design', 'design', 'The design alone'],
  ['difference', 'difference', 'The design minus what is pinned'],
  ['beside', 'side by side', 'What is pinned at the left, the design at the right'],
];

export class ComparePanel {
  readonly element: HTMLElement;
  private readonly pin: HTMLButtonElement;
  private readonly buttons: HTMLButtonElement[];
  private readonly group: HTMLElement;
  private readonly words = h('p', { className: 'difference', id: 'difference', role: 'status' });
  private pinned = false;

  constructor(
    private readonly viewing: Viewing,
    changed: () => void,
    /** Null: what is compared with stays. */
    pin: ((pinned: boolean) => void) | null,
  ) {
    this.pin = h('button', { type: 'button', id: 'pin', title: 'Keep this design to compare with (P)', hidden: !pin, onclick: () => pin?.(!this.pinned) }, 'Pin');
    this.buttons = modes.map(([mode, text, title]) =>
      h(
        'button',
        {
          type: 'button',
          title,
          'data-compare': mode,
          onclick: () => {
            viewing.compare = mode;
            changed();
          },
        },
        text,
      ),
    );
    this.group = h('div', { className: 'segments three', role: 'group', 'aria-label': 'Compare' }, ...this.buttons);
    this.element = h('div', { className: 'compare' }, this.pin, this.group, this.words);
  }

  /** @param summary of the difference; null: not known yet */
  show(pinned: boolean, summary: Summary | null): void {
    this.pinned = pinned;
    this.pin.textContent = pinned ? 'Unpin' : 'Pin';
    this.pin.setAttribute('aria-pressed', String(pinned));
    this.group.hidden = !pinned;
    this.buttons.forEach((b) => b.setAttribute('aria-pressed', String(b.dataset.compare === this.viewing.compare)));
    this.words.hidden = !pinned || !summary;
    if (!pinned || !summary) return;
    const { mean, min, max, metric, better, gained, lost, definition, pinned_definition: other } = summary;
    const signed = (value: number | null) => `${value !== null && value > 0 ? '+' : ''}${quantity(value, metric.unit)}`;
    const number = (name: string, value: number | null | undefined, text: string) =>
      h('span', { 'data-difference': name, 'data-value': value ?? '' }, `${name} `, h('b', {}, text));
    this.words.replaceChildren(
      this.pin.hidden ? 'against the design before: ' : 'against what is pinned: ',
      number('mean', mean, signed(mean)),
      ...(min && max ? [' from ', number('least', min.value, signed(min.value)), ' to ', number('greatest', max.value, signed(max.value))] : []),
      ', ',
      number('better', better, percent(better ?? 0)),
      ', ',
      number('gained', gained, String(gained)),
      ', ',
      number('lost', lost, String(lost)),
      other ? h('b', { className: 'unlike' }, `. Not alike: of the ${definition}, what is pinned of the ${other}`) : `; of the ${definition}`,
    );
  }
}
