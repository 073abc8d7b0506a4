// What the page knows: one arm, one posture, one target, and what is derived from them. Listeners hear by topic.
import { frames as forward, singularValues, reach } from './kinematics.mjs';
import { identity } from './matrix.mjs';

const listeners = new Map();
export function on(topics, f) {
  for (const t of [topics].flat()) (listeners.get(t) ?? listeners.set(t, []).get(t)).push(f);
}
export function tell(topic, detail) {
  for (const f of listeners.get(topic) ?? []) f(detail);
}

export const state = {
  table: { name: '', convention: 'standard', joints: [], base: identity(), tool: identity(), postures: {} },
  q: [],
  frames: [identity(), identity()],
  plan: null, // what kind of arm this is, from the library
  target: identity(),
  digits: null, // half of the last digits a typed target has: {metres, radians}
  solutions: null, // the library's answer for the target
  notation: 'rpy',
  shownFrames: null, // indices into frames
  path: { from: null, to: null, n: 50, seconds: 5 },
  track: null,
  sequence: { postures: [], rate: 50 },
  motion: null,
  dhStep: null, // how far the frames of the table are built up, or null for all of them
  program: [], // steps, each an object that is replaced and never written into
  limits: null, // of the program's motion, SI; null for the usual ones
  routing: null, // what is asked of a route, null for the usual; replaced and never written into
  route: null, // the library's answer to it
  start: null, // where the program begins, joint values
  watch: false, // whether distances are asked for without anything to run into
  clearance: null, // the nearest two bodies, as the library says
  world: [], // what stands around the arm, likewise
  looks: null, // the shapes of the arm's own file: {shapes, notes, key, files}
  look: { mode: 'real', opacity: 0.4 },
  panel: 'move',
  theme: 'auto',
  online: false,
};

export function setJoints(q, why = 'hand') {
  state.q = q;
  state.frames = forward(state.table, q);
  tell('q', why);
}
export function setJoint(i, value, why = 'hand') {
  if (why === 'hand') tell('did', { label: `move q${i + 1}`, key: `q${i + 1}` });
  const q = state.q.slice();
  q[i] = value;
  setJoints(q, why);
}

const clampInto = (j) => {
  const lo = j.lower ?? -Infinity,
    hi = j.upper ?? Infinity;
  return lo <= 0 && hi >= 0
    ? 0
    : Number.isFinite(lo) && Number.isFinite(hi)
      ? (lo + hi) / 2
      : Number.isFinite(lo)
        ? lo
        : hi;
};

/**
 * A posture that shows the arm well: the maker's own where there is one, moved a little where it is singular, since stretched
 * or folded arms hide their joints from the eye and their solutions from the solver.
 */
export function presentable(table) {
  const named = Object.entries(table.postures ?? {});
  const pick = ['ready', 'home', 'work', 'elbow']
    .map((w) => named.find(([k]) => k.toLowerCase().includes(w)))
    .find(Boolean);
  const start = pick ? pick[1].slice() : table.joints.map(clampInto);
  const least = (q) => singularValues(table, q)[0] ?? 1;
  const lowest = (q) => Math.min(...forward(table, q).map((T) => T[11])) / reach(table);
  if (!start.length || (least(start) > 0.05 && lowest(start) > -0.02)) return start;
  const worth = (q) => Math.min(least(q), 0.15) + Math.min(lowest(q), 0);
  let best = start,
    score = worth(start),
    seed = 7;
  const chance = () => {
    seed = (seed * 16807) % 2147483647;
    return seed / 2147483647 - 0.5;
  };
  for (let k = 0; k < 160; k++) {
    const q = start.map((v, i) => {
      const j = table.joints[i],
        by = chance() * (j.type === 'R' ? 1.3 : 0.5 * reach(table));
      return Math.min(Math.max(v + by, j.lower ?? -Infinity), j.upper ?? Infinity);
    });
    const s = worth(q) - 0.03 * Math.hypot(...q.map((v, i) => v - start[i]));
    if (s > score) {
      score = s;
      best = q;
    }
  }
  return best.map((v, i) => {
    const step = table.joints[i].type === 'R' ? Math.PI / 180 : 0.005;
    return Math.round(v / step) * step;
  });
}

/** What makes an arm a catalogue's arm no longer: its rows, its joints, its base or tool. */
const EDITS = new Set(['edit', 'cell', 'rows']);
/** An edited arm of the catalogue is somebody's own: maker and source do not stand for it. */
function own(table, what) {
  if (!table.catalog || !EDITS.has(what)) return table;
  const { catalog, ...rest } = table;
  const notes = `Derived from ${catalog} of the catalogue, edited in the workbench.`;
  return { ...rest, name: `${catalog}-edited`.slice(0, 60), derived: catalog, manufacturer: '', source: '', notes };
}

/**
 * Take a table as the arm. The posture is kept where the joints are still the same ones.
 * `label` makes it a step of the history; `key` and `open` say which steps are one.
 */
export function setTable(given, { step = true, q = null, what = 'edit', label = 'edit the arm', key, open } = {}) {
  const table = own(given, what);
  if (step) tell('did', { label, key, open });
  const same = table.joints.length === state.q.length,
    before = state.table.joints,
    kept = same && before.some((j, i) => j.type !== table.joints[i]?.type) ? keptBy(before, table.joints) : null;
  state.table = table;
  state.q = q ?? (same ? (kept ?? ((v) => v))(state.q) : table.joints.map((j, i) => state.q[i] ?? clampInto(j)));
  state.frames = forward(table, state.q);
  state.solutions = null;
  if (kept) keepPostures(kept);
  tell('table', what);
  tell('q', 'table');
  if (kept) for (const topic of ['program', 'sequence-loaded']) tell(topic);
}
/** What is kept of a joint vector where turning joints become slides or slides turn: radians are no metres. */
const keptBy = (before, joints) => (v) =>
  v?.length === joints.length ? v.map((x, i) => (before[i]?.type === joints[i].type ? x : clampInto(joints[i]))) : v;
function keepPostures(kept) {
  state.start = kept(state.start);
  state.program = state.program.map((s) => (s.q ? { ...s, q: kept(s.q) } : s));
  for (const p of state.sequence.postures) p.q = kept(p.q);
}

/** Who set a target: a person that edits it is followed by the arm, everything else leaves the posture as it is. */
export const EDITED = new Set(['typed', 'drag', 'dropped', 'chosen', 'python']);
export function setTarget(T, why = 'typed', digits = null) {
  if (why === 'drag') tell('did', { label: 'drag the target', key: 'drag', open: true });
  else if (why === 'dropped') tell('let-go');
  else if (why === 'typed' || why === 'chosen') tell('did', { label: 'set the target', key: 'target' });
  state.target = T;
  if (why !== 'dropped') state.digits = digits;
  tell('target', why);
}
