// Around the arm: the bar at the top, the rail of panels, the buttons over the picture, undo by keyboard.
import { button, choice, h, replace, say, select, setText } from './dom.mjs';
import { state, on, tell, setTable, presentable } from './store.mjs';
import { undo, redo, toUndo, toRedo } from './history.mjs';
import { units, showUnit } from './units.mjs';
import { setTheme, setTextSize, textSize } from './theme.mjs';
import { ask } from './link.mjs';
import { sentence, countWords } from './library.mjs';
import { catalogueDialog } from './catalogue.mjs';
import { lookChoice } from './look_choice.mjs';
import { present, savePicture } from './room.mjs';
import { layout } from './layout.mjs';
import { look, ground } from './scene/view.mjs';
import { fitArm, frameName, setTracing, clearTrace } from './scene/arm.mjs';
import { axisColours } from './scene/frames.mjs';

export function bar(root) {
  const arms = h('select', {
    'aria-label': 'Arm from the catalogue',
    'data-testid': 'catalog',
    on: { change: () => open(arms.value) },
  });
  const find = catalogueDialog(open);
  const what = h('p', { class: 'sentence', 'data-testid': 'sentence' });
  const online = h('span', { class: 'online', role: 'status', 'data-testid': 'online' });
  const stepButton = (text, name, go, keys) => {
    const el = button(text, { 'aria-label': name }, go);
    el.show = (label) => {
      el.disabled = !label;
      el.title = label ? `${name}: ${label} (${keys})` : `Nothing to ${name.toLowerCase()}`;
      el.setAttribute('aria-description', label ?? '');
    };
    return el;
  };
  const back = stepButton('↶', 'Undo', undo, 'Ctrl+Z'),
    forth = stepButton('↷', 'Redo', redo, 'Ctrl+Shift+Z');
  on('history', () => {
    back.show(toUndo());
    forth.show(toRedo());
  });
  const list = () => {
    const { name, derived, catalog } = state.table;
    const own = catalog
      ? []
      : [h('option', { value: '', text: derived ? `${name} (from ${derived}, edited)` : name || 'my-arm' })];
    replace(
      arms,
      own,
      (state.catalog ?? []).map((name) => h('option', { value: name, text: name })),
    );
    arms.value = catalog ?? '';
  };
  const steps = h('span', { class: 'group', role: 'group', 'aria-label': 'History' }, back, forth);
  root.append(
    h(
      'h1',
      { class: 'mark' },
      h('img', { src: 'icon.svg', alt: '', width: '22', height: '22' }),
      h('span', { text: 'pieper' }),
    ),
    arms,
    button('Find…', { class: 'find', 'aria-label': 'Find an arm in the catalogue', 'data-testid': 'find-arm' }, find),
    steps,
    what,
    h(
      'span',
      { class: 'bar-end' },
      online,
      choice(
        'Angles in',
        [
          ['deg', '°'],
          ['rad', 'rad'],
        ],
        units.angle,
        (v) => {
          units.set('angle', v);
          tell('units');
        },
        'unit-angle',
      ),
      choice(
        'Lengths in',
        [
          ['mm', 'mm'],
          ['m', 'm'],
        ],
        units.length,
        (v) => {
          units.set('length', v);
          tell('units');
        },
        'unit-length',
      ),
      select(
        'Size of the letters',
        [1, 1.15, 1.3, 1.5].map((size) => [String(size), `${Math.round(100 * size)} %`]),
        String(textSize()),
        (size) => setTextSize(Number(size)),
        { 'data-testid': 'text-size' },
      ),
      select(
        'Light or dark',
        [
          ['auto', 'Auto'],
          ['light', 'Light'],
          ['dark', 'Dark'],
        ],
        state.theme,
        setTheme,
        { 'data-testid': 'theme' },
      ),
    ),
  );
  tell('history');
  on(['catalog', 'table'], list);
  on('plan', () => {
    const said = [countWords(state.plan), sentence(state.plan)].filter(Boolean).join('. ').replace('..', '.');
    setText(what, state.plan ? said : 'Looking how it is solved …');
    what.title = state.plan?.explain ?? '';
  });
  on('online', (yes) => {
    setText(online, yes ? '' : 'Server away; reconnecting');
    online.classList.toggle('away', !yes);
  });
  on(['units', 'theme'], () => {
    root.querySelector('[data-testid=unit-angle]').mark(units.angle);
    root.querySelector('[data-testid=unit-length]').mark(units.length);
    root.querySelector('[data-testid=theme]').value = state.theme;
  });
}
async function open(name) {
  if (!name) return;
  try {
    const { table } = await ask('load', { name });
    setTable(table, { q: presentable(table), what: 'new', label: `open ${name}` });
  } catch (error) {
    tell('catalog'); // the picker names the arm that is shown
    say(error.message, 'wrong');
  }
}

