// A small calculator for typed numbers: + - * / ^, brackets, pi, sqrt, sin ... and units. It evaluates nothing else.
import { units } from './units.mjs';

const functions = {
  sqrt: Math.sqrt,
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  asin: Math.asin,
  acos: Math.acos,
  atan: Math.atan,
  abs: Math.abs,
};
const constants = { pi: Math.PI, π: Math.PI, tau: 2 * Math.PI };
const TOKEN = /\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y;
const LONGEST = 80;

function tokens(text) {
  const out = [];
  TOKEN.lastIndex = 0;
  const trimmed = text.trimEnd();
  while (TOKEN.lastIndex < trimmed.length) {
    const at = TOKEN.lastIndex,
      m = TOKEN.exec(trimmed);
    if (!m) throw new Error(`cannot read “${trimmed.slice(at).trim().slice(0, 8)}” at character ${at + 1}`);
    if (m[1] !== undefined) out.push({ number: Number(m[1]), text: m[1] });
    else if (m[2] !== undefined) out.push({ word: m[2] });
    else out.push({ sign: { '−': '-', '·': '*', '**': '^' }[m[3]] ?? m[3] });
  }
  return out;
}

/** A decimal comma is a decimal point; where it could be one of thousands, say so instead of guessing. */
function withPoints(text) {
  if (!text.includes(',')) return text;
  if (text.includes('.') || /\d,\d*,/.test(text))
    throw new Error('a comma is the decimal sign here: leave out the ones between thousands');
  return text.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g, '$1$2$3.');
}

/**
 * Read what a person typed into a field that holds an angle, a length or a plain number.
 *
 * An angle with `pi` in it is in radians, as on paper; `deg`, `rad`, `mm`, `m` at the end say the unit; a bare number is in
 * the unit that the page shows. Returns {value (SI), symbolic} or throws an Error that says what is wrong.
 */
export function read(text, kind = 'plain') {
  const source = withPoints(String(text));
  if (source.length > LONGEST) throw new Error(`longer than ${LONGEST} characters`);
  const list = tokens(source);
  if (!list.length) throw new Error('empty: type a number, or an expression such as pi/2');
  let unit = null;
  const last = list[list.length - 1];
  if (list.length > 1 && last.word && last.word in units.suffix(kind)) {
    unit = units.suffix(kind)[last.word];
    list.pop();
  }
  let i = 0,
    sawPi = false;
  const peek = (s) => list[i]?.sign === s;
  const expect = (s) => {
    if (!peek(s)) throw new Error(`“${s}” is missing`);
    i++;
  };
  function sum() {
    let v = product();
    while (peek('+') || peek('-')) {
      const s = list[i++].sign;
      const w = product();
      v = s === '+' ? v + w : v - w;
    }
    return v;
  }
  function product() {
    let v = signed();
    for (;;) {
      if (peek('*')) {
        i++;
        v *= signed();
      } else if (peek('/')) {
        i++;
        v /= signed();
      } else if (list[i]?.word || peek('('))
        v *= power(); // 2pi, 2(1+3)
      else return v;
    }
  }
  function signed() {
    if (peek('-')) {
      i++;
      return -signed();
    }
    if (peek('+')) {
      i++;
      return signed();
    }
    return power();
  }
  function power() {
    const base = atom();
    if (!peek('^')) return base;
    i++;
    return base ** signed();
  }
  function atom() {
    const t = list[i];
    if (!t) throw new Error('something is missing at the end');
    i++;
    if (t.number !== undefined) return t.number;
    if (t.sign === '(') {
      const v = sum();
      expect(')');
      return v;
    }
    if (t.word) {
      const name = t.word.toLowerCase();
      if (Object.hasOwn(constants, name)) {
        sawPi = true;
        return constants[name];
      }
      if (Object.hasOwn(functions, name)) {
        expect('(');
        const v = sum();
        expect(')');
        return functions[name](v);
      }
      throw new Error(`“${t.word.slice(0, 20)}” is not known; allowed are pi, ${Object.keys(functions).join(', ')}`);
    }
    throw new Error(`“${t.sign}” is not expected here`);
  }
  const raw = sum();
  if (i < list.length) throw new Error(`“${list[i].sign ?? list[i].word ?? list[i].text}” is not expected here`);
  if (!Number.isFinite(raw)) throw new Error('not a finite number');
  const factor = unit ?? (kind === 'angle' && sawPi ? 1 : units.factor(kind));
  return { value: raw / factor + 0, symbolic: sawPi || unit !== null || list.length > 2 };
}
