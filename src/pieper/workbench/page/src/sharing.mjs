// The whole state of the page as one small object: in the address, in a file, and back, with nothing taken on trust.
import { state, on, tell, setTable, setTarget, setJoints } from './store.mjs';
import { forgetHistory, letGo } from './history.mjs';
import { units } from './units.mjs';
import { notations } from './rotation.mjs';
import { rotationDefect, identity, nearestRotation } from './matrix.mjs';
import { setTheme } from './theme.mjs';
import { debounce, say } from './dom.mjs';
import { giveUpUnread } from './numberfield.mjs';
import { cameraState, setCamera } from './scene/view.mjs';
import { options } from './solving.mjs';

const VERSION = 1,
  MOST_JOINTS = 30;

export function snapshot() {
  const { table, q, target, hasTarget, notation, shownFrames, path, sequence, panel, theme } = state;
  return {
    pieper: VERSION,
    table,
    q,
    target: hasTarget ? target : null,
    digits: hasTarget ? state.digits : null,
    task: options.task,
    redundancy: options.redundancy,
    follow: options.follow,
    ghosts: options.ghosts,
    notation,
    frames: shownFrames,
    path,
    sequence,
    program: { steps: state.program, start: state.start, limits: state.limits },
    world: state.world,
    routing: state.routing,
    look: state.look,
    panel,
    theme,
    units: [units.angle, units.length],
    camera: cameraState(),
  };
}

// ---- reading: every value is checked, what is wrong is left out or refused as a whole
const isNumber = (v) => typeof v === 'number' && Number.isFinite(v) && Math.abs(v) < 1e7;
const numbers = (v, n) => Array.isArray(v) && v.length === n && v.every(isNumber);
const text = (v, most) => (typeof v === 'string' ? v.slice(0, most) : '');
/** A pose to the last bit, or the nearest one to a rounded one, or null. */
const pose = (v) => {
  if (!numbers(v, 16)) return null;
  const defect = rotationDefect(v);
  return defect < 1e-12 ? v.slice() : defect < 1e-3 ? nearestRotation(v) : null;
};
const digits = (d) =>
  d && isNumber(d.metres) && isNumber(d.radians) ? { metres: d.metres, radians: d.radians } : null;
const actuator = (a) =>
  a && [a.lower, a.upper, a.value].every(isNumber) && a.lower <= a.upper
    ? { name: text(a.name, 40), lower: a.lower, upper: a.upper, value: a.value, unit: text(a.unit, 10) }
    : null;

/** The square of numbers that couples the joints, or null for joints that each move their own row. */
const coupling = (c, n) => (Array.isArray(c) && c.length === n && c.every((row) => numbers(row, n)) ? c : null);

function tableFrom(t) {
  if (
    !t ||
    !Array.isArray(t.joints) ||
    t.joints.length > MOST_JOINTS ||
    !['standard', 'modified'].includes(t.convention)
  )
    return null;
  const joints = t.joints.map((j, i) => {
    if (
      !j ||
      !['a', 'alpha', 'd', 'theta', 'offset'].every((k) => isNumber(j[k])) ||
      !['R', 'P'].includes(j.type) ||
      ![1, -1].includes(j.sign)
    )
      return null;
    const typed = Object.fromEntries(
      Object.entries(j.text ?? {}).filter(([, v]) => typeof v === 'string' && v.length < 80),
    );
    return {
      name: text(j.name, 40) || `joint_${i + 1}`,
      type: j.type,
      a: j.a,
      alpha: j.alpha,
      d: j.d,
      theta: j.theta,
      lower: isNumber(j.lower) ? j.lower : null,
      upper: isNumber(j.upper) ? j.upper : null,
      sign: j.sign,
      offset: j.offset,
      text: typed,
    };
  });
  if (joints.includes(null)) return null;
  const postures = Object.fromEntries(
    Object.entries(t.postures ?? {})
      .filter(([, v]) => numbers(v, joints.length))
      .slice(0, 40),
  );
  return {
    name: text(t.name, 60),
    convention: t.convention,
    joints,
    base: pose(t.base) ?? identity(),
    tool: pose(t.tool) ?? identity(),
    postures,
    manufacturer: text(t.manufacturer, 200),
    source: text(t.source, 2000),
    notes: text(t.notes, 3000),
    actuator: actuator(t.actuator),
    catalog: text(t.catalog, 60) || undefined,
    derived: text(t.derived, 60) || undefined,
    coupling: coupling(t.coupling, joints.length),
  };
}

