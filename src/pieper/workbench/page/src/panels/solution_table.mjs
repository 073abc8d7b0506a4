// Every solution as a row: hover or focus to see it, click or press Enter to go there.
import { h, replace, setText } from '../dom.mjs';
import { state } from '../store.mjs';
import { units, show, tiny } from '../units.mjs';
import { moveTo } from '../animate.mjs';
import { showPreview } from '../scene/arm.mjs';
import { kindOf } from './joints.mjs';
import { shortest } from '../turns.mjs';

/** Rows are kept and rewritten: a dragged gizmo changes them many times a second. */
export function solutionTable() {
  const head = h('thead'),
    body = h('tbody');
  const hint = h('p', {
    class: 'hint below',
    text: 'Grey rows lie outside the limits; the joints in red exceed them.',
  });
  const el = h(
    'div',
    { class: 'scroll' },
    h('table', { class: 'plain solutions', 'data-testid': 'solutions', 'aria-label': 'Solutions' }, head, body),
    hint,
  );
  let rows = [],
    made = '';
  const make = () => {
    const key = `${state.table.joints.map((j) => j.type).join('')}${units.angle}${units.length}`;
    if (key === made) return;
    made = key;
    rows = [];
    el.classList.toggle('many', state.table.joints.length > 6);
    replace(body);
    replace(
      head,
      h(
        'tr',
        {},
        h('td'),
        h('th', { class: 'left', text: 'posture' }),
        state.table.joints.map((j, i) =>
          h(
            'th',
            {},
            h('i', { text: 'q' }),
            h('sub', { text: String(i + 1) }),
            h('span', { class: 'unit', text: ` ${units.symbol(kindOf(j))}` }),
          ),
        ),
        h('th', { text: 'off, mm', title: 'By how much forward kinematics misses the pose' }),
      ),
    );
  };
  const row = (k) => {
    const cells = state.table.joints.map(() => h('td')),
      label = h('span'),
      beyond = h('span', { class: 'offscreen' }),
      residual = h('td', { class: 'unit' });
    const tr = h(
      'tr',
      { tabindex: '0', 'data-testid': `solution-${k + 1}` },
      h('th', { scope: 'row', text: String(k + 1) }),
      h('td', { class: 'left' }, label, beyond),
      cells,
      residual,
    );
    const q = () => state.solutions?.rows[k]?.q;
    const over = () => q() && showPreview(q()),
      out = () => showPreview(null),
      go = () => {
        if (q()) {
          showPreview(null);
          moveTo(shortest(q()), 0.8, `move to solution ${k + 1}`);
        }
      };
    tr.addEventListener('pointerenter', over);
    tr.addEventListener('pointerleave', out);
    tr.addEventListener('focus', over);
    tr.addEventListener('blur', out);
    tr.addEventListener('click', go);
    tr.addEventListener('keydown', (e) => {
      if (e.key === 'Enter' || e.key === ' ') {
        e.preventDefault();
        go();
      }
    });
    return { tr, cells, label, beyond, residual };
  };
  return {
    el,
    show(s) {
      make();
      const list = s?.rows ?? [];
      while (rows.length < list.length) {
        const r = row(rows.length);
        rows.push(r);
        body.append(r.tr);
      }
      el.hidden = list.length === 0;
      hint.hidden = list.every((r) => r.inside);
      rows.forEach((r, k) => {
        const data = list[k];
        r.tr.hidden = !data;
        if (!data) return;
        r.tr.classList.toggle('beyond', !data.inside);
        // an answer on the way brings no words: the branches keep their order, so the ones that stand there stay
        if (data.label !== null) setText(r.label, `${data.label}${data.self_motion >= 0 ? ' (of a self-motion)' : ''}`);
        setText(r.beyond, data.inside ? '' : ', outside the limits');
        setText(r.residual, data.residual ? tiny(data.residual[0] * 1000) : '');
        r.residual.title = data.residual
          ? `${tiny(data.residual[0])} m, ${tiny(data.residual[1])} rad by forward kinematics`
          : '';
        data.q.forEach((v, i) => {
          const j = state.table.joints[i],
            out = (j.lower !== null && v < j.lower - 1e-9) || (j.upper !== null && v > j.upper + 1e-9);
          setText(r.cells[i], show(v, kindOf(j)));
          r.cells[i].classList.toggle('out', out);
        });
      });
      this.mark();
    },
    mark() {
      const list = state.solutions?.rows ?? [];
      rows.forEach((r, k) =>
        r.tr.classList.toggle(
          'here',
          Boolean(list[k]) &&
            list[k].q.length === state.q.length &&
            list[k].q.every((v, i) => Math.abs(Math.sin((v - state.q[i]) / 2)) < 1e-5),
        ),
      );
    },
  };
}
