// Self-motion: a slider along each continuous set of solutions.
import { h, replace } from '../dom.mjs';
import { state, setJoints, tell } from '../store.mjs';
import { shortest } from '../turns.mjs';
import { stop } from '../animate.mjs';
import { ontoPose } from '../kinematics.mjs';
import { options } from '../solving.mjs';

/** A slider along the self-motion on which the arm is, which moves and leaves the tool still; the others are folded away. */
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
  const { open: unfolded } = el.querySelector('details') ?? el.was ?? {}; // by the person who looks at them
  el.was = { open: unfolded };
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
  const line = (motion, k) => {
    const moves = motion.moves.length > 3 ? 'most of its joints' : motion.moves.join(' and ');
    const outside = motion.inside.length ? partsOf(motion) : 'All of it lies outside the limits.';
    return h(
      'div',
      { class: 'self-motion' },
      h(
        'p',
        {},
        h('strong', { text: list.length > 1 ? `Self-motion ${k + 1} of ${list.length}` : 'Self-motion' }),
        ` by ${moves}, ${form(motion)}: the arm moves, ${still}. ${outside}`,
      ),
      along(motion, k, s.T, exact),
    );
  };
  const here = list.length ? nearestOf(list) : -1;
  el.here = here;
  const others = list.map((motion, k) => (k === here ? null : line(motion, k))).filter(Boolean);
  const fold = others.length
    ? h(
        'details',
        { class: 'fold', open: unfolded },
        h('summary', { text: others.length === 1 ? 'One other self-motion' : `${others.length} other self-motions` }),
        others,
      )
    : null;
  const untraced = s?.untraced
    ? h('p', { class: 'hint', text: `The self-motions are not known: ${s.untraced}` })
    : null;
  replace(el, here >= 0 ? line(list[here], here) : null, fold, untraced);
}

/** The arm went elsewhere: the thumbs go where it is, and the self-motion on which it is now comes first. */
export function followArm(el, s) {
  const list = s?.self_motions;
  if (!list?.length || el.drawn !== list || state.q.length !== list[0].q[0].length) return;
  if (nearestOf(list) !== el.here) {
    el.drawn = null;
    showSelfMotions(el, s);
    return;
  }
  for (const slider of el.querySelectorAll('input')) slider.stand();
}

const apart = (v) => v.reduce((sum, x, m) => sum + Math.sin((x - state.q[m]) / 2) ** 2, 0);
/** The self-motion on which the arm stands: the one whose points come nearest to its posture. */
const nearestOf = (list) => {
  const least = list.map((motion) => Math.min(...motion.q.map(apart)));
  return least.indexOf(Math.min(...least));
};
/** The place on a self-motion nearest to the arm's posture, between its points too. */
function whereOn(motion) {
  const short = (a, b) =>
    a.map((v, m) =>
      state.table.joints[m]?.type === 'P' ? v - b[m] : Math.atan2(Math.sin(v - b[m]), Math.cos(v - b[m])),
    );
  let best = motion.s[0],
    least = Infinity;
  for (let i = 0; i + 1 < motion.q.length; i++) {
    const way = short(motion.q[i + 1], motion.q[i]),
      to = short(state.q, motion.q[i]);
    const d = way.reduce((sum, v) => sum + v * v, 0);
    const f = d > 0 ? Math.min(Math.max(way.reduce((sum, v, m) => sum + v * to[m], 0) / d, 0), 1) : 0;
    const miss = way.reduce((sum, v, m) => sum + (to[m] - f * v) ** 2, 0);
    if (miss < least) [least, best] = [miss, motion.s[i] + f * (motion.s[i + 1] - motion.s[i])];
  }
  return best;
}
const partsOf = ({ inside }) =>
  inside.length === 1 && inside[0][0] <= 1e-9 && inside[0][1] >= 1 - 1e-9
    ? ''
    : `Inside the limits: ${inside.map(([a, b]) => `${(100 * a).toFixed(1)} to ${(100 * b).toFixed(1)} %`).join(', ')} of it.`;
/** A track that shows which parts of it lie inside the limits, the rest reddish. */
function trackOf(inside) {
  const stops = [];
  let at = 0;
  for (const [a, b] of inside) {
    stops.push(`var(--wrong-soft) ${100 * at}% ${100 * a}%`, `var(--good) ${100 * a}% ${100 * b}%`);
    at = b;
  }
  stops.push(`var(--wrong-soft) ${100 * at}% 100%`);
  return `linear-gradient(to right, ${stops.join(', ')})`;
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
    tell('did', { label: 'slide along a self-motion', key: 'self-motion' });
    setJoints(shortest(exact ? ontoPose(state.table, between, T) : between), 'self-motion');
  };
  // the thumb is where the arm is; the reddish parts of the track lie outside the limits
  slider.stand = () => {
    slider.value = String(whereOn(motion));
    slider.style.setProperty('--at', `${100 * Number(slider.value)}%`);
  };
  slider.stand();
  slider.classList.add('parts');
  slider.style.setProperty('--parts', trackOf(motion.inside));
  slider.dataset.inside = JSON.stringify(motion.inside);
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
