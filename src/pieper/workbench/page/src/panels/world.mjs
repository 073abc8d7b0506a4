// World: what stands around the arm; objects that its gripper takes, obstacles, frames, each with its place and size.
import { button, h, replace, say, select, setText } from '../dom.mjs';
import { state, on, tell } from '../store.mjs';
import { numberField, remake } from '../numberfield.mjs';
import { showBodies } from '../scene/clearance.mjs';
import { units, showUnit } from '../units.mjs';
import { position } from '../matrix.mjs';
import { reach } from '../kinematics.mjs';
import { rowTools } from './row_tools.mjs';
import { poseEditor } from './pose_editor.mjs';

const MOST = 60;
const words = { box: 'Box', cylinder: 'Cylinder', frame: 'Frame' };
const sizes = { box: ['x', 'y', 'z'], cylinder: ['radius', 'height'], frame: [] };

function setWorld(world, label, how = {}) {
  tell('did', { label, ...how });
  state.world = world;
  tell('world');
}
const change = (k, part, label) =>
  setWorld(
    state.world.map((t, i) => (i === k ? { ...t, ...part } : t)),
    label,
    { key: `world-${k}-${Object.keys(part)[0]}` },
  );

/** A thing has a name, and no other one has the same: it is spoken of by it. */
function rename(k, field) {
  const said = field.value.trim(),
    now = state.world[k].name;
  const taken = state.world.some((t, i) => i !== k && t.name === said);
  if (said && !taken) {
    if (said !== now) change(k, { name: said }, `name ${said}`);
    return;
  }
  field.value = now;
  say(taken ? `There is a ${said} already; the name stays ${now}.` : `A thing needs a name; it stays ${now}.`, 'wrong');
}

function add(kind, role) {
  if (state.world.length >= MOST) return;
  const at = position(state.frames.at(-1)),
    u = 0.06 * reach(state.table);
  const round = (v) => Math.round(v * 1000) / 1000 || 0.001;
  const T = [
    1,
    0,
    0,
    round(at[0]),
    0,
    1,
    0,
    round(at[1]),
    0,
    0,
    1,
    kind === 'frame' ? round(at[2]) : round(u / 2),
    0,
    0,
    0,
    1,
  ];
  T[7] += 1.5 * u * state.world.length;
  const base = role === 'object' ? 'object' : kind;
  let n = 1;
  while (state.world.some((t) => t.name === `${base} ${n}`)) n += 1;
  const size =
    kind === 'box'
      ? { size: [round(u), round(u), round(u)] }
      : kind === 'cylinder'
        ? { r: round(u / 2), h: round(u) }
        : {};
  setWorld([...state.world, { kind, role, name: `${base} ${n}`, T, ...size }], `add ${base} ${n}`);
}

