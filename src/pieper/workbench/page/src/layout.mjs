// Which layout the page has: by how many letters the window is wide, so that larger letters lay it out anew.
import { textSize } from './theme.mjs';
import { tell } from './store.mjs';

/** Widths in letters (rem) up to which a window has each layout: at letters of the usual size 900, 1240 and 1699 pixels. A wider one keeps Joints and Pose pinned. */
const WIDEST = [
  [64.3, 'tablet'],
  [87.33, 'narrow'],
  [103.02, 'usual'],
];
/** A letter as the style sheet has it outside Present, pixels. */
const letter = (width) => textSize() * Math.min(Math.max(14, 8 + 0.005 * width), 28);
export const layout = () => document.documentElement.dataset.layout;
function measure() {
  const width = innerWidth / letter(innerWidth),
    now = WIDEST.find(([most]) => width <= most)?.[1] ?? 'pinned';
  if (now === layout()) return;
  document.documentElement.dataset.layout = now;
  tell('layout');
}

export function begin() {
  measure();
  addEventListener('resize', measure);
}
