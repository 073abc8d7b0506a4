// What happens while a motion plays: the gripper opens and closes, and what it closes on goes with the tool.
import { state, on } from './store.mjs';
import { frames } from './kinematics.mjs';
import { invert, mul, position, norm, sub } from './matrix.mjs';
import { carry, letAllGo } from './scene/world.mjs';
import { showGripper } from './scene/gripper.mjs';

/** Seconds in which the fingers go from open to closed; from this value on they hold. */
const CLOSING = 0.25,
  HOLDS = 0.5;

/** The story of a motion's gripper: [{t, value}], and of each object: [{t, T}] at rest or [{t, held}] in the tool. */
function storyOf(motion) {
  const grips = (motion.happens ?? []).filter(([, kind]) => kind === 'gripper').map(([t, , value]) => ({ t, value }));
  const objects = new Map(state.world.filter((o) => o.role === 'object').map((o) => [o.name, [{ t: -1, T: o.T }]]));
  let held = null,
    closed = false;
  for (const { t, value } of grips) {
    const tool = toolAt(motion, t);
    if (value >= HOLDS && !closed) {
      const near = [...objects]
        .map(([name, story]) => ({ name, T: story.at(-1).T, d: norm(sub(position(story.at(-1).T), position(tool))) }))
        .filter(({ name, d }) => d < grasp(state.world.find((o) => o.name === name)))
        .sort((a, b) => a.d - b.d)[0];
      if (near) {
        held = near.name;
        objects.get(held).push({ t, held: mul(invert(tool), near.T) });
      }
    } else if (value < HOLDS && closed && held) {
      objects.get(held).push({ t, T: mul(tool, objects.get(held).at(-1).held) });
      held = null;
    }
    closed = value >= HOLDS;
  }
  return { grips, objects };
}
/** How near the tool's point must be to an object to hold it: what the object measures, and a little. */
const grasp = (o) => 0.6 * Math.max(...(o.size ?? [2 * (o.r ?? 0), o.h ?? 0])) + 0.01;

function indexAt(t, time) {
  let lo = 0,
    hi = t.length - 1;
  while (lo < hi) {
    const mid = (lo + hi + 1) >> 1;
    if (t[mid] <= time + 1e-9) lo = mid;
    else hi = mid - 1;
  }
  return lo;
}
const toolAt = (motion, time) => frames(motion.table, motion.q[indexAt(motion.seconds, time)]).at(-1);

let story = null;
export const gripperAt = (time) => {
  let value = story.grips.length ? 1 - Math.round(story.grips[0].value) : 0;
  for (const g of story.grips) {
    if (g.t > time) break;
    const part = Math.min((time - g.t) / CLOSING, 1);
    value += part * (g.value - value);
  }
  return value;
};

export function begin() {
  on('motion', () => {
    letAllGo();
    story = state.motion?.happens ? storyOf(state.motion) : null;
    if (!story) showGripper(null);
  });
  on('played', (time) => {
    if (!story) return;
    const tool = state.frames.at(-1);
    if (story.grips.length) showGripper(gripperAt(time));
    for (const [name, list] of story.objects) {
      const now = list.findLast((e) => e.t <= time) ?? list[0];
      carry(name, now.held ? mul(tool, now.held) : now.T);
    }
  });
}
