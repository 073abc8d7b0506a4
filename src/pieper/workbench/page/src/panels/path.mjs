// Path: a straight line between two poses, followed from a start posture; where it stops, and which branches would have passed.
import { button, h, replace, setText } from '../dom.mjs';
import { state, on, tell } from '../store.mjs';
import { showUnit } from '../units.mjs';
import { numberField } from '../numberfield.mjs';
import { position, sub, norm, angleBetween } from '../matrix.mjs';
import { armNumber, askArm } from '../library.mjs';
import { moveTo } from '../animate.mjs';
import { motionOf } from '../curves.mjs';
import * as dock from '../dock.mjs';
import { showPath } from '../scene/arm.mjs';
import { between } from '../rotation.mjs';
import { armSection, longQuestion, verdictLine } from './long_question.mjs';
import { lineEnds } from './line_ends.mjs';

const tool = () => state.frames[state.frames.length - 1].slice();

export const path = {
  id: 'path',
  title: 'Path',
  wide: true,
  build(root, panel) {
    const P = state.path;
    let shown = null; // the motion that the dock has of it
    const ends = lineEnds('path', () => preview());
    const length = h('span', { class: 'hint' });
    const count = numberField({
      label: 'Number of points N',
      testid: 'path-n',
      check: (v) => (Number.isInteger(v) && v >= 2 && v <= 2000 ? null : 'a whole number from 2 to 2000'),
      input: (v) => {
        tell('did', { label: 'set the points of the path', key: 'path-n' });
        P.n = v;
      },
    });
    const seconds = numberField({
      label: 'Seconds for the whole line',
      testid: 'path-seconds',
      check: (v) => (v > 0 && v <= 3600 ? null : 'more than 0, at most 3600'),
      input: (v) => {
        tell('did', { label: 'set the seconds of the path', key: 'path-seconds' });
        P.seconds = v;
        dock.drop(shown);
      },
    });
    const same = button('Keep the orientation of “From”', { class: 'quiet' }, () => {
      if (P.from && P.to) {
        const p = position(P.to);
        tell('did', { label: 'keep the orientation of the path' });
        P.to = P.from.slice();
        [3, 7, 11].forEach((k, i) => {
          P.to[k] = p[i];
        });
        ends.show();
        tell('path', 'path');
        preview();
      }
    });
    const verdict = verdictLine('path-verdict');
    const plan = longQuestion({
      text: 'Plan the line',
      working: 'Planning …',
      testid: 'plan',
      verdict,
      roots: () => [root, armSection()],
      about: () => [armNumber(), P.from, P.to, P.n],
      ask: (start) => askArm('follow', lineFrom(start ?? state.q)),
      show: report,
      forget: () => {
        dock.drop(shown);
        replace(branches);
      },
    });
    const branches = h('div', { class: 'branches', 'data-testid': 'branches' });
    root.append(
      ends.el,
      h('div', { class: 'line' }, same, length),
      h(
        'div',
        { class: 'line' },
        h('label', { class: 'field' }, h('span', { class: 'field-name', text: 'Points N' }), count),
        h('label', { class: 'field' }, h('span', { class: 'field-name', text: 'Seconds' }), seconds),
        plan,
        h('span', { class: 'hint', text: 'starts from the solution nearest to the present posture' }),
      ),
      verdict,
      branches,
    );

    const preview = () => {
      if (!P.from || !P.to) {
        setText(length, '');
        return;
      }
      const turn = angleBetween(P.from, P.to);
      setText(
        length,
        `${showUnit(norm(sub(position(P.to), position(P.from))), 'length')} long${turn > 1e-6 ? `, turning ${showUnit(turn, 'angle')}` : ', orientation kept'}`,
      );
      showPath(Array.from({ length: 33 }, (_, i) => position(between(P.from, P.to, i / 32))));
    };
    let line = null; // what was asked last
    const lineFrom = (start) => (line = { T0: P.from, T1: P.to, n: P.n, start });
    function report(track) {
      state.track = track;
      verdict.say(track.explain, track.complete ? 'good' : 'wrong');
      if (!track.complete) cure(track);
      replace(
        branches,
        track.branches.length ? h('h3', { text: 'Branches that start at the first pose' }) : null,
        track.branches.map((b, k) =>
          h(
            'button',
            {
              type: 'button',
              class: `branch ${k === track.chosen ? 'chosen' : ''}`,
              'aria-pressed': String(k === track.chosen),
              'data-testid': `branch-${k + 1}`,
              disabled: !b.q,
              title: b.cause || 'reaches the end',
              on: {
                click: async () => {
                  await moveTo(b.q, 0.4, `take branch ${k + 1}`);
                  plan.ask(b.q);
                },
              },
            },
            h('span', { class: 'branch-name', text: `${k + 1}  ${b.label}` }),
            bar(b.s),
            h('span', {
              class: 'branch-end',
              text: b.complete ? 'to the end' : !b.q ? 'starts outside the limits' : `${b.points} of ${P.n}`,
            }),
          ),
        ),
      );
      showPath(track.path.map(position));
      if (!track.q.length) {
        dock.show(null);
        return;
      }
      const n = track.path.length,
        xs = track.q.map((_, i) => i + 1),
        t = track.q.map((_, i) => (n > 1 ? (P.seconds * i) / (n - 1) : 0));
      shown = motionOf({
        table: state.table,
        q: track.q,
        xs,
        xName: 'point',
        xEnd: n,
        seconds: t,
        title: `${state.table.name}: straight line, ${track.q.length} of ${n} points`,
        events: track.events.map((e) => ({ ...e, x: 1 + e.s * (n - 1), short: e.cause })),
      });
      dock.show(shown);
    }
    function cure(track) {
      verdict.say(`${track.explain}\nLooking for what would let it pass …`, 'wrong');
      askArm('cures', line)
        .then((more) => more.explain ?? track.explain)
        .catch(() => track.explain)
        .then((text) => state.track === track && !verdict.hidden && verdict.say(text, 'wrong'));
    }
    function bar(s) {
      const fill = h('span', { class: 'bar-fill' });
      fill.style.setProperty('width', `${100 * s}%`);
      return h('span', { class: 'bar' }, fill);
    }
    const show = () => {
      ends.show();
      count.put(P.n);
      seconds.put(P.seconds);
      preview();
    };
    on('panel', (id) => {
      if (id === 'path') {
        P.from ??= tool();
        P.to ??= tool();
        show();
      }
    });
    on('path-loaded', show);
    on('units', preview);
    on('table', (what) => {
      if (['postures', 'name', 'gripper'].includes(what)) return;
      showPath([]);
      // the ends are places in the world: another arm may be asked for the same line
      if (!panel.hidden) show();
    });
  },
};
