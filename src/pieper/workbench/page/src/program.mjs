// The program of the page: its steps, its limits, and how they are said to the library.
import { state, tell } from './store.mjs';

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

export const moving = (step) => ['joint', 'line', 'circle'].includes(step.kind);

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
