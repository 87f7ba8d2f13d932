// The panel of what is shown.
import { h } from '../dom';
import type { Field } from '../field';
import type { Scale } from '../scale';
import type { BlindRegions } from '../server';
import type { Shapes } from '../shapes';
import type { Viewing } from '../viewing';
import { BodiesPanel } from './bodies';
import { ColouringPanel } from './colouring';
import { check, details } from './details';
import { ReliefPanel } from './relief';
import { SensitivityPanel } from './sensitivity';
import { SlicesPanel } from './slices';
import { ThroughPanel } from './through';
import { UncertaintyPanel } from './uncertainty';

export class ViewingPanel {
  readonly element: HTMLElement;
  readonly slices: SlicesPanel;
  readonly sensitivity: SensitivityPanel;
  private readonly through: ThroughPanel;
  private readonly bodies: BodiesPanel;
  private readonly colouring: ColouringPanel;
  private readonly uncertainty: UncertaintyPanel;
  private readonly relief: ReliefPanel;
  private readonly frusta: HTMLInputElement;
  private readonly names: HTMLInputElement;
  private readonly cells: HTMLInputElement;
  private readonly cellsLabel: HTMLElement;
  private readonly cellCount = h('span', { id: 'cell-count' });

  constructor(
    private readonly viewing: Viewing,
    private readonly changed: () => void,
  ) {
    this.slices = new SlicesPanel(viewing, changed);
    this.sensitivity = new SensitivityPanel(viewing, changed);
    this.relief = new ReliefPanel(viewing, changed);
    this.through = new ThroughPanel(viewing, changed);
    this.bodies = new BodiesPanel(viewing, changed);
    this.colouring = new ColouringPanel(viewing, changed);
    this.uncertainty = new UncertaintyPanel(viewing, changed);
    const [frustaLabel, frusta] = check('view-frusta', 'frusta', (on) => this.set({ frusta: on }));
    const [namesLabel, names] = check('view-names', 'names', (on) => this.set({ names: on }));
    const [cellsLabel, cells] = check('view-cells', 'octree cells', (on) => this.set({ cells: on }));
    [this.frusta, this.names, this.cells, this.cellsLabel] = [frusta, names, cells, cellsLabel];
    cellsLabel.append(this.cellCount);
    this.element = h(
      'section',
      { className: 'panel viewing' },
      h('h2', {}, 'View'),
      this.slices.element,
      this.relief.element,
      this.through.element,
      this.bodies.element,
      this.sensitivity.element,
      h('div', { className: 'checks' }, frustaLabel, namesLabel, cellsLabel),
      details('Colours', true, this.colouring.element),
      details('Uncertainty', false, this.uncertainty.element),
    );
  }

  set(some: Partial<Viewing>): void {
    Object.assign(this.viewing, some);
    this.changed();
  }

  /** @param size of the room, metres */
  show(field: Field, through: Field | null, scale: Scale | null, regions: BlindRegions | null, enlarged: number, size: number, shapes: Shapes | null): void {
    this.slices.show(field);
    this.through.show(field, through?.summary ?? null);
    const flat = field.parts.some(({ kind }) => kind === 'grid' || kind === 'plane');
    this.relief.show(size, flat && scale !== null);
    this.bodies.show(field, scale, shapes);
    this.colouring.show(field);
    this.uncertainty.show(regions, enlarged);
    this.frusta.checked = this.viewing.frusta;
    this.names.checked = this.viewing.names;
    this.cells.checked = this.viewing.cells;
    this.cellsLabel.hidden = field.leaves === 0;
    this.cellCount.textContent = shapes?.leaves ? ` (${shapes.leaves.count} of ${field.leaves})` : '';
  }
}
