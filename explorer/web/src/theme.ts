// Dark or light, for the page and for what is drawn.
import { blindColours } from './view/uniforms';

export type Theme = 'dark' | 'light';

const drawn = {
  dark: {
    background: '#14171f',
    blindA: '#6a7180',
    blindB: '#343a47',
    solid: '#0a0b10',
    lines: '#8791a5',
    faint: '#2a303d',
    bodies: '#8d99b3',
    beacons: '#ffb454',
    region: '#6fc3d0',
    device: '#d5dbe8',
    selected: '#ff8f4a',
    sight: '#a9b4c9',
    probe: '#ff5d8f',
    lost: '#ff5d5d',
    edge: '#e8ecf4',
  },
  light: {
    background: '#f4f5f8',
    blindA: '#a4abb8',
    blindB: '#dfe3ea',
    solid: '#ffffff',
    lines: '#6b7486',
    faint: '#d5dae3',
    bodies: '#7d879b',
    beacons: '#b45f00',
    region: '#0f7285',
    device: '#3c4454',
    selected: '#ad4207',
    sight: '#76809a',
    probe: '#c2185b',
    lost: '#c01818',
    edge: '#2b3140',
  },
};
export type Drawing = (typeof drawn)['dark'];

export function currentTheme(): Theme {
  const kept = localStorage.getItem('delos-theme');
  if (kept === 'dark' || kept === 'light') return kept;
  return matchMedia('(prefers-color-scheme: light)').matches ? 'light' : 'dark';
}

/** @returns the colours of what is drawn */
export function applyTheme(theme: Theme): Drawing {
  document.documentElement.dataset.theme = theme;
  const colours = drawn[theme];
  blindColours.a.setStyle(colours.blindA, '');
  blindColours.b.setStyle(colours.blindB, '');
  blindColours.solid.setStyle(colours.solid, '');
  return colours;
}
