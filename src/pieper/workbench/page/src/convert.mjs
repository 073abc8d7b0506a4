// Standard DH to modified DH and back, keeping the motion: what does not fit into the rows goes into the tool or the base.
import { mul, identity } from './matrix.mjs';

const twist = (a, alpha) => {
  const c = Math.cos(alpha),
    s = Math.sin(alpha);
  return [1, 0, 0, a, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1];
};

/** a and alpha if T is nothing but Tx(a) Rx(alpha), else null. */
function asTwist(T) {
  const t = twist(T[3], Math.atan2(T[9], T[5]));
  return t.every((v, i) => Math.abs(v - T[i]) < 1e-12) ? { a: T[3], alpha: Math.atan2(T[9], T[5]) + 0 } : null;
}

/** The same arm in the other convention: equal motion for every joint value. */
export function convert(table, to) {
  if (table.convention === to || !table.joints.length) return { ...table, convention: to };
  const joints = table.joints,
    n = joints.length;
  const pairs = joints.map(({ a, alpha, text }) => ({ a, alpha, text }));
  let { base, tool } = table,
    shifted;
  if (to === 'modified') {
    // Row i's Tx(a) Rx(alpha) comes before joint i+1: it moves down one row, and the last one into the tool.
    const first = asTwist(base) ?? { a: 0, alpha: 0 };
    if (asTwist(base)) base = identity();
    tool = mul(twist(pairs[n - 1].a, pairs[n - 1].alpha), tool);
    shifted = [first, ...pairs.slice(0, -1)];
  } else {
    const last = asTwist(tool) ?? { a: 0, alpha: 0 };
    if (asTwist(tool)) tool = identity();
    base = mul(base, twist(pairs[0].a, pairs[0].alpha));
    shifted = [...pairs.slice(1), last];
  }
  return {
    ...table,
    convention: to,
    base,
    tool,
    joints: joints.map((j, i) => ({
      ...j,
      a: shifted[i].a,
      alpha: shifted[i].alpha,
      text: { ...j.text, a: shifted[i].text?.a, alpha: shifted[i].text?.alpha },
    })),
  };
}
