// What a route leaves free and what it keeps: the turn, its axis, a cone, what is cheapest, a distance to singular postures.
import { h, select, choice } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { numberField } from '../numberfield.mjs';
import { units } from '../units.mjs';
import { routing, setRouting } from '../routing.mjs';

const DEG = Math.PI / 180;

export function routeSettings() {
  const change = (what, label, key) => setRouting({ ...what, start: null, end: null }, label, key);
  const field = (text, kind, f) => {
    const name = h('span', { class: 'field-name' }),
      el = h('label', { class: 'field' }, name, f);
    el.label = () => {
      name.textContent = kind === 'plain' ? text : `${text}, ${units.symbol(kind)}`;
    };
    return el;
  };
  const number = (text, kind, testid, check, input) => {
    const f = numberField({ label: text, kind, testid, check, input });
    return { f, el: field(text, kind, f) };
  };
  const turn = choice(
    'How far the tool may turn',
    [
      ['free', 'All the way round'],
      ['within', 'Within'],
    ],
    'free',
    (v) => {
      change({ turn: v === 'free' ? null : [-45 * DEG, 45 * DEG] }, 'free the turn of the route');
      show();
    },
    'route-turn',
  );
  const bounds = [0, 1].map((i) =>
    number(
      i ? 'to' : 'from',
      'angle',
      `route-turn-${i}`,
      (v) => (Math.abs(v) <= 4 * Math.PI ? null : 'at most two turns'),
      (v) => {
        const now = routing().turn?.slice() ?? [0, 0];
        now[i] = v;
        change({ turn: now }, 'bound the turn of the route', `route-turn-${i}`);
      },
    ),
  );
  const axis = choice(
    'About which axis of the tool',
    ['x', 'y', 'z'].map((v) => [v, v]),
    'z',
    (v) => change({ axis: v }, 'set the axis of the route'),
    'route-axis',
  );
  const cone = number(
    'Axis may tilt by',
    'angle',
    'route-cone',
    (v) => (v >= 0 && v < Math.PI / 2 ? null : 'from 0 to less than 90 degrees'),
    (v) => change({ cone: v }, 'set the cone of the route', 'route-cone'),
  );
  const cost = select(
    'What is cheapest',
    [
      ['motion', 'least motion of the joints'],
      ['time', 'least time'],
    ],
    'motion',
    (v) => change({ cost: v }, 'set the cost of the route'),
    { 'data-testid': 'route-cost' },
  );
  const singularity = number(
    'Keep the singular values’ ratio above',
    'plain',
    'route-singularity',
    (v) => (v >= 0 && v < 1 ? null : 'from 0 to less than 1'),
    (v) => change({ singularity: v }, 'keep the route from singular postures', 'route-singularity'),
  );
  const clearance = number(
    'Keep from obstacles',
    'length',
    'route-clearance',
    (v) => (v >= 0 ? null : '0 or more'),
    (v) => change({ clearance: v }, 'keep the route from obstacles', 'route-clearance'),
  );
  const rest = h(
    'details',
    { class: 'fold' },
    h('summary', { text: 'More that is free, and what must be kept' }),
    h('div', { class: 'line' }, cone.el),
    h(
      'div',
      { class: 'line' },
      h('label', { class: 'field' }, h('span', { class: 'field-name', text: 'Cheapest' }), cost),
    ),
    h('div', { class: 'line' }, singularity.el),
    h('div', { class: 'line' }, clearance.el),
  );
  const el = h(
    'div',
    {},
    h(
      'div',
      { class: 'line' },
      h('span', { class: 'field-name', text: 'Turn' }),
      turn,
      ...bounds.map((b) => b.el),
      h('span', { class: 'field-name', text: 'about the tool’s' }),
      axis,
    ),
    rest,
  );
  const numbers = [...bounds, cone, singularity, clearance];
  function show() {
    const r = routing();
    turn.mark(r.turn ? 'within' : 'free');
    bounds.forEach((b, i) => {
      b.el.hidden = !r.turn;
      b.f.put(r.turn?.[i] ?? 0);
    });
    axis.mark(r.axis);
    cone.f.put(r.cone);
    cost.value = r.cost;
    singularity.f.put(r.singularity);
    clearance.f.put(r.clearance);
    clearance.el.hidden = !state.world.some((t) => t.role !== 'object' && t.kind !== 'frame');
    numbers.forEach((n) => n.el.label());
  }
  on(['units', 'world'], show);
  on('routing', (what) => ['undo', 'loaded'].includes(what) && show());
  show();
  return { el, show };
}
