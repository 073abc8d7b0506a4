// One step of a program, opened: what it is, where to, how fast, how its corner is cut.
import { h, select } from '../dom.mjs';
import { state } from '../store.mjs';
import { units } from '../units.mjs';
import { numberField } from '../numberfield.mjs';
import { moveTo } from '../animate.mjs';
import { changeStep } from '../program.mjs';
import { poseEditor } from './pose_editor.mjs';

const tool = () => state.frames.at(-1).slice();

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
    const typed = (key, title) => {
      const e = poseEditor(
        title,
        `step-${k + 1}-${key}`,
        () => state.program[k]?.[key],
        (T) => {
          quietly(() => changed(k, key === 'T' ? { T, q: null } : { [key]: T }, key));
        },
      );
      return e.el;
    };
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
      s.kind === 'circle' ? typed('via', 'Over') : null,
      typed('T', s.q ? 'To (a taught posture; typing makes it a pose)' : 'To'),
      h(
        'div',
        { class: 'line' },
        h('button', {
          type: 'button',
          class: 'quiet',
          text: 'Take the present pose',
          'data-testid': `step-${k + 1}-teach`,
          on: {
            click: () =>
              changeStep(k, { T: tool(), q: s.kind === 'joint' ? state.q.slice() : null }, `teach step ${k + 1}`),
          },
        }),
        s.q
          ? h('button', {
              type: 'button',
              class: 'quiet',
              text: 'Go there',
              on: { click: () => moveTo(s.q.slice(), 0.8, `go to step ${k + 1}`) },
            })
          : null,
      ),
    );
  }

  return editor;
}
