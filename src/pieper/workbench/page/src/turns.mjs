// Whole turns: the same posture as near to the present one as the limits allow.
import { state } from './store.mjs';

/** The same posture with each revolute joint a whole number of turns nearer to where it is, if its limits allow. */
export function shortest(q) {
  return q.map((v, i) => {
    const j = state.table.joints[i];
    if (j.type !== 'R') return v;
    const w = v + 2 * Math.PI * Math.round((state.q[i] - v) / (2 * Math.PI));
    return (j.lower === null || w >= j.lower - 1e-9) && (j.upper === null || w <= j.upper + 1e-9) ? w : v;
  });
}
