// Joints: a slider and a field each, limits drawn, keyboard steps, named postures; outside the limits is shown, not hidden.
import { button, h, replace, say, setText } from '../dom.mjs';
import { state, on, setJoint, setTable, tell } from '../store.mjs';
import { units, showUnit, plain, fixed } from '../units.mjs';
import { numberField, remake } from '../numberfield.mjs';
import { takePastesAlong } from '../pasting.mjs';
import { outsideOf } from '../scene/shape.mjs';
import { moveTo, stop } from '../animate.mjs';
import { reach, chainValues } from '../kinematics.mjs';

export const kindOf = (joint) => (joint.type === 'R' ? 'angle' : 'length');

/** What a slider spans: the limits with some room beyond, so that a posture outside them can be seen and made. */
function span(joint) {
  const free = joint.type === 'R' ? Math.PI : reach(state.table);
  const lo = joint.lower ?? Math.min(-free, (joint.upper ?? free) - 2 * free);
  const hi = joint.upper ?? Math.max(free, lo + 2 * free);
  const room = Math.max((hi - lo) * 0.08, 1e-3);
  return { lo, hi, min: joint.lower === null ? lo : lo - room, max: joint.upper === null ? hi : hi + room };
}

export const outside = outsideOf;

function row(i) {
  const joint = state.table.joints[i],
    kind = kindOf(joint),
    { lo, hi, min, max } = span(joint);
  const name = `q${i + 1}`;
  const slider = h('input', {
    type: 'range',
    min: String(min),
    max: String(max),
    step: 'any',
    'aria-label': `${name}, ${joint.name}`,
    'data-testid': `slider-${i + 1}`,
  });
  const percent = (v) => `${(100 * (v - min)) / (max - min)}%`;
  slider.style.setProperty('--lo', percent(lo));
  slider.style.setProperty('--hi', percent(hi));
  slider.addEventListener('input', () => {
    stop();
    setJoint(i, Number(slider.value));
  });
  slider.addEventListener('change', () => tell('let-go'));
  slider.addEventListener('keydown', (e) => {
    const k = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[e.key];
    const end = { Home: lo, End: hi }[e.key];
    if (k === undefined && end === undefined) return;
    e.preventDefault();
    stop();
    const by = units.step(kind) * (e.shiftKey ? 0.1 : 1);
    setJoint(i, end ?? Math.min(Math.max(Math.round((state.q[i] + k * by) / (by / 10)) * (by / 10), min), max));
  });
  const number = numberField({
    label: `${name} value`,
    kind,
    testid: `q-${i + 1}`,
    key: `q/${joint.name}`,
    input: (v) => {
      stop();
      setJoint(i, v);
    },
  });
  const note = h('span', { class: 'out', role: 'note' });
  const chain = h('span', { class: 'chain', title: 'What this row of the table moves by' });
  const limits = h('span', { class: 'limits' });
  const el = h(
    'div',
    { class: 'joint', 'data-testid': `joint-${i + 1}` },
    h(
      'span',
      { class: 'joint-name', title: `${joint.name}, ${joint.type === 'R' ? 'revolute' : 'prismatic'}` },
      h('i', { text: 'q' }),
      h('sub', { text: String(i + 1) }),
    ),
    h('div', { class: 'track' }, slider, h('div', { class: 'under' }, limits, chain, note)),
    number,
    h('span', { class: 'unit' }),
  );
  return {
    el,
    number,
    show() {
      const v = state.q[i],
        over = outside(joint, v);
      if (document.activeElement !== slider || Number(slider.value) !== v) slider.value = v;
      slider.style.setProperty('--at', percent(Math.min(Math.max(v, min), max)));
      slider.setAttribute('aria-valuetext', showUnit(v, kind));
      number.put(v, String(Number((v * units.factor(kind)).toFixed(units.digits(kind) + 1)) + 0));
      el.classList.toggle('outside', over !== 0);
      const moved = state.table.coupling ? `chain ${showUnit(chainValues(state.table, state.q)[i], kind)}` : '';
      setText(chain, moved);
      setText(note, over ? `${showUnit(Math.abs(over), kind)} ${over > 0 ? 'above' : 'below'} the limit` : '');
    },
    relabel() {
      setText(el.lastChild, units.symbol(kind));
      const end = (v) =>
        v === null ? 'no limit' : showUnit(v, kind, units.angle === 'deg' && kind === 'angle' ? 0 : undefined);
      setText(
        limits,
        joint.lower === null && joint.upper === null ? 'no limits' : `${end(joint.lower)} … ${end(joint.upper)}`,
      );
      number.refresh();
      this.show();
    },
  };
}