const STEPS = {
  joint: 0,
  line: 0,
  circle: 0,
  spline: 0,
  frame: 0,
  call: 0,
  wait: 'seconds',
  gripper: 'value',
  output: 'port',
};
function stepFrom(x, n) {
  if (!x || !Object.hasOwn(STEPS, x.kind)) return null;
  const key = STEPS[x.kind];
  if (key)
    return isNumber(x[key])
      ? { kind: x.kind, [key]: x[key], ...(x.kind === 'output' ? { value: Boolean(x.value) } : {}) }
      : null;
  if (x.kind === 'call')
    return [x.first, x.last, x.times].every((v) => Number.isInteger(v) && v >= 1 && v <= 200)
      ? { kind: 'call', first: x.first, last: x.last, times: Math.min(x.times, 50) }
      : null;
  if (x.kind === 'frame') return pose(x.T) ? { kind: 'frame', T: pose(x.T) } : null;
  const q = x.kind === 'joint' && numbers(x.q, n) ? x.q.slice() : null,
    T = pose(x.T);
  const centre = x.kind === 'circle' && numbers(x.centre, 3) ? x.centre.slice() : null;
  if (!T || (x.kind === 'circle' && !centre && !pose(x.via))) return null;
  const through = x.kind === 'spline' && Array.isArray(x.through) ? x.through.slice(0, 100).map(pose) : null;
  if (x.kind === 'spline' && (!through?.length || through.includes(null))) return null;
  const some = (key, v) => (v === null ? {} : { [key]: v });
  return {
    kind: x.kind,
    ...some('q', q),
    T,
    ...some('via', pose(x.via)),
    ...some('through', through),
    ...(centre ? { centre, long_way: Boolean(x.long_way) } : {}),
    ...some('speed', isNumber(x.speed) && x.speed > 0 ? x.speed : null),
    blend: isNumber(x.blend) && x.blend >= 0 ? x.blend : 0,
  };
}
const BODIES = { frame: [], box: ['size'], cylinder: ['r', 'h'] };
function thingFrom(x) {
  if (!x || !Object.hasOwn(BODIES, x.kind)) return null;
  const T = pose(x.T),
    name = text(x.name, 40);
  const good = (k) => (k === 'size' ? numbers(x.size, 3) && x.size.every((v) => v > 0) : isNumber(x[k]) && x[k] > 0);
  if (!T || !name || !BODIES[x.kind].every(good)) return null;
  return {
    kind: x.kind,
    name,
    T,
    role: x.role === 'object' ? 'object' : 'obstacle',
    ...Object.fromEntries(BODIES[x.kind].map((k) => [k, x[k]])),
  };
}
/** What is asked of a route, each value checked; null for the usual. */
function routingFrom(r, n) {
  if (!r || typeof r !== 'object') return null;
  const end = (e) =>
    e && isNumber(e.turn) && numbers(e.q, n) ? { turn: e.turn, q: e.q.slice(), branch: text(e.branch, 80) } : null;
  const size = (v, most) => (isNumber(v) && v >= 0 && v < most ? v : 0);
  return {
    turn: numbers(r.turn, 2) ? r.turn.slice() : null,
    cone: size(r.cone, Math.PI / 2),
    axis: ['x', 'y', 'z'].includes(r.axis) ? r.axis : 'z',
    cost: r.cost === 'time' ? 'time' : 'motion',
    singularity: size(r.singularity, 1),
    clearance: size(r.clearance, 1e3),
    start: end(r.start),
    end: end(r.end),
  };
}
function restoreProgram(s, n) {
  const list = (v, f, most) => (Array.isArray(v) ? v.slice(0, most).map(f).filter(Boolean) : []);
  const p = s.program ?? {};
  state.program = list(p.steps, (x) => stepFrom(x, n), 200);
  state.start = numbers(p.start, n) ? p.start.slice() : null;
  state.limits = Object.fromEntries(
    Object.entries(p.limits ?? {}).filter(([k, v]) => k.length < 30 && (v === null || (isNumber(v) && v > 0))),
  );
  state.world = list(s.world, thingFrom, 60);
  state.routing = routingFrom(s.routing, n);
  if (['sketch', 'real', 'both'].includes(s.look?.mode) && isNumber(s.look.opacity))
    state.look = { mode: s.look.mode, opacity: Math.min(Math.max(s.look.opacity, 0.1), 0.9) };
}

