// The DH table, editable in place: numbers or expressions, joints added, removed, reordered; a wrong entry leaves the last good arm.
import { button, choice, h, replace, setText } from '../dom.mjs';
import { state, on, setTable } from '../store.mjs';
import { units } from '../units.mjs';
import { numberField, remake } from '../numberfield.mjs';
import { takePastes } from '../pasting.mjs';
import { convert } from '../convert.mjs';
import { blank } from '../kinematics.mjs';
import { countWords } from '../library.mjs';
import { add, change, limitReason, restructure, swap } from './dh_edits.mjs';
import { robotOpeners, saveRobot } from './robot_files.mjs';
import { dhSteps } from './dh_steps.mjs';
import { rowTools } from './row_tools.mjs';
import { poseEditor } from './pose_editor.mjs';

const columns = {
  geometry: [
    ['a', 'a', 'length'],
    ['alpha', 'α', 'angle'],
    ['d', 'd', 'length'],
    ['theta', 'θ', 'angle'],
  ],
  joint: [
    ['lower', 'lower limit', null],
    ['upper', 'upper limit', null],
    ['offset', 'zero', null],
  ],
};
/** A renamed arm keeps its mathematics and is the catalogue's no longer by name. */
const unlisted = ({ catalog, ...table }) => (catalog ? { ...table, derived: catalog } : table);
const motion = (joint) => (joint.type === 'R' ? 'angle' : 'length');
export const dhTable = {
  id: 'table',
  title: 'DH table',
  wide: true,
  build(root) {
    let part = 'geometry',
      cells = [];
    const head = h('thead'),
      body = h('tbody');
    const table = h('table', { class: 'dh', 'data-testid': 'dh-table', 'aria-label': 'DH table' }, head, body);
    const wrong = h('p', { class: 'reason', role: 'alert', 'data-testid': 'dh-wrong' });
    const kind = h('p', { class: 'verdict', 'data-testid': 'arm-kind' });
    const conventions = choice(
      'Convention',
      [
        ['standard', 'Standard'],
        ['modified', 'Modified (Craig)'],
      ],
      state.table.convention,
      (to) => {
        if (to !== state.table.convention)
          setTable(convert(state.table, to), { what: 'rows', label: `make the table ${to}` });
      },
      'convention',
    );
    const rule = h('p', { class: 'hint order' });
    const name = h('input', {
      type: 'text',
      'aria-label': 'Name of the arm',
      'data-testid': 'arm-name',
      maxlength: '60',
      on: {
        change: () =>
          setTable({ ...unlisted(state.table), name: name.value || 'my-arm' }, { what: 'name', label: 'name the arm' }),
      },
    });
    const base = poseEditor(
      'Base',
      'base',
      () => state.table.base,
      (T) => setTable({ ...state.table, base: T }, { what: 'cell', label: 'edit the base', key: 'base', open: true }),
    );
    const tool = poseEditor(
      'Tool',
      'tool',
      () => state.table.tool,
      (T) => setTable({ ...state.table, tool: T }, { what: 'cell', label: 'edit the tool', key: 'tool', open: true }),
    );
    root.append(
      h(
        'div',
        { class: 'line spread' },
        h('span', { class: 'line' }, name),
        h(
          'span',
          { class: 'line' },
          button('Blank', { title: 'An empty table' }, () =>
            setTable(blank(state.table.convention), { q: [], what: 'new', label: 'begin a blank table' }),
          ),
          ...robotOpeners(),
          button('Save', { title: 'As a robot file' }, saveRobot),
        ),
      ),
      h(
        'div',
        { class: 'line spread' },
        conventions,
        choice(
          'Columns',
          [
            ['geometry', 'Geometry'],
            ['joint', 'Limits and zeros'],
          ],
          part,
          (v) => {
            part = v;
            rebuild();
          },
          'dh-part',
        ),
      ),
      rule,
      table,
      h(
        'div',
        { class: 'line' },
        button('+ Add joint', { class: 'add', 'data-testid': 'add-joint' }, () => add()),
        h('span', {
          class: 'hint',
          text: 'Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted.',
        }),
      ),
      wrong,
      kind,
      dhSteps(),
      h(
        'details',
        { class: 'fold', 'data-testid': 'base-tool' },
        h('summary', { text: 'Base and tool' }),
        base.el,
        tool.el,
      ),
    );
    takePastes(body, 'paste a table', (n) => {
      // a table with more rows than there are joints brings its own
      while (state.table.joints.length < n && add());
    });
    root.addEventListener('verdict', (e) => {
      sayWrong(e.detail ?? firstWrong(root));
    });
    const sayWrong = (bad) => setText(wrong, bad ? `${bad.label}: ${bad.reason}. The arm stays as it was.` : '');

    const cellFor = (joint, i, [key, label, fixedKind]) => {
      const variable = (joint.type === 'R' && key === 'theta') || (joint.type === 'P' && key === 'd');
      const isLimit = key === 'lower' || key === 'upper';
      const f = numberField({
        label: `Joint ${i + 1}, ${label}`,
        kind: fixedKind ?? motion(joint),
        testid: `dh-${i + 1}-${key}`,
        key: `${joint.name}/${key}`,
        empty: isLimit ? null : undefined,
        check: (v) =>
          isLimit ? limitReason(i, key, v) : v !== null && Math.abs(v) > 1e6 ? 'larger than a million' : null,
        input: (v, how) => change(i, key, v, how, false),
        commit: (v, how) => change(i, key, v, how, true),
      });
      if (isLimit) f.placeholder = 'none';
      cells.push({ f, i, key });
      return h(
        'td',
        { class: variable ? 'variable' : '' },
        variable ? h('span', { class: 'plus' }, h('i', { text: 'q' }), h('sub', { text: String(i + 1) }), ' +') : null,
        f,
      );
    };
    const typeButton = (joint, i) =>
      button(
        joint.type,
        {
          class: `type type-${joint.type}`,
          'data-testid': `dh-${i + 1}-type`,
          'aria-label': `Joint ${i + 1} is ${joint.type === 'R' ? 'revolute' : 'prismatic'}; press to change`,
          title:
            joint.type === 'R' ? 'Revolute: turns. Press for prismatic.' : 'Prismatic: slides. Press for revolute.',
        },
        () =>
          restructure(
            state.table.joints.map((j, k) =>
              k === i
                ? {
                    ...j,
                    type: j.type === 'R' ? 'P' : 'R',
                    lower: null,
                    upper: null,
                    offset: 0,
                    text: { ...j.text, lower: undefined, upper: undefined, offset: undefined },
                  }
                : j,
            ),
            (list) => list.map((v, k) => (k === i && typeof v === 'number' ? 0 : v)),
            `make joint ${i + 1} ${joint.type === 'R' ? 'prismatic' : 'revolute'}`,
          ),
      );
    const tools = (i, n) =>
      h(
        'td',
        { class: 'tools' },
        rowTools({
          k: i,
          n,
          name: `joint ${i + 1}`,
          move: swap,
          remove: () =>
            restructure(
              state.table.joints.filter((_, k) => k !== i),
              (list) => list.filter((_, k) => k !== i),
              `remove joint ${i + 1}`,
            ),
        }),
      );
    // what could not be read was said of this arm, not of another one
    const rebuild = (what) => (what === 'undo' || what === 'new' ? rows() : remake(body, rows));
    const rows = () => {
      cells = [];
      const { joints } = state.table,
        shift = state.table.convention === 'modified';
      const heads =
        part === 'geometry'
          ? columns.geometry.map(([key, label, kind]) =>
              h(
                'th',
                { scope: 'col' },
                h('i', { text: label }),
                h('sub', { text: shift && (key === 'a' || key === 'alpha') ? 'i−1' : 'i' }),
                h('span', { class: 'unit', text: ` ${units.symbol(kind)}` }),
              ),
            )
          : ['name', 'lower limit', 'upper limit', 'zero', 'sense'].map((t) => h('th', { scope: 'col', text: t }));
      replace(
        head,
        h(
          'tr',
          {},
          h('th', { scope: 'col', text: 'i' }),
          h('th', { scope: 'col' }, h('span', { class: 'offscreen', text: 'type' })),
          heads,
          h('td'),
        ),
      );
      replace(
        body,
        joints.map((joint, i) => {
          const own =
            part === 'geometry'
              ? columns.geometry.map((c) => cellFor(joint, i, c))
              : [
                  h(
                    'td',
                    {},
                    h('input', {
                      type: 'text',
                      class: 'name',
                      value: joint.name,
                      maxlength: '40',
                      'aria-label': `Joint ${i + 1}, name`,
                      on: { change: (e) => change(i, 'name', e.target.value || `joint_${i + 1}`, {}, true) },
                    }),
                  ),
                  ...columns.joint.map((c) => cellFor(joint, i, c)),
                  h(
                    'td',
                    {},
                    button(
                      joint.sign > 0 ? '+' : '−',
                      {
                        class: 'type',
                        'aria-label': `Joint ${i + 1}, sense of the maker: ${joint.sign > 0 ? 'as the table' : 'against the table'}`,
                      },
                      () =>
                        restructure(
                          state.table.joints.map((j, k) => (k === i ? { ...j, sign: -j.sign } : j)),
                          (list) => list,
                          `turn the sense of joint ${i + 1}`,
                        ),
                    ),
                  ),
                ];
          return h(
            'tr',
            { 'data-testid': `dh-row-${i + 1}` },
            h('th', { scope: 'row', text: String(i + 1) }),
            h('td', {}, typeButton(joint, i)),
            own,
            tools(i, joints.length),
          );
        }),
      );
      if (!joints.length) body.append(h('tr', {}, h('td', { colspan: '7', class: 'hint', text: 'No joints yet.' })));
      refresh();
    };
    const refresh = () => {
      for (const { f, i, key } of cells) {
        const j = state.table.joints[i];
        f.put(j[key], j.text?.[key] ?? null);
      }
      conventions.mark(state.table.convention);
      setText(
        rule,
        state.table.convention === 'standard'
          ? 'Aᵢ = Rz(θ) Tz(d) Tx(a) Rx(α)'
          : 'Aᵢ = Rx(α) Tx(a) Rz(θ) Tz(d), each row with the a and α before its joint',
      );
      if (document.activeElement !== name) name.value = state.table.name;
      base.show();
      tool.show();
    };
    on('table', (what) => {
      if (what === 'cell' || what === 'name' || what === 'postures') refresh();
      else rebuild(what);
      sayWrong(firstWrong(root));
    });
    on('units', rebuild);
    on('notation', () => {
      base.show();
      tool.show();
    });
    on('plan', () => {
      if (!state.plan) {
        kind.dataset.tone = 'note';
        replace(kind, h('span', { text: 'Looking how it is solved …' }));
        return;
      }
      kind.dataset.tone = state.plan.solvable ? 'good' : 'wrong';
      replace(
        kind,
        h('strong', { text: countWords(state.plan) || (state.plan.refused ? 'Refused' : 'Not solved') }),
        ' ',
        h('span', { text: state.plan.explain ?? '' }),
      );
    });
    rebuild();
  },
};

function firstWrong(root) {
  const el = root.querySelector('.number.wrong');
  return el ? { label: el.getAttribute('aria-label'), reason: el.title } : null;
}
