// Beside Python: what a script says is shown at once, what a person does is told back.
import { state, on, tell, setTable, setTarget, setJoints } from './store.mjs';
import { ask } from './link.mjs';
import { bare } from './library.mjs';
import { atMostEvery } from './dom.mjs';
import { motionOf } from './curves.mjs';
import { programMessage } from './program.mjs';
import * as dock from './dock.mjs';
import * as looks from './scene/looks.mjs';

/** Milliseconds between two words to Python while a hand moves. */
const OFTEN = 40;
let beside = false,
  said = 0,
  listening = false,
  toldTable = null,
  toldWorld = [],
  toldProgram = 'null',
  shownMotion = null;

/** What a script that the page stands beside has to show when the page opens. */
export function open(bench) {
  if (!bench) return;
  beside = true;
  toldTable = state.table;
  take(bench);
  if (state.program.length || state.world.length) report.soon();
}
function take(push) {
  listening = true;
  said = push.said;
  if (push.table) {
    setTable(push.table, { q: push.q, what: 'new', label: 'open an arm from Python' });
    toldTable = state.table;
    looks.take(push.looks ?? null, push.table);
  }
  if (push.things) show(push.things);
  if (push.target) {
    state.hasTarget = true;
    setTarget(push.target, 'restored');
  }
  if (push.q && push.q.length === state.table.joints.length) {
    tell('did', { label: 'move from Python', key: 'python' });
    setJoints(push.q, 'python');
  }
  listening = false;
}
function show(things) {
  state.things = things.filter((t) => t.kind !== 'motion');
  tell('world', 'python');
  const motion = things.findLast((t) => t.kind === 'motion') ?? null;
  const mark = JSON.stringify(motion);
  if (mark === shownMotion) return;
  shownMotion = mark;
  if (!motion) {
    dock.show(null);
    return;
  }
  dock.show(
    motionOf({
      table: state.table,
      q: motion.q,
      xs: motion.t,
      xName: 'time',
      seconds: motion.t,
      title: `${state.table.name}: ${motion.name}`,
      events: motion.events.map(([t, kind, value]) => ({
        x: t,
        s: 0,
        text: `${kind} ${value} at ${t.toFixed(2)} s`,
        short: kind,
        stop: false,
      })),
    }),
  );
}

const report = atMostEvery(OFTEN, () => {
  if (!state.table.joints.length) return;
  const q = state.q,
    target = state.hasTarget ? state.target : null,
    program = state.program.length ? programMessage() : null,
    more = {},
    mark = JSON.stringify(program);
  if (state.table !== toldTable) more.table = bare(state.table);
  if (state.world !== toldWorld) more.world = state.world;
  if (mark !== toldProgram) more.program = program;
  [toldTable, toldWorld, toldProgram] = [state.table, state.world, mark];
  ask('shown', { q, target, said, ...more }).catch(() => {});
});

export function begin() {
  on('push', take);
  on(['q', 'target', 'table', 'program', 'world'], () => beside && !listening && report.soon());
}
