// Inverse: a target typed, taken or dragged; every solution as a row and as a ghost; the reason in words when there is none.
import { h, replace, setText, choice, select } from '../dom.mjs';
import { state, on, setTarget, setJoints, tell } from '../store.mjs';
import { units, show, showUnit, tiny } from '../units.mjs';
import { numberField } from '../numberfield.mjs';
import { moveTo, stop } from '../animate.mjs';
import { position } from '../matrix.mjs';
import { ontoPose } from '../kinematics.mjs';
import { solve, drawGhosts, options } from '../solving.mjs';
import { showPreview } from '../scene/arm.mjs';
import * as gizmo from '../scene/gizmo.mjs';
import { poseEditor, readMatrix } from './pose_editor.mjs';
import { matrixText } from './grid.mjs';
import { kindOf } from './joints.mjs';

const tones = { SOLVED: 'good', SINGULAR: 'note', REDUNDANT: 'note', OUT_OF_REACH: 'wrong', OUTSIDE_LIMITS: 'wrong', UNCERTAIN: 'wrong', REFUSED: 'wrong' };
const words = { OUT_OF_REACH: 'Out of reach', OUTSIDE_LIMITS: 'Outside the limits', UNCERTAIN: 'Not certain', REFUSED: 'Refused' };

/** Present pose as target: what the first opening of this panel and the button do. */
export function takePresent() { setTarget(state.frames[state.frames.length - 1].slice(), 'taken'); }

export const inverse = {
  id: 'inverse', title: 'Inverse', wide: true,
  build(root, panel) {
    root.append(h('div', { class: 'line spread' },
      h('button', { type: 'button', text: 'Take the present pose', 'data-testid': 'take-pose', on: { click: takePresent } }),
      choice('Target as', [['numbers', 'Position and angles'], ['matrix', 'Matrix']], 'numbers', (v) => { numbers.hidden = v !== 'numbers'; matrix.hidden = v !== 'matrix'; }, 'target-as')));
    const editor = poseEditor('Target', 'target', () => state.target, (T) => setTarget(T, 'typed'));
    const numbers = h('div', {}, editor.el);
    const { el: matrix, show: showMatrix } = matrixEditor();
    root.append(numbers, matrix, controls());
    const verdict = h('p', { class: 'verdict', 'data-testid': 'ik-verdict', role: 'status' });
    const near = h('div', { class: 'near', 'data-testid': 'ik-nearest' });
    const families = h('div', { class: 'families', 'data-testid': 'families' });
    const list = solutionTable();
    root.append(verdict, near, families, list.el);

    on('target', () => { editor.show(); showMatrix(); });
    on('notation', editor.show);
    on(['solutions', 'units'], () => {
      if (panel.hidden) return;
      const s = state.solutions;
      showVerdict(verdict, s);
      showNear(near, s);
      showFamilies(families, s);
      list.show(s);
    });
    on('q', () => list.mark());
    on('panel', (id) => {
      gizmo.show(id === 'inverse');
      if (id !== 'inverse') return;
      if (!state.hasTarget) { state.hasTarget = true; takePresent(); } else tell('solutions');
    });
    on('table', (what) => { if (what === 'new') { state.hasTarget = state.panel === 'inverse'; if (state.hasTarget) takePresent(); } });
  },
};

function matrixEditor() {
  const area = h('textarea', { rows: '4', 'aria-label': 'Target as a matrix', 'data-testid': 'target-matrix', spellcheck: 'false' });
  const reason = h('p', { class: 'reason', role: 'alert' });
  const hint = h('p', { class: 'hint' });
  area.addEventListener('input', () => {
    try { setTarget(readMatrix(area.value), 'typed'); setText(reason, ''); area.removeAttribute('aria-invalid'); } catch (error) { setText(reason, error.message); area.setAttribute('aria-invalid', 'true'); }
  });
  const showMatrix = () => {
    setText(hint, `Twelve or sixteen numbers, row by row; the last column in ${units.length}.`);
    if (document.activeElement === area) return;
    const T = state.target.map((v, i) => (i % 4 === 3 && i < 12 ? v * units.factor('length') : v));
    area.value = matrixText(T.map((v) => Number(v.toFixed(6)))).replaceAll(',\n', '\n');
  };
  on('units', showMatrix);
  showMatrix();
  return { el: h('div', { hidden: true }, area, hint, reason), show: showMatrix };
}

