// One step of a program, opened: what it is, where to, how fast, how its corner is cut.
import { button, choice, h, select } from '../dom.mjs';
import { identity, position } from '../matrix.mjs';
import { state } from '../store.mjs';
import { units } from '../units.mjs';
import { numberField } from '../numberfield.mjs';
import { moveTo } from '../animate.mjs';
import { changeStep, taughtAt } from '../program.mjs';
import { poseEditor } from './pose_editor.mjs';

/** @param quietly runs what changes a step while its own editor stays as it is */
export function stepEditor(quietly) {
  const label = (k) => `edit step ${k + 1}`;
  const changed = (k, change, key) => changeStep(k, change, label(k), { key: `step-${k}-${key}` });
  function numberOf(k, key, text, options) {
    const f = numberField({
      label: `Step ${k + 1}, ${text}`,
      testid: `step-${k + 1}-${key}`,
      ...options,
      input: (v) => {
        quietly(() => changed(k, { [key]: v }, key));
      },
    });
    f.put(state.program[k][key] ?? null);
    return h(
      'label',
      { class: 'field' },
      h('span', { class: 'field-name', text: options.unit ? `${text}, ${options.unit}` : text }),
      f,
    );
  }
  /** What changes where a step's target does: the last pose of a spline is its target. */
  const at = (k, T) => {
    const s = state.program[k];
    return s.kind === 'spline' ? { T, through: [...s.through.slice(0, -1), T] } : { T };
  };
  const isWhole = (v, lo, hi) => Number.isInteger(v) && v >= lo && v <= hi;
  const typed = (k) => (key, title) =>
    poseEditor(
      title,
      `step-${k + 1}-${key}`,
      () => state.program[k]?.[key],
      (T) => {
        const posture = state.program[k].kind === 'frame' ? {} : { q: null };
        quietly(() => changed(k, key === 'T' ? { ...at(k, T), ...posture } : { [key]: T }, key));
      },
    ).el;
  /** A circle over a pose, or about a centre the shorter or the longer way. */
  function circleBy(s, k) {
    const by = choice(
      'A circle by',
      [
        ['via', 'a pose on it'],
        ['centre', 'its centre'],
      ],
      s.centre ? 'centre' : 'via',
      (v) =>
        changeStep(
          k,
          v === 'centre' ? { centre: position(s.via ?? s.T), long_way: false } : { centre: null, via: s.via ?? s.T },
          label(k),
        ),
      `step-${k + 1}-by`,
    );
    if (!s.centre) return h('div', {}, h('div', { class: 'line' }, by), typed(k)('via', 'Over'));
    const centre = ['X', 'Y', 'Z'].map((name, i) => {
      const f = numberField({
        label: `Step ${k + 1}, centre ${name}`,
        kind: 'length',
        testid: `step-${k + 1}-centre-${i}`,
        input: (v) => {
          const c = state.program[k].centre.slice();
          c[i] = v;
          quietly(() => changed(k, { centre: c }, 'centre'));
        },
      });
      f.put(s.centre[i]);
      return h('label', { class: 'field' }, h('span', { class: 'field-name', text: name }), f);
    });
    const far = h('input', {
      type: 'checkbox',
      checked: Boolean(s.long_way),
      'data-testid': `step-${k + 1}-far`,
      on: { change: () => changed(k, { long_way: far.checked }, 'far') },
    });
    return h(
      'div',
      {},
      h('div', { class: 'line' }, by),
      h('div', { class: 'line' }, ...centre, h('span', { class: 'unit', text: units.length })),
      h('label', { class: 'check' }, far, 'the longer way round'),
    );
  }
  /** The poses that a spline goes through before its target. */
  function throughPoses(s, k) {
    const change = (through) => changeStep(k, { through, T: through.at(-1) }, label(k));
    return h(
      'div',
      { class: 'line' },
      h('span', {
        class: 'field-name',
        text:
          s.through.length === 1
            ? 'Goes to its target alone; add poses for it to go through'
            : `Goes through ${s.through.length} poses, the last one its target`,
      }),
      button('Add the present pose', { class: 'quiet', 'data-testid': `step-${k + 1}-through` }, () =>
        change([...s.through, taughtAt(k)]),
      ),
      button('Take the last one out', { class: 'quiet', disabled: s.through.length < 2 }, () =>
        change(s.through.slice(0, -1)),
      ),
    );
  }
  function editor(s, k) {
    if (s.kind === 'wait')
      return h(
        'div',
        { class: 'line step-editor' },
        numberOf(k, 'seconds', 'seconds', { check: (v) => (v >= 0 ? null : '0 or more') }),
      );
    if (s.kind === 'gripper')
      return h(
        'div',
        { class: 'line step-editor' },
        numberOf(k, 'value', 'value', { check: (v) => (v >= 0 && v <= 1 ? null : 'from 0, open, to 1, closed') }),
      );
    if (s.kind === 'call')
      return h(
        'div',
        { class: 'line step-editor' },
        numberOf(k, 'first', 'from step', { check: (v) => (isWhole(v, 1, k) ? null : `from 1 to ${k}`) }),
        numberOf(k, 'last', 'to step', { check: (v) => (isWhole(v, s.first, k) ? null : `from ${s.first} to ${k}`) }),
        numberOf(k, 'times', 'times', { check: (v) => (isWhole(v, 1, 50) ? null : 'a whole number from 1 to 50') }),
      );
    if (s.kind === 'frame')
      return h(
        'div',
        { class: 'step-editor' },
        typed(k)('T', 'The frame, in the base'),
        h(
          'div',
          { class: 'line' },
          button('Take the present pose', { class: 'quiet', 'data-testid': `step-${k + 1}-teach` }, () =>
            changeStep(k, { T: state.frames.at(-1).slice() }, `teach step ${k + 1}`),
          ),
          button('The base', { class: 'quiet', title: 'The poses that follow are meant in the base again' }, () =>
            changeStep(k, { T: identity() }, `end the frame at step ${k + 1}`),
          ),
        ),
      );
    if (s.kind === 'output')
      return h(
        'div',
        { class: 'line step-editor' },
        numberOf(k, 'port', 'port', {
          check: (v) => (Number.isInteger(v) && v >= 0 ? null : 'a whole number from 0'),
        }),
        h(
          'label',
          { class: 'check' },
          h('input', {
            type: 'checkbox',
            checked: s.value,
            on: { change: (e) => changed(k, { value: e.target.checked }, 'value') },
          }),
          'on',
        ),
      );
    return h(
      'div',
      { class: 'step-editor' },
      h(
        'div',
        { class: 'line' },
        select(
          'Kind of move',
          [
            ['joint', 'Joints'],
            ['line', 'Line'],
            ['circle', 'Circle'],
            ['spline', 'Spline'],
          ],
          s.kind,
          (kind) =>
            changed(
              k,
              {
                kind,
                q: kind === 'joint' ? (s.q ?? null) : null,
                speed: null,
                ...(kind === 'circle' && !s.via ? { via: s.T } : {}),
                ...(kind === 'spline' ? { through: s.through ?? [...(s.via ? [s.via] : []), s.T] } : {}),
              },
              'kind',
            ),
          { 'data-testid': `step-${k + 1}-kind` },
        ),
        numberOf(k, 'blend', 'blend', {
          kind: 'length',
          unit: units.length,
          check: (v) => (v >= 0 ? null : '0 or more'),
        }),
        s.kind === 'joint'
          ? numberOf(k, 'speed', 'part of the speed', {
              empty: null,
              check: (v) => (v === null || (v > 0 && v <= 1) ? null : 'above 0 to 1'),
            })
          : numberOf(k, 'speed', 'speed', {
              kind: 'length',
              unit: `${units.length}/s`,
              empty: null,
              check: (v) => (v === null || v > 0 ? null : 'more than 0'),
            }),
      ),
      s.kind === 'circle' ? circleBy(s, k) : null,
      s.kind === 'spline' ? throughPoses(s, k) : null,
      typed(k)('T', s.q ? 'To (a taught posture; typing makes it a pose)' : 'To'),
      h(
        'div',
        { class: 'line' },
        button('Take the present pose', { class: 'quiet', 'data-testid': `step-${k + 1}-teach` }, () =>
          changeStep(
            k,
            { ...at(k, taughtAt(k)), q: s.kind === 'joint' ? state.q.slice() : null },
            `teach step ${k + 1}`,
          ),
        ),
        s.q ? button('Go there', { class: 'quiet' }, () => moveTo(s.q.slice(), 0.8, `go to step ${k + 1}`)) : null,
      ),
    );
  }

  return editor;
}
