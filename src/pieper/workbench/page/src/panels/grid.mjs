// A 4x4 pose as numbers between brackets.
import { h, setText } from '../dom.mjs';
import { fixed, units } from '../units.mjs';

export function matrixGrid(label, testid) {
  const cells = Array.from({ length: 16 }, (_, k) =>
    h('span', { role: 'cell', class: k % 4 === 3 && k < 12 ? 'p' : k >= 12 ? 'last' : '' }),
  );
  const el = h(
    'div',
    { class: 'matrix', role: 'table', 'aria-label': label, 'data-testid': testid },
    [0, 4, 8, 12].map((r) => h('div', { role: 'row', class: 'matrix-row' }, cells.slice(r, r + 4))),
  );
  el.show = (T) => {
    for (let k = 0; k < 16; k++) {
      const isLength = k % 4 === 3 && k < 12;
      setText(
        cells[k],
        k >= 12
          ? String(T[k])
          : isLength
            ? fixed(T[k] * units.factor('length'), units.digits('length'))
            : fixed(T[k], 4),
      );
    }
  };
  return el;
}

/** The pose as text that Python, MATLAB and a spreadsheet read alike: SI, one row a line. */
export const matrixText = (T) =>
  [0, 4, 8, 12]
    .map(
      (r) =>
        `[${T.slice(r, r + 4)
          .map((v) => Number(v.toPrecision(12)) + 0)
          .join(', ')}]`,
    )
    .join(',\n');
