// Asking for every solution of the target, at the speed of the hand: the newest target only, ghosts with every answer.
import { state, on, tell, setJoints, EDITED } from './store.mjs';
import { newestOnly } from './link.mjs';
import { askArm, moot } from './library.mjs';
import { showGhosts, showPreview } from './scene/arm.mjs';
import { isDragging } from './scene/gizmo.mjs';
import { awaiting } from './late.mjs';

export const options = { follow: true, ghosts: 'all', task: null, redundancy: null };
export const counts = { answers: 0 };

let asked = 0, // how often the target was asked about
  heard = 0, // the newest of these questions whose answer is shown
  nearing = null; // the target whose nearest pose is looked for
/** Whether what is shown is the answer to the newest question. */
export const answered = () => state.solutions !== null && heard === asked;
/** Whether nothing more of that answer is on its way. */
export const settled = () =>
  answered() && !state.solutions.brief && state.solutions.self_motions !== null && nearing === null;
/** While the hand moves, every answer is worth showing; afterwards an old one is not shown beside a new question for long. */
const wait = awaiting(() => {
  drawGhosts();
  tell('late');
});
export const late = wait.late;

/** Whether the newest question comes of a person's hand on the target, which the arm follows. */
let edited = false;
const ask = newestOnly(async () => {
  const followed = edited;
  edited = false;
  const mine = asked,
    T = state.target,
    table = state.table;
  try {
    const brief = isDragging() || sliding;
    const digits = brief ? null : state.digits;
    const { task, redundancy } = options;
    const answer = await askArm('ik', { T, q: state.q, brief, task, redundancy, digits });
    // an answer to an older question is worth showing only while the hand is still moving
    if (table !== state.table || (T !== state.target && !brief)) return;
    counts.answers += 1;
    heard = mine;
    state.solutions = { ...answer, T, brief };
    wait(!answered() && !brief);
    if (followed && options.follow && answer.nearest) setJoints(answer.nearest, 'follow');
    drawGhosts();
    tell('solutions');
    if (!brief && !answer.rows.some((r) => r.inside)) findNearest((nearing = T));
    if (answer.self_motions === null && !brief) findSelfMotions(state.solutions);
  } catch (error) {
    if (moot(error)) return;
    heard = mine;
    state.solutions = { rows: [], self_motions: [], status: 'REFUSED', why: error.message, nearest: null };
    wait(!answered());
    drawGhosts();
    tell('solutions');
  }
});

let sliding = false;
/** A spare coordinate is being slid: answers without words until the hand rests, which `solve` is told by. */
export function slide() {
  sliding = true;
  edited = true;
  asked += 1;
  ask();
}
/** Ask anew; the arm goes to the answer only when a person has just edited what is asked for. */
export function solve({ follow = false } = {}) {
  sliding = false;
  edited ||= follow;
  asked += 1;
  if (!isDragging()) wait(true);
  tell('asked');
  ask();
}
/** What was asked is no longer what stands there: nothing is shown for it until it is asked. */
function outdate() {
  if (!state.solutions) return;
  state.solutions = null;
  tell('solutions');
}

/** The self-motions of a redundant arm take longer than its solutions, which are shown meanwhile. */
const findSelfMotions = newestOnly(async (asked) => {
  try {
    const body = { T: asked.T, q: state.q, task: options.task, redundancy: options.redundancy };
    const { self_motions } = await askArm('self_motions', body);
    if (state.solutions !== asked || !self_motions) return;
    asked.self_motions = self_motions;
    tell('solutions');
  } catch (error) {
    // the solutions stand without them
    if (moot(error) || state.solutions !== asked) return;
    asked.self_motions = [];
    asked.untraced = error.message;
    tell('solutions');
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
  } finally {
    if (nearing === T) nearing = null;
  }
});

const close = (a, b) =>
  a.every((v, i) => Math.abs(Math.atan2(Math.sin(v - b[i]), Math.cos(v - b[i]))) < 1e-6 || Math.abs(v - b[i]) < 1e-9);
export function drawGhosts() {
  const rows = state.solutions?.rows ?? [];
  const wanted =
    state.panel === 'inverse' && options.ghosts !== 'none' && !late()
      ? rows.filter((r) => (options.ghosts === 'all' || r.inside) && !close(r.q, state.q))
      : [];
  showGhosts(wanted.map((r) => r.q));
}

export function begin() {
  on('target', (why) => {
    if (state.panel === 'inverse') solve({ follow: EDITED.has(why) });
    else outdate();
  });
  on('task', () => {
    tell('plan');
    if (state.panel === 'inverse' && state.hasTarget) solve();
    else outdate();
  });
  on('panel', (id) => {
    showPreview(null);
    if (id === 'inverse' && state.hasTarget && !answered()) solve();
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
