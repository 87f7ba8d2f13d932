// A report: the explorer's picture with its data frozen, and the document below it.
import { h, iconButton } from '../dom';
import { applyTheme, type Theme } from '../theme';
import { shownOf, type FrozenReport } from './frozen';
import { FrozenPicture } from './frozenpicture';
import { paragraph } from './parts';
import { sceneDocument } from './scenedocument';
import { studyDocument } from './studydocument';

/** null: this browser draws none. */
function pictureOf(report: FrozenReport, shown: ReturnType<typeof shownOf>, theme: Theme): FrozenPicture | null {
  try {
    return new FrozenPicture(shown, report.kind === 'scene' ? report.worth : null, theme);
  } catch {
    return null;
  }
}

export function showReport(root: HTMLElement, report: FrozenReport): void {
  let theme: Theme = matchMedia('(prefers-color-scheme: light)').matches ? 'light' : 'dark';
  applyTheme(theme);
  const shown = shownOf(report);
  const { name } = shown.description!;
  const picture = pictureOf(report, shown, theme);
  const stills = document.getElementById('stills')!;
  document.body.classList.toggle('live', picture !== null);
  const turn = () => {
    theme = theme === 'dark' ? 'light' : 'dark';
    applyTheme(theme);
    picture?.paint(theme);
  };
  const article = report.kind === 'scene' ? sceneDocument(report, shown.field!, stills) : studyDocument(report, shown.pinned!.field, shown.field!, stills);
  root.append(
    h('header', { className: 'top' }, h('span', { className: 'brand' }, 'Delos'), h('span', { className: 'hint' }, report.file), h('span', { className: 'space' }), iconButton('theme', 'Dark or light', turn)),
    h('main', {}, h('h1', {}, name), paragraph(report.headline, 'answer'), picture?.element ?? paragraph('This browser draws no WebGL: pictures stand below instead.', 'note'), article),
  );
  picture?.begin();
}