/** Tabs down the side; `move` holds Joints and Pose, which stay pinned on a wide screen. */
export function rail(root, host, pinned, panels) {
  const tabs = h('div', { role: 'tablist', 'aria-orientation': 'vertical', class: 'tabs' });
  const wide = () => layout() === 'pinned';
  root.append(tabs);
  const scrolled = new Map();
  const built = panels.map((p) => {
    const panel = h('div', {
      role: 'tabpanel',
      class: 'panel',
      id: `panel-${p.id}`,
      'aria-labelledby': `tab-${p.id}`,
      'data-testid': `panel-${p.id}`,
      hidden: true,
    });
    for (const section of p.sections ?? [p]) {
      const inner = h('section', { class: 'section' }, h('h2', { text: section.title }));
      panel.append(inner);
      section.build(inner, panel);
    }
    const tab = button(p.title, { role: 'tab', id: `tab-${p.id}`, 'aria-controls': panel.id }, () => show(p.id));
    if (p.group) tabs.append(h('span', { class: 'tab-group', 'aria-hidden': 'true', text: p.group }));
    tabs.append(tab);
    return { ...p, panel, tab };
  });
  function show(id) {
    if (wide() && id === 'move') id = 'inverse';
    scrolled.set(state.panel, host.scrollTop);
    state.panel = id;
    for (const b of built) {
      const pin = wide() && b.id === 'move';
      const yes = b.id === id || pin;
      (pin ? pinned : host).append(b.panel);
      b.panel.hidden = !yes;
      b.tab.hidden = pin;
      b.tab.setAttribute('aria-selected', String(b.id === id));
      b.tab.tabIndex = b.id === id ? 0 : -1;
      if (b.id === id) {
        document.getElementById('room').dataset.panel = id;
        document.getElementById('room').classList.toggle('wide', Boolean(b.wide));
      }
    }
    tell('panel', id);
    host.scrollTop = scrolled.get(id) ?? 0;
  }
  tabs.addEventListener('keydown', (e) => {
    const way = { ArrowDown: 1, ArrowUp: -1, ArrowRight: 1, ArrowLeft: -1 }[e.key];
    if (!way) return;
    e.preventDefault();
    const open = built.filter((b) => !b.tab.hidden),
      at = open.findIndex((b) => b.id === state.panel);
    const next = open[(at + way + open.length) % open.length];
    show(next.id);
    next.tab.focus();
  });
  on('layout', () => show(state.panel === 'move' || !built.some((b) => b.id === state.panel) ? 'move' : state.panel));
  show(state.panel);
  return show;
}

/** Over the picture: views, frames, trace, the key of the axes. */
export function overlay(root) {
  const views = h(
    'div',
    { class: 'group', role: 'group', 'aria-label': 'Views' },
    [
      ['iso', 'Iso'],
      ['front', 'Front'],
      ['side', 'Side'],
      ['top', 'Top'],
    ].map(([v, t]) => button(t, {}, () => look(v))),
    button('Fit', {}, () => fitArm()),
  );
  const frames = h('div', {
    class: 'group frames',
    role: 'group',
    'aria-label': 'Frames shown',
    'data-testid': 'frames',
  });
  const trace = button('Trace', { 'aria-pressed': 'true' }, () => {
    const yes = trace.getAttribute('aria-pressed') !== 'true';
    trace.setAttribute('aria-pressed', String(yes));
    setTracing(yes);
  });
  const clear = button('Clear', { 'aria-label': 'Clear the trace' }, clearTrace);
  const scale = h('span', { class: 'scale' });
  const key = h(
    'div',
    { class: 'key', 'aria-label': 'Axes: x red, y green, z blue' },
    ['x', 'y', 'z'].map((a, i) => {
      const dot = h('span', { class: 'dot' });
      dot.style.setProperty('background', axisColours[i]);
      return h('span', {}, dot, a);
    }),
    scale,
  );
  root.append(
    h(
      'div',
      { class: 'corner top' },
      views,
      h('div', { class: 'group', role: 'group', 'aria-label': 'Trace of the tool' }, trace, clear),
      lookChoice(),
      h(
        'div',
        { class: 'group', role: 'group', 'aria-label': 'The picture' },
        present(root),
        button('PNG', { 'aria-label': 'Save the picture', 'data-testid': 'save-picture' }, savePicture),
      ),
    ),
    h('div', { class: 'corner bottom' }, key, frames),
  );
  let shownFor = -2;
  const list = () => {
    const n = state.table.joints.length,
      all = Array.from({ length: n + 2 }, (_, i) => i);
    // Base and tool at first; afterwards what the person chose, the tool staying the tool when joints come and go.
    state.shownFrames = (state.shownFrames ?? [0, n + 1])
      .map((i) => (i === shownFor + 1 ? n + 1 : i))
      .filter((i) => i < n + 2);
    shownFor = n;
    const set = (shown) => {
      state.shownFrames = shown;
      list();
    };
    replace(
      frames,
      h('span', { class: 'group-name', text: 'Frames' }),
      all.map((i) =>
        button(
          frameName(i),
          { 'aria-pressed': String(state.shownFrames.includes(i)), 'aria-label': `Frame ${frameName(i)}` },
          () =>
            set(state.shownFrames.includes(i) ? state.shownFrames.filter((k) => k !== i) : [...state.shownFrames, i]),
        ),
      ),
      button(state.shownFrames.length === n + 2 ? 'none' : 'all', { 'aria-label': 'All frames or none' }, () =>
        set(state.shownFrames.length === n + 2 ? [] : all),
      ),
    );
    tell('frames');
    setText(scale, `grid ${showUnit(ground.cell, 'length', units.length === 'mm' ? 0 : 2)}`);
  };
  on(['table', 'units'], list);
  list();
}

export function keys() {
  addEventListener('keydown', (e) => {
    if (!(e.ctrlKey || e.metaKey) || e.altKey) return;
    const key = e.key.toLowerCase(),
      typing = e.target.matches?.('input[type=text]:not(.number), textarea');
    if (typing) return;
    if (key === 'z' && !e.shiftKey) {
      e.preventDefault();
      e.target.blur?.();
      undo();
    } else if (key === 'y' || (key === 'z' && e.shiftKey)) {
      e.preventDefault();
      e.target.blur?.();
      redo();
    }
  });
}