export const joints = {
  id: 'joints',
  title: 'Joints',
  build(root) {
    let rows = [];
    const list = h('div', { class: 'joints', 'data-testid': 'joints' });
    const postures = h('div', { class: 'chips', role: 'group', 'aria-label': 'Postures' });
    const gripper = h('div', { class: 'joints gripper' });
    root.append(list, gripper, postures);
    const rebuild = () => {
      rows = state.table.joints.map((_, i) => row(i));
      replace(
        list,
        rows.map((r) => r.el),
      );
      if (!rows.length)
        list.append(h('p', { class: 'hint', text: 'This table has no joints yet. Add one in the DH table.' }));
      rows.forEach((r) => r.relabel());
      replace(gripper, state.table.actuator ? actuatorRow(state.table.actuator) : null);
      showPostures(postures);
    };
    takePastesAlong(list, 'paste joint values', () => rows.map((r) => r.number));
    on('table', (what) => {
      if (what === 'undo' || what === 'new') rebuild();
      else if (what !== 'gripper') remake(list, rebuild);
    });
    on('q', () => rows.forEach((r) => r.show()));
    on('units', () => rows.forEach((r) => r.relabel()));
    rebuild();
  },
};

/** The tool's own actuator: it has a value and limits and moves no frame. */
function actuatorRow(a) {
  const slider = h('input', {
    type: 'range',
    min: String(a.lower),
    max: String(a.upper),
    step: 'any',
    'aria-label': `${a.name}, ${a.unit}`,
    'data-testid': 'actuator',
  });
  const value = h('output', { class: 'quantity' });
  const show = () => {
    slider.style.setProperty('--at', `${(100 * (a.value - a.lower)) / (a.upper - a.lower || 1)}%`);
    setText(value, fixed(a.value, 1));
  };
  slider.value = a.value;
  slider.addEventListener('input', () => {
    a = { ...a, value: Number(slider.value) };
    setTable({ ...state.table, actuator: a }, { what: 'gripper', label: `set the ${a.name}`, key: 'actuator' });
    show();
  });
  show();
  const note = h('div', { class: 'under' }, h('span', { text: `${a.name}: moves no frame` }));
  return h(
    'div',
    { class: 'joint' },
    h('span', { class: 'joint-name', text: 'tool' }),
    h('div', { class: 'track' }, slider, note),
    value,
    h('span', { class: 'unit', text: a.unit }),
  );
}

function showPostures(root) {
  const n = state.table.joints.length;
  const named = Object.entries(state.table.postures ?? {});
  const go = (name, q) =>
    button(name, { class: 'chip', title: q.map((v, i) => showUnit(v, kindOf(state.table.joints[i]))).join(', ') }, () =>
      moveTo(q, 0.8, `move to ${name}`),
    );
  const chips = named.map(([name, q]) => go(name, q));
  if (n && !named.some(([, q]) => q.every((v) => v === 0))) chips.unshift(go('zero', new Array(n).fill(0)));
  replace(
    root,
    chips,
    n
      ? button('Random', { class: 'chip quiet', title: 'A posture inside the limits' }, () =>
          moveTo(randomPosture(), 0.8, 'move to a random posture'),
        )
      : null,
    n ? button('Keep this one', { class: 'chip quiet', title: 'Add the present posture to the arm' }, keep) : null,
  );
}
export function randomPosture() {
  return state.table.joints.map((j) => {
    const { lo, hi } = span(j);
    return lo + Math.random() * (hi - lo);
  });
}
function keep() {
  const postures = { ...state.table.postures };
  let k = 0;
  while (`P${k}` in postures) k += 1;
  postures[`P${k}`] = state.q.slice();
  setTable({ ...state.table, postures }, { what: 'postures', label: `keep the posture P${k}` });
  say(`Kept as P${k}: ${state.q.map((v, i) => plain(v, kindOf(state.table.joints[i]))).join(', ')}`);
  tell('postures');
}