function controls() {
  const redundancy = h('span', { class: 'line' });
  const task = h('span', { class: 'line' });
  const follow = h('input', { type: 'checkbox', checked: true, 'data-testid': 'follow', on: { change: () => { options.follow = follow.checked; } } });
  on('plan', () => {
    const names = state.plan?.redundancy ?? [];
    replace(redundancy, names.length === 1 ? [h('span', { class: 'field-name', text: `Free joint ${names[0]} at` }), numberField({ label: `Value of ${names[0]}`, kind: 'angle', empty: null, testid: 'redundancy', commit: (v) => { options.redundancy = v; solve(); } })] : []);
    options.task = null;
    replace(task, state.plan?.solvable ? [h('span', { class: 'field-name', text: 'Task' }), select('Task', [['', `${state.plan.task} (default)`], ['pose', 'pose'], ['position', 'position'], ['position+axis', 'position + axis']], '', (v) => { options.task = v || null; solve(); }, { 'data-testid': 'task' })] : []);
  });
  return h('div', { class: 'line controls' },
    h('span', { class: 'line' }, h('span', { class: 'field-name', text: 'Handles' }), choice('Handles', [['both', 'Both'], ['move', 'Move'], ['turn', 'Turn']], 'both', gizmo.setMode)),
    choice('Axes of the handles', [['local', 'Tool'], ['world', 'World']], 'local', gizmo.setSpace),
    h('span', { class: 'line' }, h('span', { class: 'field-name', text: 'Ghosts' }), choice('Ghosts', [['all', 'All'], ['inside', 'In limits'], ['none', 'None']], 'all', (v) => { options.ghosts = v; drawGhosts(); })),
    h('label', { class: 'check' }, follow, 'Arm follows'), task, redundancy);
}

function showVerdict(el, s) {
  if (!s) { replace(el, h('span', { text: 'Solving …' })); el.dataset.tone = 'note'; return; }
  const n = s.rows.length, inside = s.rows.filter((r) => r.inside).length;
  el.dataset.tone = tones[s.status] ?? 'note';
  const head = words[s.status] && !inside ? words[s.status] : inside === n ? `${n} solution${n === 1 ? '' : 's'}` : `${n} solutions, ${inside} inside the limits`;
  replace(el, h('strong', { text: head }), ' ', h('span', { text: s.status === 'SOLVED' && s.rows.length ? '' : s.why }), s.ms === undefined ? null : h('span', { class: 'hint took', text: `${s.ms < 1 ? `${Math.round(s.ms * 1000)} µs` : `${s.ms.toFixed(1)} ms`}` }));
}

function showNear(el, s) {
  const near = s?.near;
  if (!near) { replace(el); return; }
  const p = position(near.T).map((v) => show(v, 'length')).join(', ');
  replace(el, h('p', {}, h('strong', { text: 'Nearest reachable: ' }), `${p} ${units.symbol('length')}, ${showUnit(near.metres, 'length')} away`, near.radians > 1e-3 ? `, turned by ${showUnit(near.radians, 'angle')}` : ''),
    h('div', { class: 'line' }, h('button', { type: 'button', text: 'Go there', on: { click: () => moveTo(near.q) } }),
      h('button', { type: 'button', text: 'Make it the target', on: { click: () => setTarget(near.T, 'taken') } })));
}

/** A slider for each continuous family: the arm moves, the tool stands still. */
function showFamilies(el, s) {
  const list = s?.families ?? [], exact = !options.task && state.plan?.task === 'pose';
  if (el.drawn === list) return;
  el.drawn = list;
  replace(el, list.map((family, k) => {
    const slider = h('input', { type: 'range', min: '0', max: '1', step: 'any', value: '0', 'aria-label': `Along family ${k + 1}`, 'data-testid': `family-${k + 1}` });
    const go = () => {
      stop();
      const at = Number(slider.value), i = Math.max(family.s.findLastIndex((v) => v <= at), 0), j = Math.min(i + 1, family.q.length - 1);
      const f = j > i ? (at - family.s[i]) / (family.s[j] - family.s[i]) : 0;
      slider.style.setProperty('--at', `${100 * at}%`);
      const between = family.q[i].map((v, m) => v + f * (family.q[j][m] - v));
      setJoints(exact ? ontoPose(state.table, between, s.T) : between, 'family');
    };
    // the thumb begins where the arm is; the reddish parts of the track lie outside the limits
    const apart = (v) => v.reduce((sum, x, m) => sum + Math.sin((x - state.q[m]) / 2) ** 2, 0);
    slider.value = String(family.s[family.q.reduce((best, v, m) => (apart(v) < apart(family.q[best]) ? m : best), 0)]);
    slider.style.setProperty('--at', `${100 * Number(slider.value)}%`);
    if (family.inside.length === 1) {
      slider.style.setProperty('--lo', `${100 * family.inside[0][0]}%`);
      slider.style.setProperty('--hi', `${100 * family.inside[0][1]}%`);
    }
    slider.addEventListener('input', go);
    slider.addEventListener('keydown', (e) => {
      const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[e.key];
      if (!way) return;
      e.preventDefault();
      slider.value = Math.min(Math.max(Number(slider.value) + way / 100, 0), 1);
      go();
    });
    const moves = family.moves.length > 3 ? 'all its joints' : family.moves.join(' and ');
    return h('div', { class: 'family' }, h('p', {}, h('strong', { text: list.length > 1 ? `Self-motion ${k + 1} of ${list.length}` : 'Self-motion' }), ` by ${moves}, ${family.closed ? 'a closed curve' : 'an open curve'}: the arm moves, the tool stands still.`, family.inside.length ? '' : ' All of it lies outside the limits.'), slider);
  }));
}

