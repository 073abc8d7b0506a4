// Names in the picture, in the page's own letters: each beside what it names, none over another.
import * as THREE from 'three';
import { h } from '../dom.mjs';
import { on } from '../store.mjs';
import { colours } from '../theme.mjs';
import { beforeEach, camera, invalidate } from './view.mjs';

/** Where a name may stand around its point, as directions on the screen; the nearest to where it is wished goes first. */
const ROUND = Array.from({ length: 12 }, (_, k) => [Math.cos((k * Math.PI) / 6), Math.sin((k * Math.PI) / 6)]);
/** Distances from the point, in letters' heights; beyond the last one a name says nothing of its point. */
const RINGS = [0.75, 1.5, 2.4];
/** Room between two names, and around the points that others name, pixels. */
const GAP = 2,
  POINT = 4;

const layer = h('div', { class: 'labels', 'aria-hidden': 'true' });
const shown = new Map();
let size = null;

/** Show the names of one owner: [{text, at, wish}], places in space, `wish` a point on whose side the name would stand. */
export function showLabels(owner, list) {
  const old = shown.get(owner) ?? [];
  const kept = list.map(({ text, at, wish }, i) => {
    const label = old[i] ?? { el: layer.appendChild(h('span', { class: 'label' })), stands: null };
    if (label.text !== text) {
      label.text = label.el.textContent = text;
      label.width = null;
    }
    return Object.assign(label, { at, wish });
  });
  for (const label of old.slice(list.length)) label.el.remove();
  shown.set(owner, kept);
  invalidate();
}

export function begin(overlay) {
  overlay.prepend(layer);
  beforeEach(place);
  on('theme', () => {
    for (const label of [...shown.values()].flat()) label.width = null;
    size = null;
  });
  new ResizeObserver(([entry]) => {
    size = [entry.contentRect.width, entry.contentRect.height];
    invalidate();
  }).observe(layer);
}

const v = new THREE.Vector3();
/** Where a point is in the layer, pixels; null where it is behind the eye. */
function onScreen(p) {
  v.set(...p).project(camera);
  return v.z < 1 ? [((v.x + 1) / 2) * size[0], ((1 - v.y) / 2) * size[1]] : null;
}
const overlap = (a, b) =>
  Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));

/** Put every name where it hides no other one and no other's point; where it stood before, as long as that is free. */
function place() {
  size ??= [layer.clientWidth, layer.clientHeight];
  camera.updateMatrixWorld();
  const all = [...shown.values()].flat();
  for (const label of all) {
    label.point = onScreen(label.at);
    if (label.width === null) {
      label.width = label.el.offsetWidth;
      label.height = label.el.offsetHeight;
    }
  }
  const points = all.filter((l) => l.point).map(({ point: [x, y] }) => [x - POINT, y - POINT, x + POINT, y + POINT]);
  const taken = [];
  for (const label of all) {
    const spot = label.point && spotFor(label, taken, points);
    label.box = spot ? spot.box : null;
    label.stands = spot ? spot.key : null;
    label.el.hidden = !spot;
    if (!spot) continue;
    taken.push(spot.box.map((c, i) => c + (i < 2 ? -GAP : GAP)));
    const where = `translate(${Math.round(spot.box[0])}px, ${Math.round(spot.box[1])}px)`;
    if (where !== label.where) label.el.style.setProperty('transform', (label.where = where));
  }
}
function spotFor({ point, width, height, wish, stands }, taken, points) {
  const [x, y] = point;
  if (x < 0 || y < 0 || x > size[0] || y > size[1]) return null;
  const to = wish && onScreen(wish),
    length = to ? Math.hypot(to[0] - x, to[1] - y) || 1 : 1,
    wished = to ? [(to[0] - x) / length, (to[1] - y) / length] : [0, -1];
  let best = null;
  RINGS.forEach((ring, r) => {
    ROUND.forEach(([dx, dy], k) => {
      const cx = x + dx * (ring * height + width / 2),
        cy = y + dy * ring * height * 1.35;
      const box = [cx - width / 2, cy - height / 2, cx + width / 2, cy + height / 2];
      const outside = width * height - overlap(box, [0, 0, ...size]);
      const hides = [...taken, ...points].reduce((sum, t) => sum + overlap(box, t), outside),
        key = `${r}.${k}`;
      // hiding something weighs more than every wish; standing where it stood keeps it from trembling
      const cost = 100 * hides + 2 * r + (1 - dx * wished[0] - dy * wished[1]) - (key === stands ? 0.8 : 0);
      if (!best || cost < best.cost) best = { cost, box, key };
    });
  });
  return best;
}

/** Names and where they stand now, pixels of the picture; for tests. */
export const labelsDrawn = () => [...shown.values()].flat().map(({ text, box, point }) => ({ text, box, point }));

/** Write the names onto a picture that was drawn `scale` times as large as it is shown. */
export function writeLabels(context, scale) {
  const css = getComputedStyle(layer);
  context.font = `600 ${parseFloat(css.fontSize) * scale}px ${css.fontFamily}`;
  Object.assign(context, { textAlign: 'center', textBaseline: 'middle', lineJoin: 'round', lineWidth: 4 * scale });
  context.strokeStyle = colours.ground;
  context.fillStyle = colours.ink;
  for (const { text, box } of labelsDrawn()) {
    if (!box) continue;
    const at = [((box[0] + box[2]) / 2) * scale, ((box[1] + box[3]) / 2) * scale];
    context.strokeText(text, ...at);
    context.fillText(text, ...at);
  }
}
