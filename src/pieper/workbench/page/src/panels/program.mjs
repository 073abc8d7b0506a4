// Program: moves, waits, gripper and outputs in order; taught or typed, run with its true times, written for a controller.
import { button, download, h, replace, say, select, setText, unreadable } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { showUnit, show } from '../units.mjs';
import { armNumber, askArm } from '../library.mjs';
import { remake } from '../numberfield.mjs';
import { moveTo } from '../animate.mjs';
import { motionOf } from '../curves.mjs';
import { setProgram, setStart, start, programMessage, taughtAt, renumbered, misplaced } from '../program.mjs';
import { stepEditor } from './program_step.mjs';
import { limitFields } from './program_limits.mjs';
import { kindOf } from './joints.mjs';
import { armSection, longQuestion, verdictLine, worldSection } from './long_question.mjs';
import { rowTools } from './row_tools.mjs';
import { words, summary } from './program_words.mjs';
import * as dock from '../dock.mjs';

const MOST = 200;
const DIALECTS = [
  ['rapid', 'ABB RAPID'],
  ['urscript', 'URScript'],
  ['krl', 'KUKA KRL'],
  ['fanuc-ls', 'Fanuc LS'],
  ['inform', 'Yaskawa INFORM'],
  ['pacscript', 'Denso PacScript'],
  ['ros', 'ROS trajectory'],
  ['csv', 'CSV of the motion'],
];
const here = () => taughtAt(place());
let place = () => state.program.length;

