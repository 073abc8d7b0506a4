// Analysis: how well the arm can move here, how near its limits are, and where its tool can be.
import { h, replace, setText, choice, perFrame } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { singularValues } from '../kinematics.mjs';
import { fixed, showUnit, engineering } from '../units.mjs';
import { showEllipsoid, ellipsoidShown } from '../scene/ellipsoid.mjs';
import { kindOf } from './joints.mjs';
import { reachControls } from './reach.mjs';

/** Rows of the Jacobian that the arm's own task is about. */
const moved = () => (state.plan?.task === 'position' ? 3 : 6);

export const analysis = {
  id: 'analysis',
  title: 'Analysis',
  build(root) {
    const facts = h('dl', { class: 'facts', 'data-testid': 'analysis' });
    const names = [
      [
        'manipulability',
        'Manipulability',
        '√det(J Jᵀ) of the rows that the arm’s task moves (JᵀJ where joints are fewer); in metres and radians, as in the cloud and the map',
      ],
      [
        'condition',
        'Condition number',
        'the largest singular value over the smallest, lengths divided by the arm’s; 1 is best',
      ],
      ['least', 'Smallest singular value', '0 at a singularity; lengths divided by the arm’s'],
    ];
    const out = {};
    for (const [key, name, title] of names)
      facts.append(
        h('div', { title }, h('dt', { text: name }), (out[key] = h('dd', { 'data-testid': `fact-${key}` }))),
      );
    const limits = h('div', { class: 'distances', 'data-testid': 'limit-distances' });
    let bars = [];
    const axesText = h('p', { class: 'hint', 'data-testid': 'ellipsoid-axes' });
    on('ellipsoid', () => {
      const axes = ellipsoidShown();
      setText(
        axesText,
        axes
          ? `Joint rates of norm 1 move the point at most ${axes.map((a) => showUnit(a.length, 'length')).join(', ')} a second along the three axes; forces are greatest where speeds are least.`
          : '',
      );
    });
    root.append(
      facts,
      h('h3', { text: 'At the tool’s point' }),
      choice(
        'Ellipsoid at the tool',
        [
          ['none', 'None'],
          ['velocity', 'Velocities'],
          ['force', 'Forces'],
        ],
        'none',
        showEllipsoid,
        'ellipsoid',
      ),
      axesText,
      h('h3', { text: 'Distance to the limits' }),
      limits,
      h('h3', { text: 'Where the tool can be' }),
      reachControls(),
    );

    const rebuild = () => {
      bars = state.table.joints.map((j, i) => {
        const fill = h('span', { class: 'bar-fill' }),
          text = h('span', { class: 'bar-text' });
        return {
          el: h(
            'div',
            { class: 'distance' },
            h('span', {}, h('i', { text: 'q' }), h('sub', { text: String(i + 1) })),
            h('span', { class: 'bar' }, fill),
            text,
          ),
          fill,
          text,
        };
      });
      replace(
        limits,
        bars.map((b) => b.el),
      );
      update.now();
    };
    const update = perFrame(() => {
      if (root.closest('.panel').hidden || !state.table.joints.length) return;
      const s = singularValues(state.table, state.q, state.frames),
        least = s[0],
        most = s[s.length - 1];
      setText(
        out.manipulability,
        engineering(singularValues(state.table, state.q, state.frames, 1, moved()).reduce((p, v) => p * v, 1)),
      );
      setText(out.condition, least > 1e-9 ? fixed(most / least, 1) : '∞');
      setText(out.least, engineering(least));
      facts.dataset.tone = least < 0.02 ? 'wrong' : 'good';
      bars.forEach(({ el, fill, text }, i) => {
        const j = state.table.joints[i],
          v = state.q[i];
        if (j.lower === null || j.upper === null) {
          fill.style.setProperty('width', '100%');
          setText(text, 'no limit');
          return;
        }
        const d = Math.min(v - j.lower, j.upper - v),
          part = Math.max((2 * d) / (j.upper - j.lower || 1), 0);
        fill.style.setProperty('width', `${100 * part}%`);
        el.classList.toggle('outside', d < -1e-9);
        setText(text, d < -1e-9 ? `${showUnit(-d, kindOf(j))} beyond` : showUnit(d, kindOf(j)));
      });
    });
    on('table', rebuild);
    on(['q', 'units', 'plan'], update);
    on('panel', update.now);
    rebuild();
  },
};
