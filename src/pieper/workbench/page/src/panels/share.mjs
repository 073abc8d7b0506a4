// Share: the whole state in a link and in a file; the arm as a robot file; the report of this arm.
import { button, copy, download, h, say, setText, unreadable } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { askArm } from '../library.mjs';
import { link, snapshot, restore } from '../sharing.mjs';
import { saveRobot } from './robot_files.mjs';
import { newestOnly } from '../link.mjs';
import { armSection } from './long_question.mjs';
import { options } from '../solving.mjs';
import { programMessage } from '../program.mjs';

/** What tells that the screen says something else now. */
const SHOWN = [
  'panel',
  'table',
  'q',
  'target',
  'path',
  'path-loaded',
  'program',
  'sequence',
  'sequence-loaded',
  'world',
  'task',
  'routing',
  'units',
  'notation',
  'history',
];

export const share = (showPanel) => ({
  id: 'share',
  title: 'Share',
  build(root, panel) {
    const address = h('input', {
      type: 'text',
      readonly: true,
      class: 'address',
      'aria-label': 'Link to this state',
      'data-testid': 'link',
      on: { focus: (e) => e.target.select() },
    });
    const file = h('input', {
      type: 'file',
      accept: '.json,application/json',
      class: 'offscreen',
      tabindex: '-1',
      'aria-label': 'State file',
      'data-testid': 'state-file',
      on: { change: () => open(file) },
    });
    const note = h('p', { class: 'hint', role: 'status', 'data-testid': 'report-note' });
    const report = button('Write the report', { class: 'primary', 'data-testid': 'report' }, write);
    const code = h('textarea', {
      rows: '9',
      readonly: true,
      class: 'code',
      spellcheck: 'false',
      'aria-label': 'The screen as a Python script',
      'data-testid': 'python',
    });
    const takeScript = [
      button('Copy the script', { 'data-testid': 'copy-python' }, () => copy(code.value)),
      button('Save the script', { 'data-testid': 'save-python' }, () =>
        download('workbench.py', code.value, 'text/x-python'),
      ),
    ];
    root.append(
      h('p', {
        class: 'hint',
        text: 'Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see.',
      }),
      h(
        'div',
        { class: 'line share-link' },
        address,
        button('Copy the link', { 'data-testid': 'copy-link' }, async () => copy(await link())),
      ),
      h('h3', { text: 'As a file' }),
      h(
        'div',
        { class: 'line' },
        button('Save the state', { 'data-testid': 'save-state' }, () =>
          download(
            `${state.table.name || 'arm'}.workbench.json`,
            JSON.stringify(snapshot(), null, 1),
            'application/json',
          ),
        ),
        button('Open a state…', {}, () => file.click()),
        file,
        button('Save the robot file', { 'data-testid': 'save-robot' }, saveRobot),
      ),
      h('h3', { text: 'As Python' }),
      h('p', { class: 'hint', text: 'A script that makes and computes what is on the screen, in metres and radians.' }),
      code,
      h('div', { class: 'line' }, ...takeScript),
      h('h3', { text: 'Report' }),
      h('p', {
        class: 'hint',
        text: 'One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach.',
      }),
      h('div', { class: 'line' }, report),
      note,
    );
    let asked = 0;
    const show = async () => {
      asked += 1;
      // what stands there is of an earlier screen
      code.value = '';
      code.placeholder = 'Being written …';
      for (const b of takeScript) b.disabled = true;
      if (panel.hidden || !state.table.joints.length) return;
      script();
      address.value = await link();
    };
    const script = newestOnly(async () => {
      const mine = asked;
      try {
        const { q, target, hasTarget, path, program, world } = state;
        const { task, redundancy } = options;
        const body = { q, target: hasTarget ? target : null, path, task, redundancy, world, program: programMessage() };
        const { text } = await askArm('python', program.length ? body : { ...body, program: null });
        if (mine !== asked) return;
        code.value = text;
        for (const b of takeScript) b.disabled = false;
      } catch (error) {
        if (mine === asked) code.placeholder = error.message;
      }
    });
    // an action is told before it is done
    on(SHOWN, () => queueMicrotask(show));
    on('online', (yes) => yes && show());

    async function write() {
      const bad = unreadable(armSection());
      if (bad) {
        setText(note, `${bad} Nothing was written.`);
        return;
      }
      report.disabled = true;
      try {
        const said = (m) => setText(note, m.note);
        const { html, name } = await askArm('report', { q: state.q }, said, { whichever: true });
        download(name, html, 'text/html');
        setText(note, `Written: ${name}, ${Math.round(html.length / 1024)} kB.`);
      } catch (error) {
        setText(note, error.message);
      } finally {
        report.disabled = false;
      }
    }
    async function open(input) {
      const f = input.files[0];
      input.value = '';
      if (!f) return;
      try {
        if (f.size > 500_000) throw new Error('A state file has at most 500 kB.');
        restore(JSON.parse(await f.text()), showPanel(), 'open a state');
        say('Opened');
      } catch (error) {
        say(error instanceof SyntaxError ? `${f.name} is not a state file.` : error.message, 'wrong');
      }
    }
  },
});