export const program = {
  id: 'program',
  title: 'Program',
  wide: true,
  build(root) {
    let chosen = -1,
      failed = null,
      shown = null, // the motion that the dock has of it
      dragged = -1;
    const list = h('ol', { class: 'steps', 'data-testid': 'program', 'aria-label': 'Steps of the program' });
    const verdict = verdictLine('program-verdict'),
      written = verdictLine('save-verdict');
    const binds = h(
      'details',
      { class: 'fold', hidden: true },
      h('summary', { text: 'What binds, and when' }),
      h('p', { class: 'hint prose' }),
    );
    const addButton = (kind, text, title, make) =>
      button(text, { title, 'data-testid': `step-add-${kind}` }, () => add(make()));
    const run = longQuestion({
      text: 'Run the program',
      working: 'Planning …',
      testid: 'run-program',
      verdict,
      roots: () => [root, armSection(), worldSection()],
      about: () => [armNumber(), state.program, state.limits, state.start, state.world],
      open: () => state.program.length > 0,
      ask: () => askArm('program', { ...programMessage(), world: state.world }),
      show: report,
      forget: () => {
        dock.drop(shown);
        binds.hidden = true;
      },
    });
    const startLine = h('span', { class: 'hint', 'data-testid': 'program-start' });
    let dialect = 'rapid';
    root.append(
      h(
        'div',
        { class: 'line' },
        addButton('joint', '+ Joints', 'All joints to the present posture', () => ({
          kind: 'joint',
          q: state.q.slice(),
          T: here(),
          blend: 0,
        })),
        addButton('line', '+ Line', 'The tool on a straight line to the present pose', () => ({
          kind: 'line',
          T: here(),
          blend: 0,
        })),
        addButton('circle', '+ Circle', 'Over a point on the way to the present pose; both can be typed', () => ({
          kind: 'circle',
          via: lastPose(),
          T: here(),
          blend: 0,
        })),
        addButton(
          'spline',
          '+ Spline',
          'A smooth curve through taught poses, the first of them the present one',
          () => ({
            kind: 'spline',
            through: [here()],
            T: here(),
            blend: 0,
          }),
        ),
        addButton('gripper', '+ Gripper', 'From 0, open, to 1, closed', () => ({
          kind: 'gripper',
          value: lastGrip() > 0.5 ? 0 : 1,
        })),
        addButton('wait', '+ Wait', 'The arm rests', () => ({ kind: 'wait', seconds: 0.5 })),
        addButton('output', '+ Output', 'A digital output', () => ({ kind: 'output', port: 1, value: true })),
        addButton(
          'frame',
          '+ Frame',
          'The poses that follow are meant in this frame, at first the present pose',
          () => ({
            kind: 'frame',
            T: state.frames.at(-1).slice(),
          }),
        ),
        addButton('call', '+ Again', 'Earlier steps once more, in the frame that holds here', () => ({
          kind: 'call',
          first: 1,
          last: Math.max(place(), 1),
          times: 1,
        })),
      ),
      h(
        'div',
        { class: 'line spread' },
        startLine,
        h(
          'span',
          { class: 'line' },
          button(
            'Start here',
            { class: 'quiet', 'data-testid': 'start-here', title: 'The program begins in the present posture' },
            () => setStart(state.q.slice()),
          ),
          button('Go to the start', { class: 'quiet' }, () => moveTo(start().slice(), 0.8, 'go to the start')),
        ),
      ),
      list,
      limitFields(),
      h(
        'div',
        { class: 'line' },
        run,
        h(
          'span',
          { class: 'line' },
          select(
            'Language of the file',
            DIALECTS,
            dialect,
            (v) => {
              dialect = v;
              written.say('');
            },
            { 'data-testid': 'dialect' },
          ),
          button('Save the program', { 'data-testid': 'save-program' }, save),
        ),
      ),
      written,
      verdict,
      binds,
    );

    place = () => (chosen >= 0 ? chosen + 1 : state.program.length);
    const lastPose = () => state.program.slice(0, place()).findLast((s) => s.T && s.kind !== 'frame')?.T ?? here();
    const lastGrip = () => state.program.findLast((s) => s.kind === 'gripper')?.value ?? 0;
    /** A step whose numbers cannot be read stays open: what stands there is neither lost nor passed over. */
    function held() {
      const bad = unreadable(list);
      if (bad) say(`${bad} Escape puts back what was there.`, 'wrong');
      return Boolean(bad);
    }
    function add(step) {
      if (held()) return;
      if (state.program.length >= MOST) {
        say(`At most ${MOST} steps.`, 'wrong');
        return;
      }
      const at = chosen >= 0 ? chosen + 1 : state.program.length;
      chosen = at;
      const moved = renumbered(
        state.program,
        state.program.map((_, i) => (i < at ? i : i + 1)),
      );
      if (step.kind === 'call' && !at) {
        say('There is no step before it that could be done again.', 'wrong');
        chosen = -1;
        return;
      }
      setProgram([...moved.slice(0, at), step, ...moved.slice(at)], `add a step: ${words[step.kind].toLowerCase()}`);
    }
    function move(from, to) {
      if (to < 0 || to >= state.program.length || from === to || held()) return;
      const order = state.program.map((_, i) => i);
      order.splice(to, 0, ...order.splice(from, 1));
      const steps = renumbered(
        state.program,
        state.program.map((_, i) => order.indexOf(i)),
      );
      chosen = to;
      setProgram(steps, `move step ${from + 1} to ${to + 1}`);
      list.children[to]?.querySelector('.step-name')?.focus();
    }
    function remove(k) {
      if (k !== chosen && held()) return;
      chosen = -1;
      setProgram(
        renumbered(
          state.program,
          state.program.map((_, i) => (i === k ? -1 : i < k ? i : i - 1)),
        ),
        `remove step ${k + 1}`,
      );
    }

    function row(s, k) {
      const open = k === chosen,
        reason = failed?.step === k ? failed.text : misplaced(s, k);
      const name = h(
        'button',
        {
          type: 'button',
          class: 'step-name quiet',
          'aria-expanded': String(open),
          'data-testid': `step-${k + 1}`,
          title: 'Press to edit; Alt and an arrow moves it',
          on: {
            click: () => {
              if (held()) return;
              chosen = open ? -1 : k;
              rebuild();
            },
            keydown: (e) => {
              const way = { ArrowUp: -1, ArrowDown: 1 }[e.key];
              if (way && e.altKey) {
                e.preventDefault();
                move(k, k + way);
              } else if (way) {
                e.preventDefault();
                list.children[k + way]?.querySelector('.step-name')?.focus();
              } else if (e.key === 'Delete') remove(k);
            },
          },
        },
        h('b', { text: words[s.kind] }),
        ` ${summary(s)}`,
        s.blend ? h('span', { class: 'hint', text: `, blend ${showUnit(s.blend, 'length', 0)}` }) : null,
      );
      const el = h(
        'li',
        {
          class: `step${reason ? ' failed' : ''}${open ? ' open' : ''}`,
          draggable: 'true',
          'data-testid': `step-row-${k + 1}`,
        },
        h(
          'div',
          { class: 'step-line' },
          h('span', { class: 'grip', 'aria-hidden': 'true', text: '⠿' }),
          h('span', { class: 'hint', text: String(k + 1) }),
          name,
          rowTools({ k, n: state.program.length, name: `step ${k + 1}`, move, remove }),
        ),
        reason ? h('p', { class: 'reason', text: reason }) : null,
        open ? editor(s, k) : null,
      );
      el.addEventListener('dragstart', (e) => {
        dragged = k;
        e.dataTransfer.effectAllowed = 'move';
        e.dataTransfer.setData('text/plain', String(k));
      });
      el.addEventListener('dragover', (e) => {
        if (dragged < 0) return;
        e.preventDefault();
        el.classList.add('target');
      });
      el.addEventListener('dragleave', () => el.classList.remove('target'));
      el.addEventListener('drop', (e) => {
        e.preventDefault();
        const from = dragged;
        dragged = -1;
        if (from >= 0) move(from, k);
      });
      return el;
    }
    /** While a person types in a step's editor it stays as it is. */
    let quietly = false;
    const editor = stepEditor((f) => {
      quietly = true;
      f();
      quietly = false;
    });
    /** What cannot be read stays, but for a step that is undone: that brings back what was there. */
    const rebuild = (what) => (what === 'undo' ? rows() : remake(list, rows));
    function rows() {
      if (quietly) {
        // the summary of the line follows; its editor is under the hand
        state.program.forEach((s, k) => {
          const name = list.children[k]?.querySelector('.step-name');
          if (name) replace(name, h('b', { text: words[s.kind] }), document.createTextNode(` ${summary(s)}`));
        });
        return;
      }
      if (chosen >= state.program.length) chosen = -1;
      replace(list, state.program.map(row));
      if (!state.program.length)
        list.append(
          h('li', {
            class: 'hint empty',
            text: 'No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards.',
          }),
        );
      run.show();
      const q = start();
      setText(
        startLine,
        state.program.length
          ? `Starts at ${q.map((v, i) => show(v, kindOf(state.table.joints[i]), 1)).join(', ')}`
          : '',
      );
    }
    function report(m) {
      failed = m.failed;
      if (failed) chosen = failed.step;
      verdict.say(
        failed
          ? `S${failed.name.slice(1)} cannot be done: ${failed.text}${m.duration > 0 ? '\nShown is what comes before it.' : ''}`
          : [m.explain, m.clear?.text].filter(Boolean).join('\n'),
        failed || m.clear?.verdict === 'HIT' ? 'wrong' : m.clear?.verdict === 'UNCERTAIN' ? 'note' : 'good',
      );
      binds.hidden = !m.tight.length;
      setText(binds.lastChild, m.tight.map((x) => x.text).join('\n'));
      rebuild();
      // nothing has moved: there is no motion to show
      if (!(m.duration > 0)) {
        dock.show(null);
        return;
      }
      const events = m.events.map(([t, kind, value]) => ({
        x: t,
        s: 0,
        text: `${kind} ${value} at ${t.toFixed(2)} s`,
        short: kind === 'gripper' ? (value > 0.5 ? 'close' : 'open') : kind,
        stop: false,
      }));
      shown = motionOf({
        table: state.table,
        q: m.q,
        xs: m.t,
        xName: 'time',
        seconds: m.t,
        dq: m.dq,
        ddq: m.ddq,
        events,
        title: `${state.table.name}: program, ${m.duration.toFixed(2)} s`,
        happens: m.events,
        tight: m.tight,
        limits: programMessage().limits,
      });
      dock.show(shown);
    }
    async function save() {
      const bad = unreadable(root, armSection());
      if (bad) {
        written.say(`${bad} Nothing was written.`);
        return;
      }
      written.say('');
      try {
        const name = 'program';
        const { text, name: file } = await askArm('program_file', { ...programMessage(), dialect, name });
        download(file, text);
      } catch (error) {
        written.say(error.message);
      }
    }
    on(['program', 'units', 'table'], (what) => {
      written.say('');
      if (what !== 'limits') {
        failed = null;
        rebuild(what);
      }
    });
    rebuild();
  },
};
