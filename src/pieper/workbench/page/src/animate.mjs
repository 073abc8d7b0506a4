// Moves that take time: from posture to posture, and along a list of postures.
import { state, setJoints, tell } from './store.mjs';

let mine = 0;
export function stop() {
  mine += 1;
  if (state.moving) {
    state.moving = false;
    tell('moving', false);
  }
}

/** Animated joint move to q, all joints together, quintic in time; resolves when there or when another move takes over. */
export function moveTo(q, seconds = 0.8, label = 'move to a posture') {
  stop();
  tell('let-go');
  tell('did', { label });
  const from = state.q.slice(),
    me = mine,
    began = performance.now();
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) seconds = 0;
  state.moving = true;
  tell('moving', true);
  return new Promise((done) => {
    (function go(now) {
      if (me !== mine || from.length !== state.q.length) {
        done(false);
        return;
      }
      const s = seconds > 0 ? Math.min(Math.max((now - began) / (1000 * seconds), 0), 1) : 1;
      const k = s ** 3 * (10 - 15 * s + 6 * s * s);
      setJoints(s < 1 ? from.map((v, i) => v + k * (q[i] - v)) : q.slice(), 'move');
      if (s < 1) requestAnimationFrame(go);
      else {
        state.moving = false;
        tell('moving', false);
        done(true);
      }
    })(began);
  });
}

/** A clock that runs a scrubber: at(position 0..1) is called each frame until the end or until stopped. */
export function play(seconds, from, at, ended) {
  stop();
  const me = mine,
    began = performance.now() - 1000 * seconds * from;
  state.moving = true;
  tell('moving', true);
  requestAnimationFrame(function go(now) {
    if (me !== mine) {
      ended?.(false);
      return;
    }
    const s = Math.min(Math.max((now - began) / (1000 * seconds), 0), 1);
    at(s);
    if (s < 1) requestAnimationFrame(go);
    else {
      state.moving = false;
      tell('moving', false);
      ended?.(true);
    }
  });
}
