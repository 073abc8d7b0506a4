// Pose: the live 4x4 matrix, position and orientation in the notation that the person picks, to copy with one click.
import { button, copy, h, replace, select, setText } from '../dom.mjs';
import { state, on, tell } from '../store.mjs';
import { units, show, fixed } from '../units.mjs';
import { notations } from '../rotation.mjs';
import { position } from '../matrix.mjs';
import { matrixGrid, matrixText } from './grid.mjs';

const tool = () => state.frames[state.frames.length - 1];

export const pose = {
  id: 'pose',
  title: 'Pose',
  build(root) {
    const grid = matrixGrid('Pose of the tool in the base frame', 'pose');
    const where = ['X', 'Y', 'Z'].map((name) => quantity(name, 'length', `pose-${name.toLowerCase()}`));
    const turns = h('div', { class: 'quantities', 'data-testid': 'orientation' });
    const order = h('p', { class: 'hint order' });
    let parts = [];
    const pick = select(
      'Notation of the orientation',
      Object.entries(notations).map(([k, v]) => [k, v.title]),
      state.notation,
      (v) => {
        state.notation = v;
        tell('notation');
      },
    );
    const copies = h(
      'span',
      { class: 'copies' },
      button('Copy matrix', { class: 'quiet', title: 'As numbers in metres, row by row' }, () =>
        copy(matrixText(tool())),
      ),
      button('Copy numbers', { class: 'quiet', title: 'Position and orientation, in the units shown' }, () =>
        copy(asNumbers()),
      ),
    );
    root.append(
      h('div', { class: 'subhead' }, h('span', { text: 'Tool in the base frame' }), copies),
      grid,
      h(
        'div',
        { class: 'quantities' },
        where.map((w) => w.el),
      ),
      h('div', { class: 'line' }, pick, order),
      turns,
    );

    const renote = () => {
      const n = notations[state.notation];
      pick.value = state.notation;
      setText(order, n.order);
      parts = n.names.map((name, i) => quantity(name, n.kinds[i], `turn-${i}`));
      replace(
        turns,
        parts.map((p) => p.el),
      );
      update();
    };
    const update = () => {
      const T = tool();
      grid.show(T);
      position(T).forEach((v, i) => where[i].show(v));
      notations[state.notation].to(T).forEach((v, i) => parts[i].show(v));
    };
    on('q', update);
    on('notation', renote);
    on('units', () => {
      where.forEach((w) => w.relabel());
      parts.forEach((p) => p.relabel());
      update();
    });
    renote();
  },
};

function asNumbers() {
  const T = tool(),
    n = notations[state.notation];
  const p = position(T).map((v, i) => `${'XYZ'[i]} ${show(v, 'length')} ${units.symbol('length')}`);
  const r = n
    .to(T)
    .map(
      (v, i) =>
        `${n.names[i]} ${n.kinds[i] === 'angle' ? `${show(v, 'angle')} ${units.symbol('angle')}` : fixed(v, 5)}`,
    );
  return `${p.join(', ')}; ${r.join(', ')} (${n.order})`.replaceAll('−', '-');
}

/** One named number with its unit. */
export function quantity(name, kind, testid) {
  const value = h('output', { 'data-testid': testid }),
    unit = h('span', { class: 'unit', text: units.symbol(kind) });
  const el = h('div', { class: 'quantity' }, h('span', { class: 'quantity-name', text: name }), value, unit);
  return {
    el,
    show: (v) => setText(value, kind === 'plain' ? fixed(v, 5) : show(v, kind)),
    relabel: () => setText(unit, units.symbol(kind)),
  };
}
