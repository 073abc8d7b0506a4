// Inverse: a target typed, taken or dragged; every solution as a row and as a ghost; the reason in words when there is none.
import { atMostEvery, button, choice, h, replace, select, setText } from '../dom.mjs';
import { state, on, setTarget, tell } from '../store.mjs';
import { units, show, showUnit } from '../units.mjs';
import { moveTo } from '../animate.mjs';
import { position } from '../matrix.mjs';
import { reach } from '../kinematics.mjs';
import { solve, drawGhosts, options, answered, late } from '../solving.mjs';
import { busy } from '../late.mjs';
import { showBeside } from '../scene/arm.mjs';
import * as gizmo from '../scene/gizmo.mjs';
import { poseEditor, readMatrix, matrixDigits } from './pose_editor.mjs';
import { matrixText } from './grid.mjs';
import { showSelfMotions, followArm } from './self_motions.mjs';
import { spareCoordinates } from './spare.mjs';
import { solutionTable } from './solution_table.mjs';

const tones = {
  SOLVED: 'good',
  SINGULAR: 'note',
  REDUNDANT: 'note',
  OUT_OF_REACH: 'wrong',
  OUTSIDE_LIMITS: 'wrong',
  UNCERTAIN: 'wrong',
  REFUSED: 'wrong',
};
const words = {
  OUT_OF_REACH: 'Out of reach',
  OUTSIDE_LIMITS: 'Outside the limits',
  UNCERTAIN: 'Not certain',
  REFUSED: 'Refused',
};

/** What is said of these begins with the number of solutions, of a singular pose with that of its self-motions. */
const counted = new Set(['REDUNDANT', 'UNCERTAIN', 'SINGULAR']);
/** The rows stand for all of it, also for what lies outside the limits. */
const listed = (n, inside) =>
  `Listed ${n === 1 ? 'is 1 posture' : `are ${n} postures`}${inside === n ? '' : `, ${inside} inside the limits`}.`;

/** Milliseconds between two changes of the numbers while the hand drags the target. */
const READABLE = 120;

/** Present pose as target: what the first opening of this panel and the button do. */
export function takePresent() {
  setTarget(state.frames[state.frames.length - 1].slice(), 'taken');
}

export const inverse = {
  id: 'inverse',
  title: 'Inverse',
  wide: true,
  build(root, panel) {
    root.append(
      h(
        'div',
        { class: 'line spread' },
        button('Take the present pose', { 'data-testid': 'take-pose' }, takePresent),
        choice(
          'Target as',
          [
            ['numbers', 'Position and angles'],
            ['matrix', 'Matrix'],
          ],
          'numbers',
          (v) => {
            numbers.hidden = v !== 'numbers';
            matrix.hidden = v !== 'matrix';
          },
          'target-as',
        ),
      ),
    );
    const editor = poseEditor(
      'Target',
      'target',
      () => state.target,
      (T, digits) => setTarget(T, 'typed', digits),
    );
    const numbers = h('div', {}, editor.el);
    const { el: matrix, show: showMatrix } = matrixEditor();
    root.append(numbers, matrix, controls());
    const verdict = h('p', { class: 'verdict', 'data-testid': 'ik-verdict', role: 'status' });
    const near = h('div', { class: 'near', 'data-testid': 'ik-nearest' });
    const motions = h('div', { class: 'self-motions', 'data-testid': 'self-motions' });
    const list = solutionTable();
    const parts = h('div', { class: 'answer', 'data-testid': 'ik-answer' }, near, motions, list.el);
    root.append(spareCoordinates(), verdict, parts);

    // The picture follows the hand with every answer; numbers that change more often than this cannot be read anyway.
    const showTarget = atMostEvery(READABLE, () => {
      editor.show();
      showMatrix();
    });
    const showAnswer = atMostEvery(READABLE, () => {
      if (panel.hidden) return;
      const s = state.solutions,
        old = !answered() && !gizmo.isDragging();
      busy(old, verdict, parts);
      parts.classList.toggle('stale', old && late());
      parts.inert = old; // of what was asked before: nobody goes there by mistake
      showVerdict(verdict, old && late() ? null : s);
      showNear(near, old && late() ? null : s);
      showSelfMotions(motions, s);
      list.show(s);
    });
    const mark = atMostEvery(READABLE, () => list.mark());
    const follow = atMostEvery(READABLE, () => panel.hidden || followArm(motions, state.solutions));
    const atOnce = (run) => () => (gizmo.isDragging() ? run.soon() : run());
    on('target', atOnce(showTarget));
    on('notation', editor.show);
    on(['solutions', 'units'], atOnce(showAnswer));
    on(['asked', 'late'], () => {
      if (panel.hidden || gizmo.isDragging() || answered()) return;
      if (late()) showAnswer();
      busy(true, verdict, parts);
      parts.inert = true;
    });
    on('q', atOnce(mark));
    on('q', (why) => why !== 'self-motion' && follow.soon());
    const beside = () => showBeside('target', state.panel === 'inverse' ? withHandles(position(state.target)) : []);
    on('target', (why) => why !== 'drag' && beside());
    on('panel', (id) => {
      gizmo.show(id === 'inverse');
      if (id !== 'inverse' || state.hasTarget) beside();
      if (id !== 'inverse') return;
      if (!state.hasTarget) {
        state.hasTarget = true;
        takePresent();
      } else tell('solutions');
    });
    on('table', (what) => {
      if (what === 'new') {
        state.hasTarget = state.panel === 'inverse';
        if (state.hasTarget) takePresent();
      }
    });
  },
};

