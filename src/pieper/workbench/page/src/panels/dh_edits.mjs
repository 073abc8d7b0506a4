// What editing a DH table does to the arm: cells, and joints that come, go or change places.
import { say } from '../dom.mjs';
import { state, setTable, tell } from '../store.mjs';

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

const NAMES = { a: 'a', alpha: 'α', d: 'd', theta: 'θ', lower: 'lower limit', upper: 'upper limit', offset: 'zero' };
export function change(i, key, value, { symbolic, text }, done) {
  const joints = state.table.joints.map((j, k) =>
    k !== i ? j : { ...j, [key]: value, text: { ...j.text, [key]: symbolic ? text : undefined } },
  );
  const same =
    Object.is(state.table.joints[i][key], value) && state.table.joints[i].text?.[key] === joints[i].text[key];
  const label = `edit ${NAMES[key] ?? key} of joint ${i + 1}`;
  if (!same) setTable({ ...state.table, joints }, { what: 'cell', label, key: `${i}/${key}`, open: true });
  if (done) tell('let-go');
}
/**
 * Joints come, go or change places; what is said joint by joint (the posture, the named postures, the coupling) goes with them.
 * `along` takes a list of n entries to the new places, a new place being filled with `fresh`.
 */
export function restructure(joints, along, label) {
  const { postures, coupling } = state.table;
  const named = Object.fromEntries(Object.entries(postures ?? {}).map(([name, q]) => [name, along(q, 0)]));
  const q = along(state.q, 0);
  const coupled = coupling ? along(coupling, null).map((row, i) => unit(row && along(row, 0), i, joints.length)) : null;
  setTable({ ...state.table, joints, postures: named, coupling: coupled }, { q, what: 'rows', label });
}
const unit = (row, i, n) => row ?? Array.from({ length: n }, (_, k) => Number(k === i));

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
    return false;
  }
  restructure([...state.table.joints, newJoint(n)], (list, fresh) => [...list, fresh], `add joint ${n + 1}`);
  document.querySelector(`[data-testid="dh-${n + 1}-a"]`)?.focus();
  return true;
}
export function swap(i, k) {
  const swapped = (list) => {
    const out = list.slice();
    [out[i], out[k]] = [out[k], out[i]];
    return out;
  };
  restructure(swapped(state.table.joints), swapped, `swap joints ${i + 1} and ${k + 1}`);
}
