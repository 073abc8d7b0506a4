// The Python library behind the page: it is told of every change of the table, and asked only about the newest one.
import { state, on, tell } from './store.mjs';
import { ask, Offline } from './link.mjs';
import { debounce } from './dom.mjs';
import { awaiting } from './late.mjs';

let version = 0,
  shape = 0,
  told = -1,
  waiters = [];

/** The table as the library takes it: without what only the page uses. */
export function bare(table) {
  return { ...table, joints: table.joints.map(({ text, ...j }) => j) };
}

/** What kind of arm it is, is known of the arm before; it is not said of this one for long. */
const wait = awaiting((late) => late && forget());
function forget() {
  state.plan = null;
  tell('plan');
}

async function tellArm() {
  const mine = version;
  if (!state.table.joints.length) {
    state.plan = { solvable: false, explain: 'The table is empty: add a joint.', max_solutions: 0 };
    wait(false);
    tell('plan');
    return;
  }
  try {
    const { plan } = await ask('arm', { table: bare(state.table) });
    if (mine !== version) return;
    told = mine;
    state.plan = plan;
    wait(false);
    settle();
  } catch (error) {
    if (mine !== version || error instanceof Offline) return;
    state.plan = { solvable: false, refused: true, explain: error.message, max_solutions: 0 };
    wait(false);
    settle(error);
  }
  tell('plan');
}
function settle(error) {
  const list = waiters;
  waiters = [];
  for (const { resolve, reject } of list)
    if (error) reject(error);
    else resolve();
}
const soon = debounce(tellArm, 60);

export function begin() {
  on('table', (what) => {
    version += 1;
    if (!['postures', 'name', 'gripper'].includes(what)) {
      shape += 1;
      if (what === 'new') forget();
      wait(true);
    }
    if (what === 'postures') told = -1;
    if (what === 'cell') soon();
    else {
      soon.cancel();
      tellArm();
    }
  });
  on('online', (yes) => {
    if (yes) {
      version += 1;
      tellArm();
    }
  });
}

/** Resolves when the library holds the table that the page shows. */
export function ready() {
  return told === version ? Promise.resolve() : new Promise((resolve, reject) => waiters.push({ resolve, reject }));
}
/** A number for what the arm is: an answer of another number is another arm's. Names and kept postures change nothing of it. */
export const armNumber = () => shape;
/** The arm was changed before the answer came. */
export class Passed extends Error {}
/** Nothing is to be said of these: there is nobody to answer, or the next question is on its way. */
export const moot = (error) => error instanceof Offline || error instanceof Passed;

/** Ask about the arm that the page shows; once it shows another one the answer is nobody's. `whichever`: it stands alone. */
export async function askArm(op, body, progress, { whichever = false } = {}) {
  const asked = shape;
  await ready();
  const got = await ask(op, body, progress);
  if (asked !== shape && !whichever) throw new Passed('The arm was changed meanwhile, so the answer is not shown.');
  return got;
}

/** How the arm is solved, for a line at the top: what the plan says after "Solved by:", else its first sentence. */
export function sentence(plan) {
  if (!plan) return '';
  const lines = plan.explain.split('\n').map((l) => l.trim()),
    by = lines.find((l) => l.startsWith('Solved by:'));
  const text = (by ?? lines.filter(Boolean)[0] ?? '').replace(/\s+/g, ' ');
  return by || text.length < 200 ? text : `${text.slice(0, 200)} …`;
}
export function countWords(plan) {
  if (!plan?.solvable) return '';
  const n = plan.max_solutions;
  return n === null || n === undefined ? '' : n === 1 ? 'One solution' : `Up to ${n} solutions`;
}
