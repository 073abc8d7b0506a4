// Sequence: postures with times, all joints together, at rest in each; its curves and its animation.
import { button, h, replace } from '../dom.mjs';
import { state, on, tell } from '../store.mjs';
import { units } from '../units.mjs';
import { numberField, remake } from '../numberfield.mjs';
import { takePastes } from '../pasting.mjs';
import { armNumber, askArm } from '../library.mjs';
import { moveTo } from '../animate.mjs';
import { motionOf } from '../curves.mjs';
import { kindOf } from './joints.mjs';
import { armSection, longQuestion, verdictLine } from './long_question.mjs';
import { rowTools } from './row_tools.mjs';
import { asOne } from '../history.mjs';
import * as dock from '../dock.mjs';

const MOST = 40;

export const sequence = {
  id: 'sequence',
  title: 'Sequence',
  wide: true,
  build(root) {
    const S = {
      get postures() {
        return state.sequence.postures;
      },
      set postures(v) {
        state.sequence.postures = v;
      },
      get rate() {
        return state.sequence.rate;
      },
    };
    let shown = null; // the motion that the dock has of it
    const head = h('thead'),
      body = h('tbody');
    const verdict = verdictLine('sequence-verdict');
    const run = longQuestion({
      text: 'Run the sequence',
      working: 'Planning …',
      testid: 'run-sequence',
      verdict,
      roots: () => [root, armSection()],
      about: () => [armNumber(), JSON.stringify(S.postures)],
      open: () => S.postures.length > 1,
      ask: () => askArm('motion', asked()),
      show: report,
      forget: () => dock.drop(shown),
    });
    const legSeconds = button(
      'Same times for all legs',
      { class: 'quiet', title: 'Copy the first leg’s time and rest to the others' },
      () => {
        const first = S.postures[1];
        if (first) {
          tell('did', { label: 'use the same times for all legs' });
          for (const p of S.postures.slice(2)) {
            p.seconds = first.seconds;
            p.hold = first.hold;
          }
          rebuild();
        }
      },
    );
    root.append(
      h('p', {
        class: 'hint',
        text: 'Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests.',
      }),
      h(
        'div',
        { class: 'scroll' },
        h(
          'table',
          { class: 'dh sequence', 'data-testid': 'sequence', 'aria-label': 'Postures of the sequence' },
          head,
          body,
        ),
      ),
      h(
        'div',
        { class: 'line' },
        button('+ Present posture', { class: 'add', 'data-testid': 'add-posture' }, () => add(state.q.slice())),
        button('+ All named postures', {}, () =>
          asOne('add all named postures', () =>
            Object.entries(state.table.postures ?? {}).forEach(([name, q]) => add(q.slice(), name)),
          ),
        ),
        legSeconds,
      ),
      h('div', { class: 'line' }, run),
      verdict,
    );

    function add(q, name) {
      if (S.postures.length >= MOST) return;
      tell('did', { label: 'add a posture to the sequence' });
      S.postures.push({ name: name ?? `P${S.postures.length}`, q, seconds: 5, hold: 0 });
      rebuild();
      tell('sequence');
    }
    function move(from, to) {
      tell('did', { label: `move ${S.postures[from].name} ${to < from ? 'up' : 'down'}` });
      S.postures.splice(to, 0, ...S.postures.splice(from, 1));
      rebuild();
      tell('sequence');
    }
    function remove(k) {
      tell('did', { label: `remove ${S.postures[k].name}` });
      S.postures.splice(k, 1);
      rebuild();
      tell('sequence');
    }
    const ids = new WeakMap();
    let made = 0;
    /** A posture keeps its name for the fields when it moves up or down. */
    const idOf = (p) => ids.get(p) ?? ids.set(p, (made += 1)).get(p);
    const rebuild = () => remake(body, rows);
    function rows() {
      const joints = state.table.joints;
      S.postures = S.postures.filter((p) => p.q.length === joints.length);
      run.show();
      replace(
        head,
        h(
          'tr',
          {},
          h('td'),
          joints.map((j, i) =>
            h(
              'th',
              {},
              h('i', { text: 'q' }),
              h('sub', { text: String(i + 1) }),
              h('span', { class: 'unit', text: ` ${units.symbol(kindOf(j))}` }),
            ),
          ),
          h('th', { text: 'leg, s' }),
          h('th', { text: 'rest, s' }),
          h('td'),
        ),
      );
      replace(
        body,
        S.postures.map((p, k) => {
          const cells = joints.map((j, i) => {
            const f = numberField({
              label: `${p.name}, q${i + 1}`,
              kind: kindOf(j),
              testid: `seq-${k}-q${i + 1}`,
              key: `${idOf(p)}-q${i + 1}`,
              input: (v) => {
                tell('did', { label: `edit ${p.name} of the sequence`, key: `seq-${k}-${i}` });
                p.q[i] = v;
                tell('sequence');
              },
            });
            // shown to what fits the cell; what was captured stays behind it, exact, until the cell is typed in
            f.put(p.q[i], String(Number((p.q[i] * units.factor(kindOf(j))).toFixed(units.digits(kindOf(j)))) + 0));
            return h('td', {}, f);
          });
          const time = (key, label, check) => {
            if (k === 0) return h('td');
            const f = numberField({
              label: `${label} ${p.name}`,
              testid: `seq-${k}-${key}`,
              key: `${idOf(p)}-${key}`,
              check,
              input: (v) => {
                tell('did', { label: `edit ${p.name} of the sequence`, key: `seq-${k}-${key}` });
                p[key] = v;
                tell('sequence');
              },
            });
            f.put(p[key]);
            return h('td', {}, f);
          };
          return h(
            'tr',
            { 'data-testid': `seq-row-${k}` },
            h(
              'th',
              { scope: 'row' },
              button(p.name, { class: 'quiet', title: 'Go there' }, () => moveTo(p.q.slice())),
            ),
            cells,
            time('seconds', 'Seconds to', (v) => (v > 0 ? null : 'more than 0')),
            time('hold', 'Rest after', (v) => (v >= 0 ? null : '0 or more')),
            h('td', { class: 'tools' }, rowTools({ k, n: S.postures.length, name: p.name, move, remove })),
          );
        }),
      );
      if (!S.postures.length)
        body.append(
          h(
            'tr',
            {},
            h('td', {
              class: 'hint',
              colspan: String(joints.length + 4),
              text: 'No postures yet: add the present one, move the arm, add the next.',
            }),
          ),
        );
    }
    takePastes(body, 'paste into the sequence');
    const asked = () => ({
      postures: S.postures.map((p) => p.q),
      seconds: S.postures.slice(1).map((p) => p.seconds),
      holds: S.postures.slice(1).map((p) => p.hold),
      rate: S.rate,
    });
    function report(m) {
      const P = S.postures;
      const events = P.map((p, i) => ({
        x: m.arrivals[i],
        s: 0,
        text: `${p.name} at ${m.arrivals[i].toFixed(2)} s`,
        short: p.name,
        stop: false,
      }));
      verdict.say(`${P.length} postures in ${m.t[m.t.length - 1].toFixed(2)} s. ${limitWords(m.q)}`, 'good');
      shown = motionOf({
        table: state.table,
        q: m.q,
        xs: m.t,
        xName: 'time',
        seconds: m.t,
        dq: m.dq,
        events,
        title: `${state.table.name}: ${P.map((p) => p.name).join(' – ')}`,
      });
      dock.show(shown);
    }
    on(['table', 'units', 'sequence-loaded'], rebuild);
    rebuild();
  },
};

function limitWords(q) {
  const out = state.table.joints.filter((j, i) =>
    q.some((row) => (j.lower !== null && row[i] < j.lower - 1e-9) || (j.upper !== null && row[i] > j.upper + 1e-9)),
  );
  return out.length ? `Outside the limits on the way: ${out.map((j) => j.name).join(', ')}.` : 'Inside all limits.';
}
