// A route: what of the tool's orientation is left free along the line, at which ends it is held, and what was found.
import { state, tell } from './store.mjs';

/** What is asked of a route before anybody says otherwise: SI. `turn` is null for all the way round, or [lo, hi]. */
export const usualRouting = () => ({
  turn: null,
  cone: 0,
  axis: 'z',
  cost: 'motion',
  singularity: 0,
  clearance: 0,
  start: null, // {turn, q, branch} where a hand has put the curve's first point
  end: null,
});
export const routing = () => state.routing ?? usualRouting();

/** Ask for something else of the route; a step of the history. */
export function setRouting(change, label, key = label) {
  tell('did', { label, key });
  state.routing = { ...routing(), ...change };
  tell('routing');
}

/** What is free, as the library takes it. */
export const freedom = () => {
  const r = routing();
  return { turn: r.turn ?? 'free', cone: r.cone, axis: r.axis };
};
/** The route as the library takes it. */
export function routeMessage() {
  const r = routing(),
    P = state.path,
    obstacles = state.world.some((t) => t.role !== 'object' && t.kind !== 'frame');
  return {
    T0: P.from,
    T1: P.to,
    n: P.n,
    free: freedom(),
    cost: r.cost,
    singularity: r.singularity,
    start: r.start?.q ?? null,
    end: r.end?.q ?? null,
    world: state.world,
    clearance: obstacles ? r.clearance : 0,
  };
}

/** The open cells of a branch, station after station, turn after turn, out of their bits. */
export function cellsOf(map, b) {
  const bytes = Uint8Array.from(atob(map.open[b]), (c) => c.charCodeAt(0));
  return (i, k) => {
    const at = i * map.turn.length + k;
    return (bytes[at >> 3] >> (7 - (at & 7))) & 1;
  };
}
/** Whether a map goes all the way round: its last turn lies beside its first. */
export const isRound = (map) => {
  const step = map.turn[1] - map.turn[0];
  return Math.abs(step * map.turn.length - 2 * Math.PI) < 1e-6;
};
/** The branches that are open at a station and a turn (rad). */
export function openAt(map, s, turn) {
  const step = map.turn[1] - map.turn[0],
    n = map.turn.length;
  let k = Math.round((turn - map.turn[0]) / step);
  if (isRound(map)) k = ((k % n) + n) % n;
  if (k < 0 || k >= n) return [];
  const i = Math.round(s * (map.s.length - 1));
  return map.branches.filter((_, b) => cellsOf(map, b)(i, k));
}