/** Rows are kept and rewritten: a dragged gizmo changes them many times a second. */
function solutionTable() {
  const head = h('thead'), body = h('tbody');
  const hint = h('p', { class: 'hint below', text: 'Grey rows lie outside the limits; the joints in red exceed them.' });
  const el = h('div', { class: 'scroll' }, h('table', { class: 'plain solutions', 'data-testid': 'solutions', 'aria-label': 'Solutions' }, head, body), hint);
  let rows = [], made = '';
  const make = () => {
    const key = `${state.table.joints.map((j) => j.type).join('')}${units.angle}${units.length}`;
    if (key === made) return;
    made = key;
    rows = [];
    replace(body);
    replace(head, h('tr', {}, h('th', { text: '' }), h('th', { class: 'left', text: 'posture' }),
      state.table.joints.map((j, i) => h('th', {}, h('i', { text: 'q' }), h('sub', { text: String(i + 1) }), h('span', { class: 'unit', text: ` ${units.symbol(kindOf(j))}` }))), h('th', { text: 'residual' })));
  };
  const row = (k) => {
    const cells = state.table.joints.map(() => h('td')), label = h('span'), beyond = h('span', { class: 'offscreen' }), residual = h('td', { class: 'unit' });
    const tr = h('tr', { tabindex: '0', 'data-testid': `solution-${k + 1}` }, h('th', { scope: 'row', text: String(k + 1) }), h('td', { class: 'left' }, label, beyond), cells, residual);
    const q = () => state.solutions?.rows[k]?.q;
    const over = () => q() && showPreview(q()), out = () => showPreview(null), go = () => { if (q()) { showPreview(null); moveTo(shortest(q())); } };
    tr.addEventListener('pointerenter', over);
    tr.addEventListener('pointerleave', out);
    tr.addEventListener('focus', over);
    tr.addEventListener('blur', out);
    tr.addEventListener('click', go);
    tr.addEventListener('keydown', (e) => { if (e.key === 'Enter' || e.key === ' ') { e.preventDefault(); go(); } });
    return { tr, cells, label, beyond, residual };
  };
  return {
    el,
    show(s) {
      make();
      const list = s?.rows ?? [];
      while (rows.length < list.length) { const r = row(rows.length); rows.push(r); body.append(r.tr); }
      el.hidden = list.length === 0;
      hint.hidden = list.every((r) => r.inside);
      rows.forEach((r, k) => {
        const data = list[k];
        r.tr.hidden = !data;
        if (!data) return;
        r.tr.classList.toggle('beyond', !data.inside);
        setText(r.label, `${data.label}${data.family >= 0 ? ' (of a family)' : ''}`);
        setText(r.beyond, data.inside ? '' : ', outside the limits');
        setText(r.residual, data.residual ? `${tiny(data.residual[0] * 1000)} mm` : '');
        r.residual.title = data.residual ? `${tiny(data.residual[0])} m, ${tiny(data.residual[1])} rad by forward kinematics` : '';
        data.q.forEach((v, i) => {
          const j = state.table.joints[i], out = (j.lower !== null && v < j.lower - 1e-9) || (j.upper !== null && v > j.upper + 1e-9);
          setText(r.cells[i], show(v, kindOf(j), kindOf(j) === 'angle' && units.angle === 'deg' ? 1 : undefined));
          r.cells[i].classList.toggle('out', out);
        });
      });
      this.mark();
    },
    mark() {
      const list = state.solutions?.rows ?? [];
      rows.forEach((r, k) => r.tr.classList.toggle('here', Boolean(list[k]) && list[k].q.length === state.q.length && list[k].q.every((v, i) => Math.abs(Math.sin((v - state.q[i]) / 2)) < 1e-5)));
    },
  };
}

/** The same posture with each revolute joint a whole number of turns nearer to where it is, if its limits allow. */
function shortest(q) {
  return q.map((v, i) => {
    const j = state.table.joints[i];
    if (j.type !== 'R') return v;
    const w = v + 2 * Math.PI * Math.round((state.q[i] - v) / (2 * Math.PI));
    return (j.lower === null || w >= j.lower - 1e-9) && (j.upper === null || w <= j.upper + 1e-9) ? w : v;
  });
}
