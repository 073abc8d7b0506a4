// Self-motion: a slider along each continuous set of solutions.
import { h, replace } from '../dom.mjs';
import { state, setJoints } from '../store.mjs';
import { stop } from '../animate.mjs';
import { ontoPose } from '../kinematics.mjs';
import { options } from '../solving.mjs';

/** More self-motions than this are listed on one line each. */
const FEW = 2;

/** A slider for each self-motion: the arm moves, the tool stands still. */
export function showSelfMotions(el, s) {
  const list = s?.self_motions ?? [],
    task = options.task ?? state.plan?.task,
    exact = task === 'pose';
  // while the hand moves, the self-motions of a redundant arm wait: what stands there keeps its place
  el.classList.toggle('stale', s?.self_motions === null);
  for (const slider of el.querySelectorAll('input')) slider.disabled = s?.self_motions === null;
  if (s?.self_motions === null && el.childElementCount) return;
  const key = s?.self_motions === null ? 'pending' : s?.self_motions;
  if (el.drawn === key) return;
  el.drawn = key;
  if (key === 'pending') {
    replace(el, h('p', { class: 'hint', text: 'Following the self-motions of this pose …' }));
    return;
  }
  const still =
    task === 'position'
      ? 'the tool point stands still'
      : task === 'pose'
        ? 'the tool stands still'
        : 'the tool point and its axis stand still';
  const form = (motion) =>
    motion.dimension > 1
      ? `one line in a surface of ${motion.dimension} dimensions`
      : motion.closed
        ? 'a closed curve'
        : 'an open curve';
  const many = list.length > FEW;
  replace(
    el,
    many
      ? h('p', {}, h('strong', { text: `${list.length} self-motions` }), `: the arm moves along each, ${still}.`)
      : null,
    list.map((motion, k) => {
      const slider = along(motion, k, s.T, exact);
      const outside = motion.inside.length ? '' : 'All of it lies outside the limits.';
      if (many)
        return h(
          'div',
          { class: 'self-motion short' },
          h('span', {
            title: outside,
            text: `${k + 1}, ${outside ? 'outside the limits' : motion.dimension > 1 ? 'in a surface' : form(motion)}`,
          }),
          slider,
        );
      const moves = motion.moves.length > 3 ? 'most of its joints' : motion.moves.join(' and ');
      return h(
        'div',
        { class: 'self-motion' },
        h(
          'p',
          {},
          h('strong', { text: list.length > 1 ? `Self-motion ${k + 1} of ${list.length}` : 'Self-motion' }),
          ` by ${moves}, ${form(motion)}: the arm moves, ${still}. ${outside}`,
        ),
        slider,
      );
    }),
  );
}

/** A slider that takes the arm along a self-motion; where the pose is held in full, exactly onto it. */
function along(motion, k, T, exact) {
  const slider = h('input', {
    type: 'range',
    min: '0',
    max: '1',
    step: 'any',
    value: '0',
    'aria-label': `Along self-motion ${k + 1}`,
    'data-testid': `self-motion-${k + 1}`,
  });
  const go = () => {
    stop();
    const at = Number(slider.value),
      i = Math.max(
        motion.s.findLastIndex((v) => v <= at),
        0,
      ),
      j = Math.min(i + 1, motion.q.length - 1);
    const f = j > i ? (at - motion.s[i]) / (motion.s[j] - motion.s[i]) : 0;
    slider.style.setProperty('--at', `${100 * at}%`);
    const between = motion.q[i].map((v, m) => v + f * (motion.q[j][m] - v));
    setJoints(exact ? ontoPose(state.table, between, T) : between, 'self-motion');
  };
  // the thumb begins where the arm is; the reddish parts of the track lie outside the limits
  const apart = (v) => v.reduce((sum, x, m) => sum + Math.sin((x - state.q[m]) / 2) ** 2, 0);
  slider.value = String(motion.s[motion.q.reduce((best, v, m) => (apart(v) < apart(motion.q[best]) ? m : best), 0)]);
  slider.style.setProperty('--at', `${100 * Number(slider.value)}%`);
  if (motion.inside.length === 1) {
    slider.style.setProperty('--lo', `${100 * motion.inside[0][0]}%`);
    slider.style.setProperty('--hi', `${100 * motion.inside[0][1]}%`);
  }
  slider.addEventListener('input', go);
  slider.addEventListener('keydown', (e) => {
    const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[e.key];
    if (!way) return;
    e.preventDefault();
    const next = Number(slider.value) + way / 100;
    // a closed curve goes round
    slider.value = String(motion.closed ? next - Math.floor(next) : Math.min(Math.max(next, 0), 1));
    go();
  });
  return slider;
}
