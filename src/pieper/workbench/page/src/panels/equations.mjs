// Equations: forward and inverse, typeset, with symbols, the arm's lengths or the present numbers, their values beside them.
import { button, choice, copy, debounce, h, perFrame, replace, setText } from '../dom.mjs';
import { state, on } from '../store.mjs';
import { askArm } from '../library.mjs';
import { fixed, show, units } from '../units.mjs';
import { withPresentNumbers } from '../presentnumbers.mjs';
import { kindOf } from './joints.mjs';

let typeset = null;
async function katex() {
  typeset ??= (await import('katex')).default;
  return typeset;
}

/** A formula inside a sentence. */
function inline(k, formula) {
  const el = h('span');
  try {
    k.render(formula.latex, el, { throwOnError: true, strict: false, trust: false });
  } catch {
    el.textContent = formula.text;
  }
  return el;
}

/** The pieces of a sentence: words, formulas, words as they are typed, words set off. */
function prose(k, pieces) {
  const kinds = [
    [(p) => typeof p === 'string', (p) => p],
    [(p) => 'latex' in p, (p) => inline(k, p)],
    [(p) => 'code' in p, (p) => h('code', { text: p.code })],
    [() => true, (p) => h('em', { text: p.emphasis })],
  ];
  return pieces.map((piece) => kinds.find(([is]) => is(piece))[1](piece));
}

/** A sentence for the clipboard, as LaTeX. */
const sentence = (pieces) =>
  pieces.map((p) => (typeof p === 'string' ? p : p.latex ? `$${p.latex}$` : (p.code ?? p.emphasis))).join('');

function valueTable(rows) {
  const heads = state.table.joints.map((j, i) =>
    h(
      'th',
      {},
      h('i', { text: 'q' }),
      h('sub', { text: String(i + 1) }),
      h('span', { class: 'unit', text: ` ${units.symbol(kindOf(j))}` }),
    ),
  );
  return [
    h('h3', { text: 'The formulas at the present pose' }),
    h(
      'table',
      { class: 'plain', 'data-testid': 'formula-values', 'aria-label': 'Branches of the formulas at the present pose' },
      h('thead', {}, h('tr', {}, h('th', { text: 'branch' }), heads)),
      h(
        'tbody',
        {},
        rows.map((q, k) =>
          h(
            'tr',
            {},
            h('th', { scope: 'row', text: String(k + 1) }),
            q.map((v, i) => h('td', { text: show(v, kindOf(state.table.joints[i])) })),
          ),
        ),
      ),
    ),
  ];
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
      blocks = [];
    const note = h('p', { class: 'hint', role: 'status', 'data-testid': 'equations-note' });
    const body = h('div', {
      class: 'equations',
      tabindex: '0',
      role: 'region',
      'aria-label': 'Equations',
      'data-testid': 'equations',
    });
    const lengths = choice(
      'Written with',
      [
        ['symbols', 'Symbols'],
        ['numbers', 'Lengths'],
        ['present', 'Numbers'],
      ],
      numbers,
      (v) => {
        numbers = v;
        refresh();
      },
      'equation-numbers',
    );
    const values = h('div', { class: 'scroll' });
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
          lengths,
        ),
        button('Copy LaTeX', { class: 'quiet' }, () => copy(source())),
      ),
      note,
      values,
      body,
    );

    const latexOf = (b) => (b.symbols && numbers === 'present' ? withPresentNumbers(b, state.table, state.q) : b.latex);
    const tagOf = (b) => (b.number === undefined ? '' : ` \\tag{${b.number}}`);
    const source = () =>
      blocks.map((b) => (b.kind === 'equation' ? `\\[ ${latexOf(b)}${tagOf(b)} \\]` : sentence(b.pieces))).join('\n\n');
    /** A formula wider than its place fades out at the edge and is scrolled by itself, with the keyboard too. */
    function measure() {
      const all = [...body.querySelectorAll('.formula')];
      for (const el of all) el.classList.remove('broad');
      const needs = all.map((el) => (el.scrollWidth > el.clientWidth ? el.scrollWidth : 0));
      all.forEach((el, i) => {
        el.classList.toggle('broad', needs[i] > 0);
        el.style.setProperty('--across', `${needs[i]}px`);
        if (needs[i]) el.tabIndex = 0;
        else el.removeAttribute('tabindex');
      });
    }
    let across = 0;
    new ResizeObserver(() => {
      if (body.clientWidth === across) return;
      across = body.clientWidth;
      measure();
    }).observe(body);
    function typesetAll(k) {
      live = [];
      replace(
        body,
        blocks.map((b) => block(k, b)),
      );
      measure();
      update();
    }
    async function refresh() {
      if (panel.hidden || !state.table.joints.length) return;
      const key = `${which}/${numbers}/${JSON.stringify(state.table.joints)}${state.table.convention}`;
      if (asked === key) return;
      asked = key;
      setText(note, 'Deriving …');
      blocks = [];
      replace(body);
      replace(values);
      try {
        const [k, answer] = await Promise.all([
          katex(),
          askArm('equations', { which, numbers: numbers === 'symbols' ? numbers : 'numbers' }, (m) =>
            setText(note, m.note ?? ''),
          ),
        ]);
        if (asked !== key) return;
        setText(note, answer.note ?? '');
        blocks = answer.blocks;
        typesetAll(k);
        lengths.hidden = which !== 'forward';
        replace(values);
        evaluate();
      } catch (error) {
        if (asked !== key) return;
        asked = null;
        setText(note, error.message);
      }
    }
    /** A heading, a sentence, a formula, or a formula with its number or its present value beside it. */
    function block(k, b) {
      if (b.kind === 'heading' || b.kind === 'step') return h('h3', {}, prose(k, b.pieces));
      if (b.kind !== 'equation') return h('p', { class: 'prose' }, prose(k, b.pieces));
      const el = h('div', { class: 'formula' });
      try {
        k.render(latexOf(b), el, {
          displayMode: true,
          throwOnError: true,
          strict: false,
          trust: false,
          maxSize: 20,
          maxExpand: 1000,
        });
      } catch {
        el.replaceChildren(h('code', { text: latexOf(b) }));
      }
      if (b.number !== undefined)
        return h('div', { class: 'formula-row numbered' }, el, h('span', { class: 'hint', text: `(${b.number})` }));
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
    /** The derivation with the present numbers put in: what its formulas give at the present pose, branch by branch. */
    const evaluate = debounce(async () => {
      if (panel.hidden || which !== 'inverse' || !body.childElementCount) return;
      const T = state.frames.at(-1);
      try {
        const { rows } = await askArm('formulas', { T });
        if (T !== state.frames.at(-1)) return;
        values.classList.remove('stale');
        replace(values, rows.length && which === 'inverse' ? valueTable(rows) : null);
      } catch {
        replace(values);
      }
    }, 250);
    const follow = debounce(() => {
      if (!panel.hidden && typeset && blocks.length && which === 'forward' && numbers === 'present')
        typesetAll(typeset);
    }, 120);
    on('q', follow);
    on('panel', follow);
    on('q', () => values.classList.add('stale'));
    on('q', evaluate);
    on('units', evaluate);
    on('panel', refresh);
    on('plan', refresh);
    on(['q', 'units'], update);
  },
};
