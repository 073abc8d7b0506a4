// Forward equations with the present numbers put in: c_{23} becomes the cosine of theta_2 + theta_3 as it now is.
import { rowAt } from './kinematics.mjs';

const DIGITS = 4;
const number = (v) => {
  const s = v.toFixed(DIGITS);
  return Number(s) < 0 ? `(${s})` : s.replace('-', '');
};

/** Joints (from 1) of an index with their signs: 23 is theta_2 + theta_3, 1+2-4 is theta_1 + theta_2 - theta_4. */
function terms(index, n) {
  if (/^\d+$/.test(index)) {
    if (n < 10) return [...index].map((d) => [Number(d), 1]);
    // with ten joints and more, 12 may be joint 12 or the sum of two
    return index.length === 1 ? [[Number(index), 1]] : null;
  }
  const found = [...index.matchAll(/([+-]?)(\d+)/g)].map(([, sign, d]) => [Number(d), sign === '-' ? -1 : 1]);
  return /^[+-]?\d+([+-]\d+)+$/.test(index) ? found : null;
}

/** LaTeX of an equation, lengths already as numbers, with sines, cosines and slides as numbers too. */
export function withPresentNumbers(latex, table, q) {
  const n = table.joints.length,
    rows = table.joints.map((joint, i) => rowAt(joint, q[i]));
  const angle = (list) => list.reduce((sum, [j, sign]) => sum + sign * rows[j - 1].theta, 0);
  const put = latex.replace(/(?<![A-Za-z])([csd])_\{([\d+-]+)\}/g, (symbol, letter, index) => {
    const list = terms(index, n);
    if (!list || list.some(([j]) => j < 1 || j > n)) return symbol;
    if (letter === 'd') return table.joints[list[0][0] - 1].type === 'P' ? number(rows[list[0][0] - 1].d) : symbol;
    return number(letter === 'c' ? Math.cos(angle(list)) : Math.sin(angle(list)));
  });
  // plain parentheses let a long line break anywhere, and a number beside a number needs its dot
  const plain = put.replaceAll('\\left(', '(').replaceAll('\\right)', ')');
  return plain.replace(/(\d|\))\s+(?=\d|\()/g, '$1 \\cdot ');
}
