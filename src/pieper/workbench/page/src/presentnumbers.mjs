// Forward equations with the present numbers put in: c_{23} becomes the cosine of theta_2 + theta_3 as it now is.
import { rowAt, chainValues } from './kinematics.mjs';

const DIGITS = 4;
const number = (v) => {
  const s = v.toFixed(DIGITS);
  return Number(s) < 0 ? `(${s})` : s.replace('-', '');
};

/** LaTeX of an equation, lengths already as numbers, with its sines, cosines and slides as numbers too. */
export function withPresentNumbers(equation, table, q) {
  const moved = chainValues(table, q),
    rows = table.joints.map((joint, i) => rowAt(joint, moved[i]));
  const angle = (joints) => joints.reduce((sum, [j, factor]) => sum + factor * rows[j - 1].theta, 0);
  const value = {
    cos: (joints) => Math.cos(angle(joints)),
    sin: (joints) => Math.sin(angle(joints)),
    slide: ([[j]]) => rows[j - 1].d,
  };
  const put = equation.symbols.reduce(
    (latex, symbol) => latex.replaceAll(symbol.latex, number(value[symbol.is](symbol.joints))),
    equation.latex,
  );
  // plain parentheses let a long line break anywhere, and a number beside a number needs its dot
  const plain = put.replaceAll('\\left(', '(').replaceAll('\\right)', ')');
  return plain.replace(/(\d|\))\s+(?=\d|\()/g, '$1 \\cdot ');
}