/** The target with what its handles take of the picture. */
function withHandles(p) {
  const r = 0.25 * reach(state.table);
  return [0, 1, 2].flatMap((k) => [r, -r].map((v) => p.map((c, i) => (i === k ? c + v : c))));
}

function matrixEditor() {
  const area = h('textarea', {
    rows: '4',
    'aria-label': 'Target as a matrix',
    'data-testid': 'target-matrix',
    spellcheck: 'false',
  });
  const reason = h('p', { class: 'reason', role: 'alert' });
  const hint = h('p', { class: 'hint' });
  area.addEventListener('input', () => {
    try {
      setTarget(readMatrix(area.value), 'typed', matrixDigits(area.value));
      setText(reason, '');
      area.removeAttribute('aria-invalid');
    } catch (error) {
      setText(reason, error.message);
      area.setAttribute('aria-invalid', 'true');
    }
  });
  let said = null; // the target that stands here
  const showMatrix = () => {
    setText(hint, `Twelve or sixteen numbers, row by row; the last column in ${units.length}.`);
    if (document.activeElement === area) return;
    // what cannot be read stands until there is another target
    if (area.hasAttribute('aria-invalid') && said === state.target) return;
    said = state.target;
    setText(reason, '');
    area.removeAttribute('aria-invalid');
    const T = state.target.map((v, i) => (i % 4 === 3 && i < 12 ? v * units.factor('length') : v));
    area.value = matrixText(T.map((v) => Number(v.toFixed(6)))).replaceAll(',\n', '\n');
  };
  on('units', showMatrix);
  showMatrix();
  return { el: h('div', { hidden: true }, area, hint, reason), show: showMatrix };
}

