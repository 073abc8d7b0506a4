// A pose that is typed: as position and angles in the notation of the page, or as a matrix.
import { h, replace } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { numberField } from '../numberfield.mjs';
import { notations, poseFrom } from '../rotation.mjs';
import { position, nearestRotation, rotationDefect } from '../matrix.mjs';
import { units } from '../units.mjs';

/** How far four typed decimals may be from a rotation before they are refused rather than rounded to the nearest one. */
const TYPED = 2e-3;

/** @returns {el, show()}; take(T, firstKeystroke) is called with every readable pose. */
export function poseEditor(title, id, get, take) {
  let parts = [],
    editing = false,
    shown = '';
  const row = h('div', { class: 'pose-fields' });
  const fields = () => {
    const n = notations[state.notation];
    const names = [['X', 'length'], ['Y', 'length'], ['Z', 'length'], ...n.names.map((name, i) => [name, n.kinds[i]])];
    const read = (first) => {
      const T = poseFrom(
        state.notation,
        parts.slice(3).map((p) => p.value),
        parts.slice(0, 3).map((p) => p.value),
      );
      if (T) take(T, first);
    };
    parts = names.map(([name, kind], i) => {
      const p = { value: 0, kind };
      const heard = (v, done) => {
        p.value = v;
        const first = !editing;
        editing = !done;
        read(first);
      };
      p.f = numberField({
        label: `${title}, ${name}`,
        kind,
        testid: `${id}-${i}`,
        input: (v) => heard(v, false),
        commit: (v) => heard(v, true),
      });
      p.el = h(
        'label',
        { class: 'pose-field' },
        h('span', { text: name }),
        p.f,
        h('span', { class: 'unit', text: units.symbol(kind) }),
      );
      return p;
    });
    replace(
      row,
      parts.map((p) => p.el),
    );
    shown = state.notation;
  };
  const show = () => {
    if (shown !== state.notation) fields();
    const T = get();
    if (!T || row.contains(document.activeElement)) return;
    [...position(T), ...notations[state.notation].to(T)].forEach((v, i) => {
      parts[i].value = v;
      parts[i].f.put(v, rounded(v, parts[i].kind));
    });
  };
  on('units', () => {
    fields();
    show();
  });
  on('notation', show);
  fields();
  show();
  row.addEventListener('focusout', () => {
    editing = false;
    setTimeout(show);
  });
  return { el: h('fieldset', { class: 'pose-editor' }, h('legend', { text: title }), row), show };
}

/** Shown with a thousandth of a unit; the exact value stays behind it until the field is typed in. */
const rounded = (v, kind) =>
  String(
    Number((v * units.factor(kind)).toFixed(kind === 'plain' || units[kind] === 'm' || units[kind] === 'rad' ? 6 : 3)) +
      0,
  );

/** Sixteen (or twelve, or nine and three) numbers as people paste them; lengths in the page's unit. */
export function readMatrix(text) {
  const numbers = (text.replaceAll('−', '-').match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g) ?? []).map(Number);
  if (numbers.length !== 16 && numbers.length !== 12)
    throw new Error(
      `${numbers.length === 1 ? '1 number was' : `${numbers.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`,
    );
  const T = numbers.length === 16 ? numbers : [...numbers, 0, 0, 0, 1];
  if (Math.abs(T[12]) + Math.abs(T[13]) + Math.abs(T[14]) + Math.abs(T[15] - 1) > 1e-9)
    throw new Error('the last row must be 0 0 0 1');
  if (!T.every(Number.isFinite)) throw new Error('a number is not finite');
  const defect = rotationDefect(T);
  if (defect > TYPED)
    throw new Error(
      defect === Infinity
        ? 'the upper left block is left-handed, so it is no rotation'
        : `the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${defect.toPrecision(2)}`,
    );
  for (const i of [3, 7, 11]) T[i] /= units.factor('length');
  return nearestRotation(T);
}
