// Light and dark: the page's colours live in CSS; what the canvas needs is read from there.
import { state, tell } from './store.mjs';

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
/** Eight curve colours that stay apart for colour-blind eyes (after Okabe and Ito, 2008), one set for each theme. */
const curves = {
  light: ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#8a6d00', '#56b4e9', '#4b4b4b', '#7a3e9d'],
  dark: ['#56b4e9', '#ff9a4d', '#2fd6a3', '#f0a3cb', '#f0e442', '#8fb7ff', '#d0d4da', '#c9a0ff'],
};

const system = matchMedia('(prefers-color-scheme: dark)');
export function readTheme() {
  const dark = state.theme === 'dark' || (state.theme === 'auto' && system.matches);
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  const css = getComputedStyle(document.documentElement);
  for (const n of names)
    colours[n] = css.getPropertyValue(`--${n.replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`)}`).trim();
  colours.dark = dark;
  colours.curves = curves[dark ? 'dark' : 'light'];
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
