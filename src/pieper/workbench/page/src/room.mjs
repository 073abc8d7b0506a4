// The room for the picture: a splitter beside the panels, a mode to present in, the picture saved as a file.
import { button, download, h, say } from './dom.mjs';
import { state, on, tell } from './store.mjs';
import { withPicture } from './scene/view.mjs';
import { writeLabels } from './scene/labels.mjs';
import { matrixGrid } from './panels/grid.mjs';

const KEPT = 'pieper-panel-width';
/** Rem that the panels may take. */
const LEAST = 18,
  MOST = 70;

/** A handle between picture and panels: dragged, or moved by the arrows; twice pressed, as it was. */
export function splitter(room, rail) {
  const handle = h('div', {
    class: 'splitter',
    role: 'separator',
    'aria-orientation': 'vertical',
    'aria-label': 'Width of the panels',
    'aria-valuemin': String(LEAST),
    'aria-valuemax': String(MOST),
    tabindex: '0',
    'data-testid': 'splitter',
  });
  rail.prepend(handle);
  const rem = () => parseFloat(getComputedStyle(document.documentElement).fontSize);
  const now = () => document.getElementById('panels').offsetWidth / rem();
  const set = (width) => {
    const w = width === null ? null : Math.min(Math.max(width, LEAST), MOST, (0.75 * innerWidth) / rem());
    if (w === null) room.style.removeProperty('--panel-width');
    else room.style.setProperty('--panel-width', `${w}rem`);
    room.classList.toggle('split', w !== null);
    handle.setAttribute('aria-valuenow', String(Math.round(w ?? now())));
    try {
      if (w === null) localStorage.removeItem(KEPT);
      else localStorage.setItem(KEPT, String(w));
    } catch {
      /* it lasts as long as the page */
    }
  };
  handle.addEventListener('pointerdown', (e) => {
    handle.setPointerCapture(e.pointerId);
    const from = e.clientX,
      width = now();
    const move = (ev) => set(width + (from - ev.clientX) / rem());
    handle.addEventListener('pointermove', move);
    handle.addEventListener('pointerup', () => handle.removeEventListener('pointermove', move), { once: true });
  });
  handle.addEventListener('dblclick', () => set(null));
  handle.addEventListener('keydown', (e) => {
    const by = { ArrowLeft: 1, ArrowRight: -1 }[e.key];
    if (by) set(now() + by * (e.shiftKey ? 5 : 1));
    else if (e.key === 'Home') set(null);
    else return;
    e.preventDefault();
  });
  const kept = Number(localStorage.getItem(KEPT));
  if (kept >= LEAST) set(kept);
  else handle.setAttribute('aria-valuenow', '38');
}

/** Picture, matrix and one panel in large type; Escape leaves. */
export function present(overlay) {
  const grid = matrixGrid('Pose of the tool, large', 'present-pose');
  const card = h('div', { class: 'present-card', hidden: true }, grid);
  overlay.parentElement.append(card);
  const root = document.documentElement;
  const toggle = button('Present', { 'aria-pressed': 'false', 'data-testid': 'present' }, () =>
    set(root.dataset.present !== 'yes'),
  );
  const update = () => !card.hidden && grid.show(state.frames.at(-1));
  function set(yes) {
    if (yes) root.dataset.present = 'yes';
    else delete root.dataset.present;
    card.hidden = !yes;
    toggle.setAttribute('aria-pressed', String(yes));
    update();
    tell('units');
    dispatchEvent(new Event('resize'));
  }
  on(['q', 'units'], update);
  addEventListener(
    'keydown',
    (e) => e.key === 'Escape' && root.dataset.present && !e.target.matches?.('input') && set(false),
  );
  return toggle;
}

/** The picture as it stands, with its names and without what else lies over it. */
export function savePicture() {
  withPicture((canvas) => {
    const out = document.createElement('canvas'),
      context = out.getContext('2d');
    out.width = canvas.width;
    out.height = canvas.height;
    context.drawImage(canvas, 0, 0);
    writeLabels(context, canvas.width / canvas.clientWidth);
    out.toBlob((blob) =>
      blob ? download(`${state.table.name || 'arm'}.png`, blob) : say('The picture could not be read.', 'wrong'),
    );
  });
}
