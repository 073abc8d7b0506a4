// Asking for every solution of the target, at the speed of the hand: the newest target only, ghosts with every answer.
import { state, on, tell, setJoints, EDITED } from './store.mjs';
import { newestOnly } from './link.mjs';
import { askArm, moot } from './library.mjs';
import { showGhosts, showPreview } from './scene/arm.mjs';
import { isDragging } from './scene/gizmo.mjs';

export const options = { follow: true, ghosts: 'all', task: null, redundancy: null };
export const counts = { answers: 0 };

/** Whether the newest question comes of a person's hand on the target, which the arm follows. */
let edited = false;
const ask = newestOnly(async () => {
  const followed = edited;
  edited = false;
  const T = state.target,
    table = state.table;
  try {
    const brief = isDragging() || sliding;
    const digits = brief ? null : state.digits;
    const { task, redundancy } = options;
    const answer = await askArm('ik', { T, q: state.q, brief, task, redundancy, digits });
    // an answer to an older question is worth showing only while the hand is still moving
    if (table !== state.table || (T !== state.target && !brief)) return;
    counts.answers += 1;
    state.solutions = { ...answer, T, brief };
    if (followed && options.follow && answer.nearest) setJoints(answer.nearest, 'follow');
    drawGhosts();
    tell('solutions');
    if (!brief && !answer.rows.some((r) => r.inside)) findNearest(T);
    if (answer.self_motions === null && !brief) findSelfMotions(state.solutions);
  } catch (error) {
    if (moot(error)) return;
    state.solutions = { rows: [], self_motions: [], status: 'REFUSED', why: error.message, nearest: null };
    drawGhosts();
    tell('solutions');
  }
});

let sliding = false;
/** A spare coordinate is being slid: answers without words until the hand rests, which `solve` is told by. */
export function slide() {
  sliding = true;
  edited = true;
  ask();
}
/** Ask anew; the arm goes to the answer only when a person has just edited what is asked for. */
export function solve({ follow = false } = {}) {
  sliding = false;
  edited ||= follow;
  ask();
}

/** The self-motions of a redundant arm take longer than its solutions, which are shown meanwhile. */
const findSelfMotions = newestOnly(async (asked) => {
  try {
    const body = { T: asked.T, q: state.q, task: options.task, redundancy: options.redundancy };
    const { self_motions } = await askArm('self_motions', body);
    if (state.solutions !== asked || !self_motions) return;
    asked.self_motions = self_motions;
    tell('solutions');
  } catch {
    /* the solutions stand without them */
  }
});

const findNearest = newestOnly(async (T) => {
  try {
    const near = await askArm('nearest', { T, task: options.task });
    if (state.solutions && state.solutions.T === T) {
      state.solutions.near = near;
      tell('solutions');
    }
  } catch {
    /* the reason in words stands already */
  }
});

const close = (a, b) =>
  a.every((v, i) => Math.abs(Math.atan2(Math.sin(v - b[i]), Math.cos(v - b[i]))) < 1e-6 || Math.abs(v - b[i]) < 1e-9);
export function drawGhosts() {
  const rows = state.solutions?.rows ?? [];
  const wanted =
    state.panel === 'inverse' && options.ghosts !== 'none'
      ? rows.filter((r) => (options.ghosts === 'all' || r.inside) && !close(r.q, state.q))
      : [];
  showGhosts(wanted.map((r) => r.q));
}

export function begin() {
  on('target', (why) => {
    if (state.panel === 'inverse') solve({ follow: EDITED.has(why) });
  });
  on('task', () => {
    tell('plan');
    if (state.panel === 'inverse' && state.hasTarget) solve();
  });
  on('panel', (id) => {
    showPreview(null);
    if (id === 'inverse' && state.hasTarget && !state.solutions) solve();
    drawGhosts();
  });
  on('moving', (yes) => {
    if (!yes) drawGhosts();
  });
  on('table', (what) => {
    options.redundancy = null;
    if (what === 'new') options.task = null;
    tell('solutions');
    if (what !== 'new' && state.panel === 'inverse' && state.hasTarget) solve();
  });
  on('online', (yes) => {
    if (yes && state.panel === 'inverse' && state.hasTarget && state.table.joints.length) solve();
  });
}
