// The line to the Python session: numbered messages, answers as promises, a new connection when the old one breaks.
import { state, tell } from './store.mjs';

let socket = null,
  seq = 0,
  wait = 250;
const waiting = new Map();
/** How many questions have no answer yet. */
export const underway = () => waiting.size;
let greeted = null;
/** What the session says first: version, catalogue, and the arm that a new page opens with. */
export const greeting = () => greeted;

export class Offline extends Error {}

function connect() {
  socket = new WebSocket(`${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/session`);
  socket.onopen = () => {
    seq = 0;
    wait = 250;
    state.online = true;
    // asked before anybody waits for it, so that it is there when the rest of the page is
    greeted = ask('hello', { wants_arm: true });
    greeted.catch(() => {});
    tell('online', true);
  };
  socket.onmessage = ({ data }) => {
    const m = JSON.parse(data);
    if (m.push) {
      tell('push', m.push);
      return;
    }
    const entry = waiting.get(m.seq);
    if (!entry) return;
    if (m.ok && m.progress) {
      entry.progress?.(m);
      return;
    }
    waiting.delete(m.seq);
    if (m.ok) entry.resolve(m);
    else entry.reject(new Error(m.error));
  };
  socket.onclose = ({ reason }) => {
    if (state.online) {
      state.online = false;
      tell('online', false);
    }
    for (const { reject } of waiting.values()) reject(new Offline(reason || 'the server is away'));
    waiting.clear();
    setTimeout(connect, wait);
    wait = Math.min(wait * 1.6, 3000);
  };
}
export const start = connect;

/** Ask the session; progress hears the pieces of long work. */
export function ask(op, body = {}, progress) {
  if (socket?.readyState !== WebSocket.OPEN) return Promise.reject(new Offline('the server is away'));
  return new Promise((resolve, reject) => {
    const n = ++seq;
    waiting.set(n, { resolve, reject, progress });
    socket.send(JSON.stringify({ op, seq: n, ...body }));
  });
}

/** Ask for the newest thing only: one question under way, the latest waiting, everything between dropped. */
export function newestOnly(run) {
  let busy = false,
    next = null;
  return async function go(...args) {
    if (busy) {
      next = args;
      return;
    }
    busy = true;
    try {
      await run(...args);
    } finally {
      busy = false;
      if (next) {
        const a = next;
        next = null;
        go(...a);
      }
    }
  };
}
