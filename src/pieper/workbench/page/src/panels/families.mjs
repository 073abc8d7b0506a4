// Self-motion: a slider along each continuous family of solutions.
import { h, replace } from '../dom.mjs';
import { state, setJoints } from '../store.mjs';
import { stop } from '../animate.mjs';
import { ontoPose } from '../kinematics.mjs';
import { options } from '../solving.mjs';

/** More families than this are listed on one line each. */
const FEW = 2;

/** A slider for each continuous family: the arm moves, the tool stands still. */
export function showFamilies(el, s) {
  const list = s?.families ?? [],
    task = options.task ?? state.plan?.task,
    exact = task === 'pose';
  // while the hand moves, the families of a redundant arm wait: what stands there keeps its place
  el.classList.toggle('stale', s?.families === null);
  for (const slider of el.querySelectorAll('input')) slider.disabled = s?.families === null;
  if (s?.families === null && el.childElementCount) return;
  const key = s?.families === null ? 'pending' : s?.families;
  if (el.drawn === key) return;
  el.drawn = key;
  if (key === 'pending') {
    replace(el, h('p', { class: 'hint', text: 'Following the families of this pose …' }));
    return;
  }
  const still =
    task === 'position'
      ? 'the tool point stands still'
      : task === 'pose'
        ? 'the tool stands still'
        : 'the tool point and its axis stand still';
  const form = (family) =>
    family.dimension > 1
      ? `one line in a surface of ${family.dimension} dimensions`
      : family.closed
        ? 'a closed curve'
        : 'an open curve';
  const many = list.length > FEW;
  replace(
    el,
    many
      ? h('p', {}, h('strong', { text: `${list.length} self-motions` }), `: the arm moves along each, ${still}.`)
      : null,
    list.map((family, k) => {
      const slider = along(family, k, s.T, exact);
      const outside = family.inside.length ? '' : 'All of it lies outside the limits.';
      if (many)
        return h(
          'div',
          { class: 'family short' },
          h('span', {
            title: outside,
            text: `${k + 1}, ${outside ? 'outside the limits' : family.dimension > 1 ? 'in a surface' : form(family)}`,
          }),
          slider,
        );
      const moves = family.moves.length > 3 ? 'most of its joints' : family.moves.join(' and ');
      return h(
        'div',
        { class: 'family' },
        h(
          'p',
          {},
          h('strong', { text: list.length > 1 ? `Self-motion ${k + 1} of ${list.length}` : 'Self-motion' }),
          ` by ${moves}, ${form(family)}: the arm moves, ${still}. ${outside}`,
        ),
        slider,
      );
    }),
  );
}

/** A slider that takes the arm along a family; where the pose is held in full, exactly onto it. */
function along(family, k, T, exact) {
  const slider = h('input', {
    type: 'range',
    min: '0',
    max: '1',
    step: 'any',
    value: '0',
    'aria-label': `Along family ${k + 1}`,
    'data-testid': `family-${k + 1}`,
  });
  const go = () => {
    stop();
    const at = Number(slider.value),
      i = Math.max(
        family.s.findLastIndex((v) => v <= at),
        0,
      ),
      j = Math.min(i + 1, family.q.length - 1);
    const f = j > i ? (at - family.s[i]) / (family.s[j] - family.s[i]) : 0;
    slider.style.setProperty('--at', `${100 * at}%`);
    const between = family.q[i].map((v, m) => v + f * (family.q[j][m] - v));
    setJoints(exact ? ontoPose(state.table, between, T) : between, 'family');
  };
  // the thumb begins where the arm is; the reddish parts of the track lie outside the limits
  const apart = (v) => v.reduce((sum, x, m) => sum + Math.sin((x - state.q[m]) / 2) ** 2, 0);
  slider.value = String(family.s[family.q.reduce((best, v, m) => (apart(v) < apart(family.q[best]) ? m : best), 0)]);
  slider.style.setProperty('--at', `${100 * Number(slider.value)}%`);
  if (family.inside.length === 1) {
    slider.style.setProperty('--lo', `${100 * family.inside[0][0]}%`);
    slider.style.setProperty('--hi', `${100 * family.inside[0][1]}%`);
  }
  slider.addEventListener('input', go);
  slider.addEventListener('keydown', (e) => {
    const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[e.key];
    if (!way) return;
    e.preventDefault();
    const next = Number(slider.value) + way / 100;
    // a closed curve goes round
    slider.value = String(family.closed ? next - Math.floor(next) : Math.min(Math.max(next, 0), 1));
    go();
  });
  return slider;
}