export const world = {
  id: 'world',
  title: 'World',
  wide: true,
  build(root) {
    const nearest = h('p', { class: 'verdict', role: 'status', 'data-testid': 'clearance', hidden: true });
    const source = h('p', { class: 'hint prose' });
    const watch = h('input', {
      type: 'checkbox',
      'data-testid': 'watch',
      on: {
        change: () => {
          state.watch = watch.checked;
          tell('watch');
        },
      },
    });
    const bodies = h('input', {
      type: 'checkbox',
      'data-testid': 'show-bodies',
      on: {
        change: async () => {
          try {
            const said = await showBodies(bodies.checked);
            setText(source, bodies.checked ? said : '');
          } catch (error) {
            setText(source, error.message);
          }
        },
      },
    });
    const list = h('div', { class: 'things', 'data-testid': 'world' });
    const adder = (text, kind, role, title) =>
      button(text, { title, 'data-testid': `add-${role}-${kind}` }, () => add(kind, role));
    root.append(
      h(
        'div',
        { class: 'line' },
        adder('+ Object', 'box', 'object', 'A box that the gripper can take'),
        adder('+ Box', 'box', 'obstacle', 'A table, a wall'),
        adder('+ Cylinder', 'cylinder', 'obstacle', 'A post, a can'),
        adder('+ Frame', 'frame', 'obstacle', 'A place with a name'),
      ),
      h('p', {
        class: 'hint',
        text: 'An object is taken by a gripper that closes with the tool’s point at it, and goes with the tool until it opens.',
      }),
      h(
        'div',
        { class: 'line' },
        h('label', { class: 'check' }, watch, 'Distance, always'),
        h('label', { class: 'check' }, bodies, 'Bodies it is measured of'),
      ),
      nearest,
      source,
      list,
    );
    const showNearest = () => {
      const c = state.clearance;
      nearest.hidden = !c;
      if (!c) return;
      if (c.waiting) {
        nearest.dataset.tone = 'note';
        setText(nearest, 'Measuring the distance …');
        return;
      }
      nearest.dataset.tone = c.refused || c.metres <= 0 ? 'wrong' : 'good';
      const [one, other] = c.pair ?? [];
      setText(
        nearest,
        c.refused ??
          (c.metres === null
            ? 'There is nothing that could be touched.'
            : c.metres > 0
              ? `Nearest: ${one} and ${other}, ${showUnit(c.metres, 'length')} apart.`
              : `${one} and ${other} overlap by ${showUnit(-c.metres, 'length')}.`),
      );
    };
    on(['clearance', 'units'], showNearest);
    on('bodies-gone', () => {
      bodies.checked = false;
      setText(source, '');
    });
    let quietly = false;
    const rebuild = (why) => {
      if (quietly || why === 'python') return;
      if (why === 'undo') rows();
      else remake(list, rows);
    };
    const rows = () => {
      const none = h('p', { class: 'hint', text: 'Nothing stands around the arm yet.' });
      replace(list, state.world.length ? state.world.map(entry) : none);
    };
    function entry(t, k) {
      const quiet =
        (f) =>
        (...args) => {
          quietly = true;
          f(...args);
          quietly = false;
        };
      const name = h('input', {
        type: 'text',
        value: t.name,
        maxlength: '40',
        'aria-label': `Name of ${t.name}`,
        on: { change: () => rename(k, name) },
      });
      const size = sizes[t.kind].map((what, i) => {
        const f = numberField({
          label: `${t.name}, ${what}`,
          kind: 'length',
          testid: `world-${k + 1}-size-${i}`,
          key: `${t.name}/${what}`,
          check: (v) => (v > 0 ? null : 'more than 0'),
          input: quiet((v) => {
            const now = state.world[k];
            const part =
              t.kind === 'box' ? { size: now.size.map((s, m) => (m === i ? v : s)) } : { [i ? 'h' : 'r']: v };
            change(k, part, `size of ${t.name}`);
          }),
        });
        f.put(t.kind === 'box' ? t.size[i] : i ? t.h : t.r);
        return h('label', { class: 'field' }, h('span', { class: 'field-name', text: `${what}, ${units.length}` }), f);
      });
      const at = poseEditor(
        t.kind === 'frame' ? `Place of ${t.name}` : `Place of the middle of ${t.name}`,
        `world-${k + 1}`,
        () => state.world[k]?.T,
        quiet((T) => change(k, { T }, `move ${t.name}`)),
        t.name,
      );
      return h(
        'section',
        { class: 'thing', 'aria-label': t.name, 'data-testid': `thing-${k + 1}` },
        h(
          'div',
          { class: 'line spread' },
          h(
            'span',
            { class: 'line' },
            name,
            h('span', { class: 'hint', text: words[t.kind] }),
            t.kind === 'frame'
              ? null
              : select(
                  `What ${t.name} is`,
                  [
                    ['object', 'object'],
                    ['obstacle', 'obstacle'],
                  ],
                  t.role,
                  (role) => change(k, { role }, `make ${t.name} an ${role}`),
                ),
          ),
          rowTools({
            k,
            name: t.name,
            remove: () =>
              setWorld(
                state.world.filter((_, i) => i !== k),
                `remove ${t.name}`,
              ),
          }),
        ),
        size.length ? h('div', { class: 'line' }, size) : null,
        at.el,
      );
    }
    on(['world', 'units'], rebuild);
    rebuild();
  },
};