/** Take a state; throws with the reason when it is not one of ours. With a label it is a step of the history, else its begin. */
export function restore(s, showPanel, label = null) {
  const table = s && s.pieper === VERSION ? tableFrom(s.table) : null;
  if (!table) throw new Error('This is not a state of the workbench.');
  const n = table.joints.length;
  if (label) tell('did', { label });
  giveUpUnread(document);
  if (Array.isArray(s.units)) {
    units.set('angle', s.units[0]);
    units.set('length', s.units[1]);
  }
  if (Object.hasOwn(notations, s.notation)) state.notation = s.notation;
  if (['auto', 'light', 'dark'].includes(s.theme)) setTheme(s.theme);
  state.shownFrames = Array.isArray(s.frames)
    ? s.frames.filter((i) => Number.isInteger(i) && i >= 0 && i < n + 2)
    : null;
  const p = s.path ?? {};
  setTable(table, { q: numbers(s.q, n) ? s.q : null, step: false, what: 'new' });
  Object.assign(state.path, {
    from: pose(p.from),
    to: pose(p.to),
    n: Number.isInteger(p.n) && p.n >= 2 && p.n <= 2000 ? p.n : 50,
    seconds: isNumber(p.seconds) && p.seconds > 0 ? p.seconds : 5,
  });
  state.sequence.postures = (Array.isArray(s.sequence?.postures) ? s.sequence.postures : [])
    .filter((x) => x && numbers(x.q, n) && isNumber(x.seconds) && isNumber(x.hold))
    .slice(0, 40)
    .map((x) => ({ name: text(x.name, 20) || 'P', q: x.q.slice(), seconds: x.seconds, hold: x.hold }));
  restoreProgram(s, n);
  if (['pose', 'position', 'position+axis'].includes(s.task)) options.task = s.task;
  const held = Object.entries(s.redundancy ?? {}).filter(([name, v]) => name.length < 80 && isNumber(v));
  options.redundancy = held.length ? Object.fromEntries(held.slice(0, MOST_JOINTS)) : null;
  if (typeof s.follow === 'boolean') options.follow = s.follow;
  if (['all', 'inside', 'none'].includes(s.ghosts)) options.ghosts = s.ghosts;
  const target = pose(s.target);
  state.hasTarget = Boolean(target);
  if (target) setTarget(target, 'restored', digits(s.digits));
  for (const topic of ['units', 'notation', 'sequence-loaded', 'task', 'program', 'world']) tell(topic);
  showPanel(s.panel);
  tell('path-loaded');
  tell('routing', 'loaded');
  tell('look', 'loaded');
  if (numbers(s.camera, 6)) setCamera(s.camera);
  setJoints(state.q, 'restored');
  if (label) letGo();
  else forgetHistory();
}

// ---- the address
async function squeeze(bytes, Stream) {
  return new Uint8Array(
    await new Response(new Blob([bytes]).stream().pipeThrough(new Stream('deflate-raw'))).arrayBuffer(),
  );
}
export async function link() {
  const packed = await squeeze(new TextEncoder().encode(JSON.stringify(snapshot())), CompressionStream);
  const base64 = btoa(String.fromCharCode(...packed))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replace(/=+$/, '');
  return `${location.origin}${location.pathname}#s=${base64}`;
}
export const fromAddress = async () => leftBehind() ?? (await read(location.hash));
/** The state that an address holds behind its #, null where it holds none. */
async function read(hash) {
  const m = /^#s=([\w-]+)$/.exec(hash);
  if (!m) return null;
  if (m[1].length > 60_000) throw new Error('The link is too long.');
  const bytes = Uint8Array.from(atob(m[1].replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
  const plain = await squeeze(bytes, DecompressionStream);
  if (plain.length > 500_000) throw new Error('The link unfolds to more than it should.');
  return JSON.parse(new TextDecoder().decode(plain));
}

const DRAWER = 'pieper-workbench';
/** What this very tab showed when it was left, to the last digit, if its address is still the same. */
function leftBehind() {
  try {
    const { address, shown } = JSON.parse(sessionStorage.getItem(DRAWER) ?? '{}');
    return shown && address === location.href ? shown : null;
  } catch {
    return null;
  }
}
function leave() {
  if (!state.table.joints.length) return;
  try {
    sessionStorage.setItem(DRAWER, JSON.stringify({ address: location.href, shown: snapshot() }));
  } catch {
    /* the address has it but for the last moment */
  }
}

let last = null,
  changes = 0,
  kept = 0;
/** Whether the address holds what the page shows. */
export const addressed = () => kept === changes;
const keepSoon = debounce(async () => {
  const mine = changes;
  const url = state.table.joints.length ? await link() : last;
  if (url !== last) {
    last = url;
    history.replaceState(null, '', url);
  }
  kept = mine;
}, 600);
function keep() {
  changes += 1;
  keepSoon();
}
/** A link put into the address of an open page, and the browser's back and forward, change only what is behind the #. */
async function follow(showPanel) {
  if (location.href === last) return;
  try {
    const s = await read(location.hash);
    if (s) restore(s, showPanel, 'open a link');
  } catch (error) {
    say(`The link could not be read: ${error.message}`, 'wrong');
  }
}
/** Keep the address in step with the page, so that reloading or bookmarking loses nothing. */
export function begin(showPanel) {
  addEventListener('pagehide', leave);
  addEventListener('hashchange', () => follow(showPanel));
  on(
    [
      'table',
      'q',
      'target',
      'solutions',
      'units',
      'notation',
      'panel',
      'path',
      'sequence',
      'program',
      'world',
      'routing',
      'look',
      'theme',
      'frames',
    ],
    keep,
  );
}
