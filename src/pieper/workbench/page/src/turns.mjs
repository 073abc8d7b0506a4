// Whole turns: the same posture as near to the present one as the limits allow.
import { state } from './store.mjs';

const TURN = 2 * Math.PI,
  SLACK = 1e-9;

/** The same posture with each revolute joint turned whole turns: inside its limits where it can be, and as near to where it is as these allow. */
export function shortest(q) {
  return q.map((v, i) => (state.table.joints[i].type === 'R' ? turned(v, state.table.joints[i], state.q[i]) : v));
}

function turned(v, { lower, upper }, here) {
  const lo = lower ?? -Infinity,
    hi = upper ?? Infinity;
  const least = Math.ceil((lo - SLACK - v) / TURN),
    most = Math.floor((hi + SLACK - v) / TURN),
    near = Math.round((here - v) / TURN);
  // where no whole turn brings it inside, the one that is the least beyond: of a curve that goes round, the same on every round
  if (least > most) return lo - (v + TURN * most) < v + TURN * least - hi ? v + TURN * most : v + TURN * least;
  return v + TURN * Math.min(Math.max(near, least), most);
}
