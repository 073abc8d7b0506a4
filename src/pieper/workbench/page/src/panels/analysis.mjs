// Analysis: how well the arm can move here, how near its limits are, and where its tool can be.
import { button, choice, h, perFrame, replace, select, setText } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { singularValues } from '../kinematics.mjs';
import { fixed, showUnit } from '../units.mjs';
import { ask } from '../link.mjs';
import { askArm } from '../library.mjs';
import { showEllipsoid, ellipsoidShown } from '../scene/ellipsoid.mjs';
import * as cloud from '../scene/cloud.mjs';
import { showBeside, fitArm } from '../scene/arm.mjs';
import { kindOf } from './joints.mjs';

const colourings = [
  ['height', 'height of the tool'],
  ['manipulability', 'manipulability'],
  ['condition', 'inverse condition number'],
  ['limits', 'distance to the limits'],
];
const engineering = (v) =>
  v === 0 ? '0' : Math.abs(v) >= 1e-3 && Math.abs(v) < 1e4 ? fixed(v, 4) : v.toExponential(2).replace('-', '−');

export const analysis = {
  id: 'analysis',
  title: 'Analysis',
  build(root) {
    const facts = h('dl', { class: 'facts', 'data-testid': 'analysis' });
    const names = [
      [
        'manipulability',
        'Manipulability',
        'the product of the singular values of the Jacobian, lengths divided by the arm’s',
      ],
      ['condition', 'Condition number', 'the largest singular value over the smallest; 1 is best'],
      ['least', 'Smallest singular value', '0 at a singularity'],
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
      h('h3', { text: 'Reachable points' }),
      cloudControls(),
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
      update();
    };
    const update = perFrame(() => {
      if (root.closest('.panel').hidden || !state.table.joints.length) return;
      const s = singularValues(state.table, state.q, state.frames),
        least = s[0],
        most = s[s.length - 1];
      setText(out.manipulability, engineering(s.reduce((p, v) => p * v, 1)));
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
    on(['q', 'units', 'panel'], update);
    rebuild();
  },
};

function cloudControls() {
  let count = '20000',
    colour = 'manipulability',
    running = false;
  const start = button('Draw the cloud', { class: 'primary', 'data-testid': 'cloud-start' }, () =>
    running ? ask('cancel', { kind: 'cloud' }) : run(),
  );
  const clear = button('Clear', {}, wipe);
  const cut = choice(
    'Cloud shown',
    [
      ['whole', 'Whole'],
      ['half', 'Cut open'],
    ],
    'whole',
    (v) => cloud.cutAt(v === 'half' ? state.table.base[7] : null),
    'cloud-cut',
  );
  const progress = h('progress', {
    max: '1',
    'aria-label': 'Progress of the cloud',
    'data-testid': 'cloud-progress',
    hidden: true,
  });
  const note = h('p', { class: 'hint', role: 'status', 'data-testid': 'cloud-note' });
  const lo = h('span'),
    hi = h('span');
  const legend = h('div', { class: 'legend-scale', hidden: true }, lo, h('span', { class: 'scale-bar' }), hi);
  function wipe() {
    cloud.clear();
    showBeside('cloud', []);
    legend.hidden = true;
    setText(note, '');
  }
  async function run() {
    running = true;
    setText(start, 'Cancel');
    progress.hidden = false;
    progress.value = 0;
    legend.hidden = false;
    cloud.begin(Number(count));
    try {
      const end = await askArm('cloud', { count: Number(count), colour, seed: 1 }, (m) => {
        cloud.take(m.points);
        progress.value = m.done / m.of;
        setText(lo, engineering(cloud.range.lo));
        setText(hi, engineering(cloud.range.hi));
        setText(note, `${m.done.toLocaleString('en')} of ${m.of.toLocaleString('en')} points`);
      });
      setText(
        note,
        end.stopped
          ? `Cancelled after ${cloud.size().toLocaleString('en')} points.`
          : `${end.done.toLocaleString('en')} random postures inside the limits, coloured by ${colourings.find(([k]) => k === colour)[1]}${colour === 'height' ? ' (m)' : ''}.`,
      );
    } catch (error) {
      setText(note, error.message);
    }
    running = false;
    showBeside('cloud', cloud.corners());
    fitArm();
    setText(start, 'Draw the cloud');
    progress.hidden = true;
  }
  on('table', (what) => {
    if (what !== 'postures' && what !== 'name' && cloud.size()) wipe();
  });
  return h(
    'div',
    {},
    h(
      'div',
      { class: 'line' },
      select(
        'Number of points',
        [
          ['5000', '5,000 points'],
          ['20000', '20,000 points'],
          ['100000', '100,000 points'],
        ],
        count,
        (v) => {
          count = v;
        },
        { 'data-testid': 'cloud-count' },
      ),
      h('span', { class: 'field-name', text: 'coloured by' }),
      select(
        'Coloured by',
        colourings,
        colour,
        (v) => {
          colour = v;
        },
        { 'data-testid': 'cloud-colour' },
      ),
    ),
    h('div', { class: 'line' }, start, clear, cut),
    progress,
    legend,
    note,
  );
}
