// Light and dark: the page's colours live in CSS; what the canvas needs is read from there.
import { state, tell } from './store.mjs';
import identity from '../../../document/identity.json';

export const colours = {};
const names = [
  'ground',
  'gridFine',
  'gridCoarse',
  'link',
  'joint',
  'accent',
  'ghost',
  'ink',
  'muted',
  'line',
  'trace',
  'panel',
  'wrong',
];
const system = matchMedia('(prefers-color-scheme: dark)');
export function readTheme() {
  const dark = state.theme === 'dark' || (state.theme === 'auto' && system.matches);
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  const css = getComputedStyle(document.documentElement);
  for (const n of names)
    colours[n] = css.getPropertyValue(`--${n.replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`)}`).trim();
  colours.dark = dark;
  colours.curves = identity[dark ? 'dark' : 'light'].curves;
}
export function setTheme(theme) {
  state.theme = theme;
  readTheme();
  tell('theme');
}
system.addEventListener('change', () => {
  if (state.theme === 'auto') {
    readTheme();
    tell('theme');
  }
});
