// Equations: forward and inverse, typeset, with symbols or with the arm's numbers, the present values beside them.
import { h, replace, setText, choice, perFrame, copy } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { askArm } from '../library.mjs';
import { fixed, units } from '../units.mjs';

let typeset = null;
async function katex() {
  typeset ??= (await import('katex')).default;
  return typeset;
}

/** A sentence; what stands between dollars is a formula. */
function prose(k, text) {
  return h(
    'span',
    {},
    text.split('$').map((part, i) => {
      if (i % 2 === 0) return part;
      const el = h('span');
      try {
        k.render(part, el, { throwOnError: true, strict: false, trust: false });
      } catch {
        el.textContent = part;
      }
      return el;
    }),
  );
}

export const equations = {
  id: 'equations',
  title: 'Equations',
  wide: true,
  build(root, panel) {
    let which = 'forward',
      numbers = 'symbols',
      asked = null,
      live = [],
      source = '';
    const note = h('p', { class: 'hint', role: 'status', 'data-testid': 'equations-note' });
    const body = h('div', { class: 'equations', 'data-testid': 'equations' });
    root.append(
      h(
        'div',
        { class: 'line spread' },
        h(
          'span',
          { class: 'line' },
          choice(
            'Equations',
            [
              ['forward', 'Forward'],
              ['inverse', 'Inverse'],
              ['singular', 'Singularities'],
            ],
            which,
            (v) => {
              which = v;
              refresh();
            },
            'which-equations',
          ),
          choice(
            'Lengths as',
            [
              ['symbols', 'Symbols'],
              ['numbers', 'Numbers'],
            ],
            numbers,
            (v) => {
              numbers = v;
              refresh();
            },
            'equation-numbers',
          ),
        ),
        h('button', { type: 'button', class: 'quiet', text: 'Copy LaTeX', on: { click: () => copy(source) } }),
      ),
      note,
      body,
    );

    async function refresh() {
      if (panel.hidden || !state.table.joints.length) return;
      const key = `${which}/${numbers}/${JSON.stringify(state.table.joints)}${state.table.convention}`;
      if (asked === key) return;
      asked = key;
      setText(note, 'Deriving …');
      replace(body);
      try {
        const [k, answer] = await Promise.all([
          katex(),
          askArm('equations', { which, numbers }, (m) => setText(note, m.note ?? '')),
        ]);
        if (asked !== key) return;
        setText(note, answer.note ?? '');
        source = answer.blocks.map((b) => (b.latex ? `\\[ ${b.latex} \\]` : b.text)).join('\n\n');
        live = [];
        replace(
          body,
          answer.blocks.map((b) => block(k, b)),
        );
        update();
      } catch (error) {
        if (asked !== key) return;
        asked = null;
        setText(note, error.message);
      }
    }
    /** Text, a formula, or a formula whose present value stands beside it. */
    function block(k, b) {
      if (b.heading) return h('h3', {}, prose(k, b.heading));
      if (b.text) return h('p', { class: 'prose' }, prose(k, b.text));
      const el = h('div', { class: 'formula' });
      try {
        k.render(b.latex, el, {
          displayMode: true,
          throwOnError: true,
          strict: false,
          trust: false,
          maxSize: 20,
          maxExpand: 1000,
        });
      } catch {
        el.replaceChildren(h('code', { text: b.latex }));
      }
      if (b.entry === undefined) return el;
      const value = h('output', { class: 'value', 'data-entry': String(b.entry) });
      live.push({ value, entry: b.entry });
      return h('div', { class: 'formula-row' }, el, value);
    }
    const update = perFrame(() => {
      if (panel.hidden) return;
      const T = state.frames[state.frames.length - 1];
      for (const { value, entry } of live)
        setText(
          value,
          `= ${entry % 4 === 3 ? `${fixed(T[entry] * units.factor('length'), units.digits('length'))} ${units.length}` : fixed(T[entry], 4)}`,
        );
    });
    on('panel', refresh);
    on('plan', refresh);
    on(['q', 'units'], update);
  },
};
