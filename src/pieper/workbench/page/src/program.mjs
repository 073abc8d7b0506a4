// The program of the page: its steps, its limits, and how they are said to the library.
import { state, tell } from './store.mjs';
import { identity, invert, mul } from './matrix.mjs';

const DEG = Math.PI / 180;
/** What a motion keeps before anybody says otherwise: SI, turning and sliding joints apart. */
export const usualLimits = () => ({
  turn_speed: 180 * DEG,
  turn_acceleration: 600 * DEG,
  turn_jerk: null,
  slide_speed: 0.5,
  slide_acceleration: 2,
  slide_jerk: null,
  tool_speed: 0.5,
});

export const moving = (step) => ['joint', 'line', 'circle', 'spline'].includes(step.kind);

/** The work frame in which the poses of step k are meant: the last one said before it. */
export const frameBefore = (k) =>
  state.program.slice(0, Math.max(k, 0)).findLast((s) => s.kind === 'frame')?.T ?? identity();
/** Where the tool is now, as a step at place k says it. */
export const taughtAt = (k) => mul(invert(frameBefore(k)), state.frames.at(-1));

/**
 * Steps in another order: `to[i]` is where step i goes, or -1 where it is taken out. What calls steps again calls the same
 * ones, even where they come after it now, which it says; a call that nothing is left of goes too.
 */
export function renumbered(steps, to) {
  const at = (k, way) => {
    // the end of a called range that was taken out is the nearest one that is left
    while (k >= 1 && k <= to.length && to[k - 1] < 0) k += way;
    return k >= 1 && k <= to.length ? to[k - 1] + 1 : null;
  };
  const out = [];
  steps.forEach((s, i) => {
    if (to[i] < 0) return;
    if (s.kind !== 'call') {
      out[to[i]] = s;
      return;
    }
    const ends = [at(s.first, 1), at(s.last, -1)].filter((k) => k !== null);
    if (ends.length === 2 && s.first <= s.last)
      out[to[i]] = { ...s, first: Math.min(...ends), last: Math.max(...ends) };
  });
  return out.filter(Boolean);
}

/** Why step k, counted from 0, cannot be done wherever the arm is; null where nothing speaks against it. */
export const misplaced = (s, k) =>
  s.kind === 'call' && s.last > k ? 'Only steps before it can be done again: move it down, or name others.' : null;

/** Take other steps; a step of the history by its label. */
export function setProgram(steps, label, { key, open } = {}) {
  tell('did', { label, key, open });
  if (!state.program.length && steps.length) state.start ??= state.q;
  state.program = steps;
  tell('program');
}
export const changeStep = (k, change, label, how) =>
  setProgram(
    state.program.map((s, i) => (i === k ? { ...s, ...change } : s)),
    label,
    how,
  );
export function setLimits(change, label) {
  tell('did', { label, key: 'limits' });
  state.limits = { ...limits(), ...change };
  tell('program', 'limits');
}
export const limits = () => ({ ...usualLimits(), ...state.limits });
export function setStart(q, label = 'set the start of the program') {
  tell('did', { label });
  state.start = q;
  tell('program');
}
export const start = () => (state.start?.length === state.table.joints.length ? state.start : state.q);

/** The program as the library takes it. */
export function programMessage() {
  const L = limits(),
    joints = state.table.joints;
  const each = (what) =>
    joints.every((j) => L[`${j.type === 'R' ? 'turn' : 'slide'}_${what}`] === null)
      ? null
      : joints.map((j) => L[`${j.type === 'R' ? 'turn' : 'slide'}_${what}`] ?? 1e6);
  return {
    start: start(),
    limits: { speed: each('speed'), acceleration: each('acceleration'), jerk: each('jerk'), tool_speed: L.tool_speed },
    steps: state.program.map(({ name, ...s }) => s),
  };
}
