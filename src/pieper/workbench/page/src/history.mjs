// One history of everything a person does: the arm, the joints, the target, the path, the program, the world; each step with its name.
import { state, on, tell, setTable, setTarget, setJoints } from './store.mjs';
import { options } from './solving.mjs';
import { stop } from './animate.mjs';
import { say } from './dom.mjs';

const DEPTH = 200;
/** Milliseconds within which the same hand on the same thing goes on with one step. */
const ONE_MOVE = 1500;
const past = [],
  future = [];
let present = null,
  last = { key: null, at: 0, open: false },
  asked = false;

/** Tables, postures and targets are replaced and never written into, so that a snapshot is a few references. */
const snapshot = () => ({
  table: state.table,
  q: state.q,
  target: state.target,
  digits: state.digits,
  hasTarget: state.hasTarget,
  path: { ...state.path },
  sequence: structuredClone(state.sequence),
  program: state.program,
  world: state.world,
  limits: state.limits,
  start: state.start,
  routing: state.routing,
  task: options.task,
  redundancy: options.redundancy,
});
/** What follows from an action (the arm that follows its target) belongs to it. */
function refresh() {
  if (asked) return;
  asked = true;
  queueMicrotask(() => {
    asked = false;
    present = snapshot();
  });
}

let whole = null; // the step that everything belongs to that is done meanwhile
/** Everything that happens in f is one step. */
export function asOne(label, f) {
  letGo();
  whole = { label, open: true };
  try {
    f();
  } finally {
    whole = null;
    letGo();
  }
}
/** A person did something: `key` names what the hand is on, `open` says that it stays on it until told otherwise. */
function did(said) {
  // what names no thing that a hand is on (a button) is a step each time
  const { label, key = Symbol(label), open = false } = whole ? { ...whole, key: whole } : said;
  const now = performance.now();
  const same = key === last.key && (last.open || now - last.at < ONE_MOVE);
  if (!same && present) {
    past.push({ label, before: present });
    if (past.length > DEPTH) past.shift();
    future.length = 0;
  }
  last = { key, at: now, open };
  refresh();
  tell('history');
}
/** The hand let go: what comes next is a step of its own. */
export function letGo() {
  if (whole) return;
  last = { key: null, at: 0, open: false };
}

function take(s) {
  stop();
  letGo();
  options.task = s.task;
  if (s.table !== state.table) setTable(s.table, { q: s.q, step: false, what: 'undo' });
  else setJoints(s.q, 'undo');
  options.redundancy = s.redundancy;
  Object.assign(state.path, s.path);
  state.sequence = structuredClone(s.sequence);
  state.program = s.program;
  state.world = s.world;
  state.limits = s.limits;
  state.start = s.start;
  const rerouted = state.routing !== s.routing;
  state.routing = s.routing;
  state.hasTarget = s.hasTarget;
  if (s.target !== state.target) setTarget(s.target, 'restored', s.digits);
  for (const topic of ['path-loaded', 'sequence-loaded', 'program', 'world', 'task']) tell(topic, 'undo');
  if (rerouted) tell('routing', 'undo');
}
function step(from, to, word) {
  const entry = from.pop();
  if (!entry) return;
  const now = snapshot();
  take(entry.before);
  to.push({ label: entry.label, before: now });
  refresh();
  tell('history');
  say(`${word}: ${entry.label}`);
}
export const undo = () => step(past, future, 'Undone');
export const redo = () => step(future, past, 'Redone');
export const toUndo = () => past.at(-1)?.label ?? null;
export const toRedo = () => future.at(-1)?.label ?? null;
export function forgetHistory() {
  past.length = 0;
  future.length = 0;
  letGo();
  present = snapshot();
  tell('history');
}

export function begin() {
  present = snapshot();
  on('did', did);
  on('let-go', letGo);
  // a panel that opens may fill in what nobody has said yet: that is no step, and it is there from then on
  on(['table', 'q', 'target', 'path', 'sequence', 'program', 'world', 'task', 'routing', 'panel'], refresh);
}
