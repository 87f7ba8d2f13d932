// The best objective against the limit of a constraint, or the number of devices.
import { h } from '../dom';
import { frontFigure } from '../panels/searchfront';
import { digits } from '../quantity';
import type { Tradeoff } from './frozen';
import { paragraph, said, section, table, verdict, type Cell } from './parts';

const size = { width: 760, height: 260 };

export function tradeoffSection({ across, of_limit, objective, points, cheapest }: Tradeoff): HTMLElement {
  const rows = points.map((p): Cell[] => [
    said(p.across, across.unit, 4).text,
    said(p.used, of_limit ? across.unit : '1', 4),
    said(p.objective, objective.unit, 4),
    p.kept ? (p.dominated ? 'yes, but no better than a tighter limit' : 'yes') : verdict(false, 'no'),
  ]);
  const spots = points.map((p) => ({ ...p, x: of_limit && p.kept ? p.used : p.across }));
  return section(
    of_limit ? `Accuracy against ${across.name}` : 'Accuracy against the number of devices',
    points.length > 0 && h('figure', {}, frontFigure(spots, objective, across, size).figure, h('figcaption', {}, 'Each point is a search of its own.')),
    !of_limit &&
      paragraph(
        cheapest
          ? `The cheapest kit that keeps all constraints has ${cheapest.devices} devices, at a price of ${digits(cheapest.price)}.`
          : 'None of these kits keeps all constraints.',
        'answer',
      ),
    table(
      `front-${across.name}`,
      'Best designs',
      [of_limit ? `${across.name} at the limit` : 'devices', of_limit ? 'used' : 'price', objective.name, 'all constraints kept'],
      rows,
    ),
  );
}