function controls() {
  const task = h('span', { class: 'line' });
  const follow = h('input', {
    type: 'checkbox',
    checked: true,
    'data-testid': 'follow',
    on: {
      change: () => {
        options.follow = follow.checked;
      },
    },
  });
  const ghosts = choice(
    'Ghosts',
    [
      ['all', 'All'],
      ['inside', 'In limits'],
      ['none', 'None'],
    ],
    'all',
    (v) => {
      options.ghosts = v;
      drawGhosts();
    },
  );
  on('task', () => {
    follow.checked = options.follow;
    ghosts.mark(options.ghosts);
  });
  on('plan', () =>
    replace(
      task,
      state.plan?.solvable
        ? [
            h('span', { class: 'field-name', text: 'Task' }),
            select(
              'Task',
              [
                ['', `${state.plan.task} (default)`],
                ['pose', 'pose'],
                ['position', 'position'],
                ['position+axis', 'position + axis'],
              ],
              options.task ?? '',
              (v) => {
                tell('did', { label: 'choose the task' });
                options.task = v || null;
                options.redundancy = null;
                solve();
              },
              { 'data-testid': 'task' },
            ),
          ]
        : [],
    ),
  );
  return h(
    'div',
    { class: 'line controls' },
    h(
      'span',
      { class: 'line' },
      h('span', { class: 'field-name', text: 'Handles' }),
      choice(
        'Handles',
        [
          ['both', 'Both'],
          ['move', 'Move'],
          ['turn', 'Turn'],
        ],
        'both',
        gizmo.setMode,
      ),
    ),
    choice(
      'Axes of the handles',
      [
        ['local', 'Tool'],
        ['world', 'World'],
      ],
      'local',
      gizmo.setSpace,
    ),
    h(
      'span',
      { class: 'line' },
      h('span', { class: 'field-name', text: 'Snap' }),
      select(
        'Snap to whole steps',
        [
          ['0', 'off'],
          ['1', '1 mm, 1°'],
          ['5', '5 mm, 5°'],
          ['10', '10 mm, 10°'],
          ['45', '45 mm, 45°'],
        ],
        '0',
        (v) => gizmo.setSnap(Number(v)),
        { 'data-testid': 'snap', title: 'While dragging; Shift snaps to 5 at any time' },
      ),
    ),
    h('span', { class: 'line' }, h('span', { class: 'field-name', text: 'Ghosts' }), ghosts),
    h('label', { class: 'check' }, follow, 'Arm follows'),
    task,
  );
}

function showVerdict(el, s) {
  if (!s) {
    replace(el, h('span', { text: 'Solving …' }));
    el.dataset.tone = 'note';
    return;
  }
  const n = s.rows.length,
    inside = s.rows.filter((r) => r.inside).length;
  el.dataset.tone = tones[s.status] ?? 'note';
  const said = n > 0 && counted.has(s.status);
  const told =
    s.status === 'SOLVED' && n
      ? roundedBy(s.missed)
      : [s.why, said && (s.status === 'SINGULAR' || inside < n) ? listed(n, inside) : '', roundedBy(s.missed)]
          .filter(Boolean)
          .join(' ');
  const head =
    words[s.status] && !inside
      ? s.why.toLowerCase().includes(words[s.status].toLowerCase())
        ? ''
        : words[s.status]
      : said
        ? ''
        : `${n} solution${n === 1 ? '' : 's'}${inside === n ? '' : `, ${inside} inside the limits`}`;
  replace(
    el,
    h('strong', { text: head }),
    ' ',
    h('span', { text: told }),
    s.ms === undefined
      ? null
      : h('span', {
          class: 'hint took',
          text: `${s.ms < 1 ? `${Math.round(s.ms * 1000)} µs` : `${s.ms.toFixed(1)} ms`}`,
        }),
  );
}

/** By how much the pose that was solved misses the one that was typed, where its digits ended too soon. */
const roundedBy = (missed) =>
  missed
    ? `The pose was rounded by ${misses(missed) || 'less than its digits'} when typed; solved is the nearest one that the arm takes.`
    : '';
const finely = (v, kind) => showUnit(v, kind, units.digits(kind) + 2);
const misses = (m) =>
  [
    [m.metres, 'length'],
    [m.radians, 'angle'],
  ]
    .filter(([v, kind]) => v * units.factor(kind) >= 0.5 * 10 ** -(units.digits(kind) + 2))
    .map(([v, kind]) => finely(v, kind))
    .join(' and ');

function showNear(el, s) {
  const near = s?.near;
  if (!near) {
    replace(el);
    return;
  }
  const p = position(near.T)
    .map((v) => show(v, 'length'))
    .join(', ');
  replace(
    el,
    h(
      'p',
      {},
      h('strong', { text: 'Nearest reachable: ' }),
      `${p} ${units.symbol('length')}, ${showUnit(near.metres, 'length')} away`,
      near.radians > 1e-3 ? `, turned by ${showUnit(near.radians, 'angle')}` : '',
    ),
    h(
      'div',
      { class: 'line' },
      button('Go there', {}, () => moveTo(near.q)),
      button('Make it the target', {}, () => setTarget(near.T, 'chosen')),
    ),
  );
}
