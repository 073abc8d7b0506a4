// Over the picture, where the arm's file says how it looks: the sketch of its table, its looks, or both.
import { h, choice } from './dom.mjs';
import { state, on } from './store.mjs';
import { known, setLook } from './scene/looks.mjs';

export function lookChoice() {
  const which = choice(
    'The arm as',
    [
      ['sketch', 'Sketch'],
      ['real', 'Real'],
      ['both', 'Both'],
    ],
    state.look.mode,
    (mode) => setLook({ mode }),
    'look',
  );
  const opacity = h('input', {
    type: 'range',
    min: '0.1',
    max: '0.9',
    step: '0.05',
    value: String(state.look.opacity),
    'aria-label': 'How opaque the real arm is over the sketch',
    'data-testid': 'look-opacity',
    on: { input: () => setLook({ opacity: Number(opacity.value) }) },
  });
  const el = h('div', { class: 'group look', hidden: true }, which, opacity);
  const show = () => {
    el.hidden = !known();
    which.mark(state.look.mode);
    opacity.hidden = state.look.mode !== 'both';
    opacity.value = String(state.look.opacity);
  };
  on(['looks', 'look', 'table'], show);
  show();
  return el;
}
