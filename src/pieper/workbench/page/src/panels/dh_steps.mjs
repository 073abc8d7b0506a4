// The frames of a DH table built one motion at a time: turn by theta, go d, go a, turn by alpha, joint after joint.
import { button, h, setText } from '../dom.mjs';
import { state, on, tell } from '../store.mjs';
import { linkMatrix, rowAt, chainValues } from '../kinematics.mjs';
import { mul } from '../matrix.mjs';
import { showUnit } from '../units.mjs';

const ORDER = {
  standard: ['theta', 'd', 'a', 'alpha'],
  modified: ['alpha', 'a', 'theta', 'd'],
};
const SAID = {
  theta: (i, v, z) => `turn by θ${i} = ${showUnit(v, 'angle')} about z${z}`,
  d: (i, v, z) => `go d${i} = ${showUnit(v, 'length')} along z${z}`,
  a: (i, v) => `go a${i} = ${showUnit(v, 'length')} along x`,
  alpha: (i, v) => `turn by α${i} = ${showUnit(v, 'angle')} about x`,
};

/** The frame after step k of joint i (0 based), its numbers up to there and nothing after. */
export function partial(table, q, step) {
  const i = Math.floor(step / 4),
    upTo = (step % 4) + 1,
    order = ORDER[table.convention];
  const row = rowAt(table.joints[i], chainValues(table, q)[i]);
  const part = Object.fromEntries(order.map((key, k) => [key, k < upTo ? row[key] : 0]));
  return {
    i,
    key: order[upTo - 1],
    value: row[order[upTo - 1]],
    A: linkMatrix(table.convention, part.a, part.alpha, part.d, part.theta),
  };
}

export function dhSteps() {
  const text = h('p', { class: 'step-said', role: 'status', 'data-testid': 'dh-step-said' });
  const go = (name, label, to) => button(name, { 'aria-label': label }, () => set(to()));
  const last = () => 4 * state.table.joints.length - 1;
  const set = (step) => {
    state.dhStep = step === null || step < 0 ? null : Math.min(step, last());
    show();
    tell('frames');
  };
  const el = h(
    'details',
    { class: 'fold', 'data-testid': 'dh-steps' },
    h('summary', { text: 'The frames, one step at a time' }),
    h(
      'div',
      { class: 'line' },
      go('First', 'To the base', () => 0),
      go('Back', 'One step back', () => (state.dhStep ?? 1) - 1),
      go('On', 'One step on', () => (state.dhStep ?? -1) + 1),
      go('Last', 'To the end', last),
      text,
    ),
  );
  el.addEventListener('toggle', () => set(el.open ? 0 : null));
  const show = () => {
    if (state.dhStep === null || !state.table.joints.length) {
      state.dhStep = null;
      setText(text, '');
      return;
    }
    state.dhStep = Math.min(state.dhStep, last());
    const { i, key, value } = partial(state.table, state.q, state.dhStep);
    const z = state.table.convention === 'standard' ? i : i + 1;
    setText(text, `Joint ${i + 1}, ${(state.dhStep % 4) + 1} of 4: ${SAID[key](i + 1, value, z)}`);
  };
  on(['q', 'table', 'units'], () => state.dhStep !== null && show());
  on('panel', (id) => {
    if (id !== 'table' && state.dhStep !== null) {
      el.open = false;
      set(null);
    }
  });
  return el;
}
/** Frames that are shown while the table is built up: those done, and the one on its way. */
export function framesOfStep() {
  const { i, A } = partial(state.table, state.q, state.dhStep);
  const done = state.frames.slice(0, i + 1).map((T, k) => ({ T, name: k === 0 ? 'base' : String(k) }));
  return [...done, { T: mul(state.frames[i], A), name: `→ ${i + 1}` }];
}
