// Matrices: every A_i with numbers, partial products, and the intermediate angles, for the present posture or a solution.
import { h, replace, setText, choice, select, perFrame } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { linkMatrices, rowAt, chainValues, frames as forward } from '../kinematics.mjs';
import { mul, identity, invert } from '../matrix.mjs';
import { units, showUnit, show } from '../units.mjs';
import { matrixGrid } from './grid.mjs';
import { kindOf } from './joints.mjs';

/** Sums and differences of neighbouring joints whose axes are parallel: theta_23, theta_345 ... as derivations use them. */
export function parallelSums(table, q) {
  const out = [],
    n = table.joints.length,
    moved = chainValues(table, q);
  const twistAfter = (i) => (table.convention === 'standard' ? table.joints[i].alpha : table.joints[i + 1]?.alpha);
  for (let i = 0; i < n - 1; i++) {
    let sum = rowAt(table.joints[i], moved[i]).theta,
      sign = 1,
      name = `${i + 1}`;
    for (let k = i; k < n - 1; k++) {
      const alpha = twistAfter(k);
      if (Math.abs(Math.sin(alpha)) > 1e-9 || table.joints[k + 1].type !== 'R' || table.joints[i].type !== 'R') break;
      sign *= Math.sign(Math.cos(alpha));
      sum += sign * rowAt(table.joints[k + 1], moved[k + 1]).theta;
      name += `${sign > 0 ? '' : '−'}${k + 2}`;
      out.push({ name, value: sum });
    }
  }
  return out;
}

export const matrices = {
  id: 'matrices',
  title: 'Matrices',
  wide: true,
  build(root) {
    let mode = 'links',
      whose = 'now',
      from = 0,
      to = 0,
      grids = [];
    const cards = h('div', { class: 'cards', 'data-testid': 'matrices' });
    const angles = h('table', { class: 'plain', 'data-testid': 'angles', 'aria-label': 'Intermediate angles' });
    const pickWhose = select('Posture', [['now', 'present posture']], 'now', (v) => {
      whose = v;
      update();
    });
    const partial = h('span', { class: 'partial' });
    root.append(
      h(
        'div',
        { class: 'line' },
        choice(
          'Matrices shown',
          [
            ['links', 'Each A'],
            ['products', 'Products from the base'],
            ['partial', 'Between two frames'],
          ],
          mode,
          (v) => {
            mode = v;
            rebuild();
          },
          'matrix-mode',
        ),
        partial,
      ),
      h('div', { class: 'line' }, h('span', { class: 'field-name', text: 'Numbers of the' }), pickWhose),
      cards,
      h('h3', { text: 'Intermediate angles' }),
      h('p', {
        class: 'hint',
        text: 'Each θ with the maker’s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them.',
      }),
      angles,
    );

    const posture = () => (whose !== 'now' && state.solutions?.rows[Number(whose)]?.q) || state.q;
    const rebuild = () => {
      const n = state.table.joints.length;
      from = Math.min(from, n);
      to = to === 0 || to > n ? n : to;
      const names =
        mode === 'links'
          ? state.table.joints.map((_, i) => [`A`, String(i + 1), ''])
          : mode === 'products'
            ? state.table.joints.map((_, i) => ['T', String(i + 1), '0'])
            : [['T', String(to), String(from)]];
      if (mode === 'links') names.push(['T', 'tool', 'base']);
      const ends = Array.from({ length: n + 1 }, (_, i) => [String(i), String(i)]);
      replace(
        partial,
        mode === 'partial'
          ? [
              select('From frame', ends, String(from), (v) => {
                from = Number(v);
                rebuild();
              }),
              ' → ',
              select('To frame', ends, String(to), (v) => {
                to = Number(v);
                rebuild();
              }),
            ]
          : [],
      );
      grids = names.map(([sym, low, high]) => ({
        grid: matrixGrid(`${sym} ${high} ${low}`, `matrix-${sym}${high}${high ? '-' : ''}${low}`),
        note: h('span', { class: 'hint' }),
        sym,
        low,
        high,
      }));
      replace(
        cards,
        grids.map(({ grid, note, sym, low, high }) =>
          h(
            'figure',
            { class: 'card' },
            h(
              'figcaption',
              {},
              h(
                'span',
                { class: 'symbol' },
                high ? h('sup', { text: high }) : null,
                h('i', { text: sym }),
                h('sub', { text: low }),
              ),
              note,
            ),
            grid,
          ),
        ),
      );
      update.now();
    };
    const update = perFrame(() => {
      if (root.closest('.panel').hidden || !state.table.joints.length) return;
      const q = posture(),
        A = linkMatrices(state.table, q),
        n = A.length;
      grids.forEach(({ grid, note }, i) => {
        if (mode === 'links' && i < n) {
          grid.show(A[i]);
          setText(note, `q${i + 1} = ${showUnit(q[i], kindOf(state.table.joints[i]))}`);
        } else if (mode === 'links') grid.show(forward(state.table, q)[n + 1]);
        else if (mode === 'products') grid.show(A.slice(0, i + 1).reduce(mul, identity()));
        else {
          const up = (k) => A.slice(0, k).reduce(mul, identity());
          grid.show(mul(invert(up(from)), up(to)));
        }
      });
      const moved = chainValues(state.table, q);
      const rows = state.table.joints
        .map((j, i) => [
          j.type === 'R' ? `θ${i + 1}` : `d${i + 1}`,
          j.type === 'R' ? show(rowAt(j, moved[i]).theta, 'angle') : show(rowAt(j, moved[i]).d, 'length'),
          j.type === 'R' ? 'angle' : 'length',
        ])
        .concat(parallelSums(state.table, q).map(({ name, value }) => [`θ${name}`, show(value, 'angle'), 'angle']));
      replace(
        angles,
        h(
          'tbody',
          {},
          rows.map(([name, value, kind]) =>
            h(
              'tr',
              {},
              h('th', { scope: 'row' }, h('i', { text: name[0] }), h('sub', { text: name.slice(1) })),
              h('td', { text: value }),
              h('td', { class: 'unit', text: units.symbol(kind) }),
            ),
          ),
        ),
      );
    });
    const list = () => {
      if (root.closest('.panel').hidden) return;
      const rows = state.solutions?.rows ?? [];
      replace(
        pickWhose,
        h('option', { value: 'now', text: 'present posture' }),
        rows.map((r, i) => h('option', { value: String(i), text: `solution ${i + 1}: ${r.label ?? ''}` })),
      );
      if (whose !== 'now' && !rows[Number(whose)]) whose = 'now';
      pickWhose.value = whose;
      update();
    };
    on('table', rebuild);
    on(['q', 'units'], update);
    on('panel', update.now);
    on(['solutions', 'panel'], list);
    rebuild();
  },
};
