// The redundant coordinates of the arm for its task: left free, or chosen, with a slider and a field each.
import { h, replace, setText, choice } from '../dom.mjs';
import { state, on, tell } from '../store.mjs';
import { units, showUnit } from '../units.mjs';
import { numberField } from '../numberfield.mjs';
import { reach } from '../kinematics.mjs';
import { options, solve, slide } from '../solving.mjs';

export function spareCoordinates() {
  let list = [],
    rows = [],
    values = {}; // what the rows show, by name
  const rowsBox = h('div', { class: 'joints' });
  const fold = h('details', {}, h('summary', { class: 'hint', text: 'Hold by value' }), rowsBox);
  const note = h('p', { class: 'hint' });
  const mode = choice(
    'Redundant coordinates',
    [
      ['free', 'Free'],
      ['chosen', 'Chosen'],
    ],
    'free',
    (v) => choose(v === 'chosen' ? list.filter((c) => !c.instead).map((c) => c.name) : null),
    'spare-mode',
  );
  const el = h(
    'div',
    {
      class: 'spare',
      role: 'group',
      'aria-label': 'Redundant coordinates of the arm',
      'data-testid': 'spare',
      hidden: true,
    },
    h('div', { class: 'line spread' }, h('span', { class: 'field-name', text: 'Redundant coordinates' }), mode),
    note,
    fold,
  );

  /** Hold these coordinates at what their rows show; null leaves all free. */
  function choose(names, { sliding = false } = {}) {
    tell('did', { label: names ? `hold ${names.join(' and ')}` : 'free the redundant coordinates', key: 'spare' });
    options.redundancy = names && Object.fromEntries(names.map((name) => [name, values[name]]));
    show();
    if (sliding) slide();
    else solve({ follow: true });
  }
  /** An arm angle stands for the redundant joint: choosing one lets go of the other. */
  const together = (c) => list.filter((other) => other.instead === c.instead).map((other) => other.name);

  const jointOf = (c) => state.table.joints.findIndex((j) => j.name === c.name);
  function row(c, i) {
    const free = c.kind === 'angle' ? Math.PI : reach(state.table),
      lo = c.lower ?? -free,
      hi = c.upper ?? free;
    const slider = h('input', {
      type: 'range',
      min: String(lo),
      max: String(hi),
      step: 'any',
      'aria-label': `Slide ${c.name}`,
      'data-testid': `spare-slider-${i + 1}`,
    });
    let held = false; // a key is
    const set = (v, sliding) => {
      values[c.name] = v;
      choose(together(c), { sliding });
    };
    slider.addEventListener('input', () => set(Number(slider.value), true));
    slider.addEventListener('change', () => solve({ follow: true }));
    slider.addEventListener('keydown', (e) => {
      const k = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[e.key];
      if (k === undefined) return;
      e.preventDefault();
      held = true;
      const by = k * units.step(c.kind) * (e.shiftKey ? 0.1 : 1);
      set(Math.min(Math.max(values[c.name] + by, lo), hi), true);
    });
    slider.addEventListener('keyup', () => {
      if (held) solve({ follow: true });
      held = false;
    });
    const field = numberField({
      label: `Value of ${c.name}`,
      kind: c.kind,
      testid: `spare-${i + 1}`,
      check: (v) =>
        v < lo - 1e-9 && c.lower !== null
          ? `below the limit ${showUnit(lo, c.kind)}`
          : v > hi + 1e-9 && c.upper !== null
            ? `above the limit ${showUnit(hi, c.kind)}`
            : null,
      commit: (v) => set(v, false),
    });
    const limits = h('span', { class: 'limits' });
    const line = h(
      'div',
      { class: 'joint' },
      h('span', { class: 'joint-name', text: c.name }),
      h('div', { class: 'track' }, slider, h('div', { class: 'under' }, limits)),
      field,
      h('span', { class: 'unit' }),
    );
    return {
      line,
      show() {
        const v = values[c.name];
        slider.value = v;
        slider.style.setProperty('--at', `${(100 * (Math.min(Math.max(v, lo), hi) - lo)) / (hi - lo || 1)}%`);
        slider.setAttribute('aria-valuetext', showUnit(v, c.kind));
        line.classList.toggle('held', Boolean(options.redundancy && c.name in options.redundancy));
        field.put(Number((v * units.factor(c.kind)).toFixed(units.digits(c.kind) + 1)) / units.factor(c.kind));
      },
      relabel() {
        setText(line.lastChild, units.symbol(c.kind));
        const end = (v) =>
          v === null ? 'no limit' : showUnit(v, c.kind, c.kind === 'angle' && units.angle === 'deg' ? 0 : undefined);
        setText(limits, c.lower === null && c.upper === null ? 'no limits' : `${end(c.lower)} … ${end(c.upper)}`);
        field.refresh();
      },
    };
  }

  function show() {
    // what is free goes where the arm is
    for (const c of list) {
      if (options.redundancy && c.name in options.redundancy) values[c.name] = options.redundancy[c.name];
      else if (jointOf(c) >= 0) values[c.name] = state.q[jointOf(c)];
      else if (c.instead && Number.isFinite(state.solutions?.arm_angle)) values[c.name] = state.solutions.arm_angle;
      else values[c.name] ??= 0;
    }
    mode.mark(options.redundancy ? 'chosen' : 'free');
    setText(
      note,
      options.redundancy
        ? 'Held at these values; what is left has separate solutions.'
        : 'Free: the solutions form self-motions; the table has those at the present values.',
    );
    for (const r of rows) r.show();
  }
  on('solutions', () => {
    const next = state.solutions?.spare;
    // an answer on the way, or a refused one, says nothing of the coordinates
    if (!state.solutions || (!next && (state.solutions.brief || state.solutions.status === 'REFUSED'))) return;
    const fresh = JSON.stringify(next ?? []) !== JSON.stringify(list);
    if (fresh) {
      list = next ?? [];
      values = {};
      rows = list.map(row);
      replace(
        rowsBox,
        rows.map((r) => r.line),
      );
      for (const r of rows) r.relabel();
    }
    el.hidden = list.length === 0;
    // one coordinate to spare: the slider along the self-motion below is the one to use
    if (fresh) fold.open = list.filter((c) => !c.instead).length > 1 || Boolean(options.redundancy);
    show();
  });
  on('table', (what) => {
    if (what !== 'new') return; // the coordinates of another arm
    list = [];
    el.hidden = true;
  });
  on('q', () => !el.hidden && !el.closest('[hidden]') && !options.redundancy && show());
  on('units', () => {
    for (const r of rows) r.relabel();
    show();
  });
  return el;
}
