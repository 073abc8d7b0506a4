// What editing a DH table does to the arm: cells, and joints that come, go or change places.
import { say } from '../dom.mjs';
import { state, setTable } from '../store.mjs';

const MOST = 30;
const newJoint = (i) => ({
  name: `joint_${i + 1}`,
  type: 'R',
  a: 0,
  alpha: 0,
  d: 0,
  theta: 0,
  lower: null,
  upper: null,
  sign: 1,
  offset: 0,
});

let editing = null; // the cell whose first keystroke made a step of undo
export function change(i, key, value, { symbolic, text }, done) {
  const cell = `${i}/${key}`,
    step = editing !== cell;
  editing = done ? null : cell;
  const joints = state.table.joints.map((j, k) =>
    k !== i ? j : { ...j, [key]: value, text: { ...j.text, [key]: symbolic ? text : undefined } },
  );
  const same =
    Object.is(state.table.joints[i][key], value) && state.table.joints[i].text?.[key] === joints[i].text[key];
  if (!same) setTable({ ...state.table, joints }, { step, what: 'cell' });
}
/** Joints come, go or change places; what is said joint by joint (the posture, the named postures) goes with them. */
export function restructure(joints, along) {
  editing = null;
  const postures = Object.fromEntries(Object.entries(state.table.postures ?? {}).map(([name, q]) => [name, along(q)]));
  setTable({ ...state.table, joints, postures }, { q: along(state.q), what: 'rows' });
}

export function limitReason(i, key, v) {
  const j = state.table.joints[i];
  if (v === null) return null;
  if (key === 'lower' && j.upper !== null && v > j.upper) return 'above the upper limit';
  if (key === 'upper' && j.lower !== null && v < j.lower) return 'below the lower limit';
  return null;
}
export function add() {
  const n = state.table.joints.length;
  if (n >= MOST) {
    say(`At most ${MOST} joints.`, 'wrong');
    return;
  }
  restructure([...state.table.joints, newJoint(n)], (q) => [...q, 0]);
  document.querySelector(`[data-testid="dh-${n + 1}-a"]`)?.focus();
}
export function swap(i, k) {
  const swapped = (list) => {
    const out = list.slice();
    [out[i], out[k]] = [out[k], out[i]];
    return out;
  };
  restructure(swapped(state.table.joints), swapped);
}
/** A new keystroke is a new step of undo from here on. */
export const settled = () => {
  editing = null;
};
