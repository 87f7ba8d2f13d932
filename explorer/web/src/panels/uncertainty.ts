// How well the position is known, as bodies; and where it isn't, with the reason.
import { h } from '../dom';
import { counted, digits } from '../quantity';
import type { BlindRegions } from '../server';
import type { Viewing } from '../viewing';
import { check, choice } from './details';

export class UncertaintyPanel {
  readonly element: HTMLElement;
  private readonly lattice: HTMLInputElement;
  private readonly blind: HTMLInputElement;
  private readonly sigmas: HTMLSelectElement;
  private readonly enlarged = h('p', { className: 'hint' });
  private readonly regions = h('ol', { className: 'regions', id: 'blind-regions' });

  constructor(
    private readonly viewing: Viewing,
    changed: () => void,
  ) {
    const set = (some: Partial<Viewing>) => {
      Object.assign(viewing, some);
      changed();
    };
    const [latticeLabel, lattice] = check('view-lattice', 'ellipsoids and lost directions', (on) => set({ lattice: on }));
    const [blindLabel, blind] = check('view-blind', 'blind regions', (on) => set({ blind: on }));
    const [sigmaRow, sigmas] = choice('view-sigmas', 'Ellipsoids of', { 1: '1 σ (20 %)', 2: '2 σ (74 %)', 3: '3 σ (97 %)' }, (n) => set({ sigmas: Number(n) }));
    [this.lattice, this.blind, this.sigmas] = [lattice, blind, sigmas];
    this.element = h('div', {}, h('div', { className: 'checks' }, latticeLabel, blindLabel), sigmaRow, this.enlarged, this.regions);
  }

  /** @param scale by which the lattice's ellipsoids are enlarged; 0: there are none */
  show(regions: BlindRegions | null, scale: number): void {
    const { viewing } = this;
    this.lattice.checked = viewing.lattice;
    this.blind.checked = viewing.blind;
    this.sigmas.value = String(viewing.sigmas);
    this.enlarged.textContent = viewing.lattice && scale > 0 ? `Ellipsoids are drawn ${digits(scale, 1)} times as large.` : '';
    this.regions.hidden = !viewing.blind || !regions;
    if (!regions) return;
    this.regions.replaceChildren(
      ...(regions.regions.length === 0 ? [h('li', {}, 'nothing is blind')] : []),
      ...regions.regions.map((r) => h('li', {}, h('b', {}, counted(r.samples, 'sample')), ` ${r.why}`)),
    );
  }
}
