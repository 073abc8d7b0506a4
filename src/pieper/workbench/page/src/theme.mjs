// Light and dark, and how large the letters are; colours live in CSS, and what the canvas needs is read from there.
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
  document.documentElement.style.setProperty('--text-size', String(textSize()));
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
const KEPT = 'pieper-text-size';
/** How large the letters are, as a person chose it in this browser. */
export function textSize() {
  const kept = Number(localStorage.getItem(KEPT));
  return kept >= 0.5 && kept <= 3 ? kept : 1;
}
export function setTextSize(size) {
  document.documentElement.style.setProperty('--text-size', String(size));
  try {
    localStorage.setItem(KEPT, String(size));
  } catch {
    /* it lasts as long as the page */
  }
  tell('theme');
  dispatchEvent(new Event('resize'));
}
system.addEventListener('change', () => {
  if (state.theme === 'auto') {
    readTheme();
    tell('theme');
  }
});
