// A pose that is typed: as position and angles in the notation of the page, or as a matrix.
import { h, replace } from '../dom.mjs';
import { state, on, tell } from '../store.mjs';
import { numberField, remake } from '../numberfield.mjs';
import { block } from '../clipboard.mjs';
import { takePastesAlong } from '../pasting.mjs';
import { read as readNumber } from '../expression.mjs';
import { notations, poseFrom } from '../rotation.mjs';
import { position, nearestRotation, rotationDefect } from '../matrix.mjs';
import { units, halfDigit } from '../units.mjs';

/** How far four typed decimals may be from a rotation before they are refused rather than rounded to the nearest one. */
const TYPED = 2e-3;
/** What a number of a pose may lose on its way through what keeps it. */
const SAME = 1e-12;

/** @returns {el, show()}; take(T, {metres, radians}) is called with every readable pose and half of its last digits. */
export function poseEditor(title, id, get, take, key = id) {
  let parts = [],
    shown = '',
    said = null; // the pose that the fields speak of
  const row = h('div', { class: 'pose-fields' });
  const unread = () => parts.some((p) => p.f.classList.contains('wrong'));
  const fields = () => {
    const n = notations[state.notation];
    const names = [['X', 'length'], ['Y', 'length'], ['Z', 'length'], ...n.names.map((name, i) => [name, n.kinds[i]])];
    const read = () => {
      if (unread()) return;
      const T = poseFrom(
        state.notation,
        parts.slice(3).map((p) => p.value),
        parts.slice(0, 3).map((p) => p.value),
      );
      if (!T) return;
      said = T;
      take(T, digitsOf(parts));
    };
    parts = names.map(([name, kind], i) => {
      const p = { value: 0, kind };
      const heard = (v, how) => {
        p.value = v;
        p.text = how.text;
        read();
      };
      p.f = numberField({
        label: `${title}, ${name}`,
        kind,
        testid: `${id}-${i}`,
        key: `${key}-${i}`,
        input: heard,
        commit: (v, how) => {
          if (how.text !== p.text) heard(v, how);
          tell('let-go');
        },
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
    row.style.setProperty('--half', Math.ceil(parts.length / 2));
    shown = state.notation;
  };
  const show = () => {
    if (shown !== state.notation) {
      renew();
      return;
    }
    const T = get();
    if (!T) return;
    // what is typed stands as it was typed, and when the hand leaves it what cannot be read does, until there is another pose
    const anew = !said || T.some((v, i) => Math.abs(v - said[i]) > SAME);
    if (!anew && (unread() || row.contains(document.activeElement))) return;
    said = T;
    [...position(T), ...notations[state.notation].to(T)].forEach((v, i) => {
      parts[i].value = v;
      parts[i].text = null;
      parts[i].f.put(v, rounded(v, parts[i].kind), anew);
    });
  };
  const renew = () =>
    remake(row, () => {
      fields();
      show();
    });
  on('units', renew);
  on('notation', show);
  fields();
  show();
  takePastesAlong(row, 'paste a pose', () => parts.map((p) => p.f));
  row.addEventListener('focusout', () => setTimeout(show));
  return {
    el: h('fieldset', { class: 'pose-editor' }, h('legend', { text: title }), h('div', { class: 'pose-room' }, row)),
    show,
  };
}

/** Half of the last digits that were typed: metres of the position, radians of the orientation. */
function digitsOf(parts) {
  const typed = (list) => list.map((p) => p.text ?? '');
  const angles = parts.slice(3).filter((p) => p.kind === 'angle');
  const radians = angles.length > 1 ? halfDigit(typed(angles), 'angle') : 2 * halfDigit(typed(parts.slice(3)), 'plain');
  return { metres: halfDigit(typed(parts.slice(0, 3)), 'length'), radians };
}

/** Shown with a thousandth of a unit; the exact value stays behind it until the field is typed in. */
const rounded = (v, kind) =>
  String(
    Number((v * units.factor(kind)).toFixed(kind === 'plain' || units[kind] === 'm' || units[kind] === 'rad' ? 6 : 3)) +
      0,
  );

const WHERE = (i) => `row ${Math.floor(i / 4) + 1}, column ${(i % 4) + 1}`;
const isPlace = (i) => i % 4 === 3 && i < 12;
const entriesOf = (text) => block(text).flat().filter(Boolean);

/** Half of the last digits of a pasted matrix: of its last column, and twice that of the rotation's entries. */
export function matrixDigits(text) {
  const all = entriesOf(text).slice(0, 12);
  const last = all.filter((_, i) => isPlace(i)),
    turn = all.filter((_, i) => !isPlace(i));
  return { metres: halfDigit(last, 'length'), radians: 2 * halfDigit(turn, 'plain') };
}

/** Sixteen (or twelve, or nine and three) numbers as people paste them; lengths in the page's unit. */
export function readMatrix(text) {
  const entries = entriesOf(text);
  if (entries.length !== 16 && entries.length !== 12)
    throw new Error(
      `${entries.length === 1 ? '1 number was' : `${entries.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`,
    );
  const numbers = entries.map((entry, i) => {
    try {
      return readNumber(entry, isPlace(i) ? 'length' : 'plain').value;
    } catch (error) {
      throw new Error(`${WHERE(i)}: ${error.message}`);
    }
  });
  const T = numbers.length === 16 ? numbers : [...numbers, 0, 0, 0, 1];
  if (Math.abs(T[12]) + Math.abs(T[13]) + Math.abs(T[14]) + Math.abs(T[15] - 1) > 1e-9)
    throw new Error('the last row must be 0 0 0 1');
  const defect = rotationDefect(T);
  if (defect > TYPED)
    throw new Error(
      defect === Infinity
        ? 'the upper left block is left-handed, so it is no rotation'
        : `the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${defect.toPrecision(2)}`,
    );
  return nearestRotation(T);
}
