// The map of path and turn: what is open on each branch, the curve that was chosen, where it is shut; its ends are dragged.
import { h, perFrame, setText } from './dom.mjs';
import { colours } from './theme.mjs';
import { units, show as shown, showUnit } from './units.mjs';
import { cellsOf, isRound, openAt } from './routing.mjs';

const DEG = Math.PI / 180;
/** Room for the words of the axes, rem. */
const LEFT = 3.4,
  BOTTOM = 2.1,
  TOP = 0.5,
  RIGHT = 0.9;

/**
 * @param drag called with ('start' | 'end', turn rad) while a hand holds an end
 * @param drop called the same way when it lets go
 * @param scrub called with s, 0 to 1, when a place of the path is pointed at
 */
export function routeMap({ drag, drop, scrub }) {
  const canvas = h('canvas', { 'aria-hidden': 'true' });
  const now = h('div', { class: 'route-now', hidden: true });
  const word = h('div', { class: 'route-word', hidden: true, 'data-testid': 'route-word' });
  const ends = ['start', 'end'].map((which) =>
    h('div', {
      class: `route-end ${which}`,
      role: 'slider',
      tabindex: '0',
      'aria-orientation': 'vertical',
      'aria-label': which === 'start' ? 'Turn of the tool where the route begins' : 'Turn of the tool where it ends',
      'data-testid': `route-${which}`,
      hidden: true,
    }),
  );
  const el = h('div', { class: 'route-map', 'data-testid': 'route-map' }, canvas, now, ...ends, word);
  let route = null,
    only = null, // the one branch that is shown, or null for all
    view = null,
    held = null, // {which, turn} under a hand
    pinned = { start: false, end: false },
    masks = [];

  const rem = () => parseFloat(getComputedStyle(document.documentElement).fontSize);
  function layout() {
    const r = rem(),
      w = el.clientWidth,
      hgt = el.clientHeight;
    const box = { l: LEFT * r, t: TOP * r, w: w - (LEFT + RIGHT) * r, h: hgt - (TOP + BOTTOM) * r };
    let lo = -Math.PI,
      hi = Math.PI;
    if (route.map && !isRound(route.map)) {
      lo = route.map.turn[0];
      hi = route.map.turn.at(-1);
    } else if (route.turn.length) {
      const quarter = 90 * DEG;
      lo = Math.min(lo, quarter * Math.floor(Math.min(...route.turn) / quarter));
      hi = Math.max(hi, quarter * Math.ceil(Math.max(...route.turn) / quarter));
    }
    view = { ...box, lo, hi, W: w, H: hgt };
  }
  const X = (s) => view.l + s * view.w;
  const Y = (turn) => view.t + (1 - (turn - view.lo) / (view.hi - view.lo)) * view.h;
  const turnAt = (y) => view.lo + (1 - (y - view.t) / view.h) * (view.hi - view.lo);
  const colourOf = (name) => colours.curves[Math.max(route.branches.indexOf(name), 0) % colours.curves.length];

  /** One picture a branch, a pixel a cell: drawn once, stretched over the map. */
  function makeMasks() {
    masks = (route.map?.branches ?? []).map((name, b) => {
      const open = cellsOf(route.map, b),
        m = route.map.s.length,
        n = route.map.turn.length;
      const c = h('canvas', { width: m, height: n }),
        ctx = c.getContext('2d'),
        data = ctx.createImageData(m, n);
      const hex = parseInt(colourOf(name).slice(1), 16);
      for (let i = 0; i < m; i++)
        for (let k = 0; k < n; k++) {
          if (!open(i, k)) continue;
          const at = 4 * ((n - 1 - k) * m + i);
          data.data.set([hex >> 16, (hex >> 8) & 255, hex & 255, 255], at);
        }
      ctx.putImageData(data, 0, 0);
      return { name, c };
    });
  }

  function paint() {
    if (!route || !el.clientWidth) return;
    layout();
    const scale = Math.min(devicePixelRatio, 2),
      ctx = canvas.getContext('2d');
    canvas.width = view.W * scale;
    canvas.height = view.H * scale;
    ctx.scale(scale, scale);
    const size = 0.76 * rem();
    ctx.font = `${size}px "Inter Variable", system-ui, sans-serif`;
    ctx.fillStyle = colours.ground;
    ctx.fillRect(view.l, view.t, view.w, view.h);
    ctx.save();
    ctx.beginPath();
    ctx.rect(view.l, view.t, view.w, view.h);
    ctx.clip();
    paintOpen(ctx);
    paintBlocked(ctx);
    paintCurve(ctx);
    ctx.restore();
    paintAxes(ctx, size);
    placeEnds();
  }
  function paintOpen(ctx) {
    const map = route.map;
    if (!map) return;
    const step = map.turn[1] - map.turn[0],
      round = isRound(map),
      low = map.turn[0] - step / 2,
      high = map.turn.at(-1) + step / 2;
    const first = round ? Math.floor((view.lo - low) / (2 * Math.PI)) : 0,
      last = round ? Math.ceil((view.hi - high) / (2 * Math.PI)) : 0;
    for (const { name, c } of masks) {
      if (only && only !== name) continue;
      ctx.globalAlpha = (only ? 0.4 : 0.3) * (colours.dark ? 0.8 : 1);
      for (let k = first; k <= last; k++) {
        const a = Y(high + 2 * Math.PI * k),
          b = Y(low + 2 * Math.PI * k);
        ctx.drawImage(c, view.l, a, view.w, b - a);
      }
    }
    ctx.globalAlpha = 1;
  }
  function paintBlocked(ctx) {
    if (!route.blocked) return;
    const [a, b] = route.blocked.s,
      x = X(a),
      w = Math.max(X(b) - x, 3);
    ctx.fillStyle = colours.wrong;
    ctx.globalAlpha = 0.75;
    ctx.fillRect(Math.min(x, view.l + view.w - w), view.t, w, view.h);
    ctx.globalAlpha = 1;
  }
  function paintCurve(ctx) {
    if (!route.q.length) return;
    const runs = [[0]];
    route.labels.forEach((label, i) => {
      if (i && label !== route.labels[i - 1]) runs.push([i - 1]);
      runs.at(-1).push(i);
    });
    for (const [width, under] of [
      [0.38, true],
      [0.18, false],
    ])
      for (const run of runs) {
        ctx.beginPath();
        for (const i of run) ctx.lineTo(X(route.s[i]), Y(route.turn[i]));
        ctx.lineWidth = width * rem();
        ctx.lineJoin = ctx.lineCap = 'round';
        ctx.strokeStyle = under ? colours.panel : colours.curves[route.labels[run.at(-1)] % colours.curves.length];
        ctx.stroke();
      }
  }
  function paintAxes(ctx, size) {
    ctx.strokeStyle = colours.line;
    ctx.strokeRect(view.l, view.t, view.w, view.h);
    ctx.fillStyle = colours.muted;
    ctx.textBaseline = 'middle';
    ctx.textAlign = 'right';
    const span = (view.hi - view.lo) / DEG,
      step = [5, 10, 15, 30, 45, 90, 180].find((v) => span / v <= 6) ?? 180;
    for (let v = Math.ceil(view.lo / DEG / step - 1e-9) * step; v <= view.hi / DEG + 1e-6; v += step) {
      const y = Y(v * DEG);
      ctx.fillText(shown(v * DEG, 'angle', units.angle === 'deg' ? 0 : 2), view.l - 0.45 * size, y);
      ctx.globalAlpha = 0.5;
      ctx.beginPath();
      ctx.moveTo(view.l, y);
      ctx.lineTo(view.l + view.w, y);
      ctx.lineWidth = 1;
      ctx.stroke();
      ctx.globalAlpha = 1;
    }
    ctx.textBaseline = 'top';
    ctx.textAlign = 'center';
    const y = view.t + view.h + 0.45 * size;
    for (const v of [0, 0.25, 0.5, 0.75, 1]) ctx.fillText(String(v), X(v), y);
    ctx.fillText('path, from 0 to 1', X(0.5), y + 1.15 * size);
    ctx.save();
    ctx.translate(0.5 * size, view.t + view.h / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.textBaseline = 'middle';
    ctx.fillText(`turn of the tool, ${units.symbol('angle')}`, 0, 0);
    ctx.restore();
  }

  const turnOf = (which) => (held?.which === which ? held.turn : which === 'start' ? route.turn[0] : route.turn.at(-1));
  function placeEnds() {
    ends.forEach((handle, i) => {
      const which = i ? 'end' : 'start';
      const there = Boolean(route?.turn.length && route.map);
      handle.hidden = !there;
      if (!there) return;
      const turn = turnOf(which);
      handle.style.setProperty('left', `${X(i)}px`);
      handle.style.setProperty('top', `${Y(turn)}px`);
      handle.classList.toggle('pinned', pinned[which]);
      handle.setAttribute('aria-valuemin', shown(view.lo, 'angle', 0).replace('−', '-'));
      handle.setAttribute('aria-valuemax', shown(view.hi, 'angle', 0).replace('−', '-'));
      handle.setAttribute('aria-valuenow', shown(turn, 'angle').replace('−', '-'));
      handle.setAttribute('aria-valuetext', `${showUnit(turn, 'angle')}${pinned[which] ? ', held' : ''}`);
    });
  }
  const allowed = (turn) => Math.min(Math.max(turn, view.lo), view.hi);
  function hold(which, turn) {
    held = { which, turn: allowed(turn) };
    placeEnds();
    const open = openAt(route.map, which === 'start' ? 0 : 1, held.turn);
    word.hidden = false;
    setText(word, `${showUnit(held.turn, 'angle', 1)}: ${open.length ? open.join('; ') : 'closed on every branch'}`);
    word.dataset.tone = open.length ? '' : 'wrong';
    word.style.setProperty('top', `${Math.min(Math.max(Y(held.turn), view.t + 12), view.t + view.h - 12)}px`);
    word.classList.toggle('right', which === 'end');
    drag(which, held.turn);
  }
  function letGo() {
    if (!held) return;
    const { which, turn } = held;
    word.hidden = true;
    drop(which, turn);
  }
  ends.forEach((handle, i) => {
    const which = i ? 'end' : 'start';
    handle.addEventListener('pointerdown', (e) => {
      e.preventDefault();
      handle.focus();
      handle.setPointerCapture(e.pointerId);
      const by = turnOf(which) - turnAt(e.clientY - el.getBoundingClientRect().top);
      const move = (ev) => hold(which, turnAt(ev.clientY - el.getBoundingClientRect().top) + by);
      handle.addEventListener('pointermove', move);
      const end = () => {
        handle.removeEventListener('pointermove', move);
        letGo();
      };
      handle.addEventListener('pointerup', end, { once: true });
      handle.addEventListener('pointercancel', end, { once: true });
    });
    handle.addEventListener('keydown', (e) => {
      const by = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[e.key];
      if (by) hold(which, turnOf(which) + by * DEG * (e.shiftKey ? 0.1 : 1));
      else if (e.key === 'Enter') letGo();
      else if (e.key === 'Escape' && held) {
        cancel();
        drag(which, null);
      } else return;
      e.preventDefault();
      e.stopPropagation();
    });
    handle.addEventListener('blur', () => held?.which === which && letGo());
  });
  canvas.addEventListener('pointerdown', (e) => {
    if (!route?.q.length) return;
    const at = (ev) =>
      scrub(Math.min(Math.max((ev.clientX - el.getBoundingClientRect().left - view.l) / view.w, 0), 1));
    canvas.setPointerCapture(e.pointerId);
    at(e);
    canvas.addEventListener('pointermove', at);
    const end = () => canvas.removeEventListener('pointermove', at);
    canvas.addEventListener('pointerup', end, { once: true });
    canvas.addEventListener('pointercancel', end, { once: true });
  });
  /** What a hand held goes back to where the route has it. */
  function cancel() {
    held = null;
    word.hidden = true;
    if (route) placeEnds();
  }
  new ResizeObserver(perFrame(paint)).observe(el);
  return {
    el,
    paint() {
      if (route) makeMasks();
      paint();
    },
    cancel,
    /** Show a route, or nothing: one branch of it, or all; `pins` says which ends a hand has put where they are. */
    show(next, branch = null, pins = { start: false, end: false }) {
      route = next;
      pinned = pins;
      held = null;
      word.hidden = true;
      el.hidden = !next;
      if (!next) return;
      only = branch;
      makeMasks();
      paint();
    },
    only(name) {
      only = name;
      paint();
    },
    /** Put the line of the present place, or take it away. */
    at(s) {
      now.hidden = s === null || !view || !route?.q.length;
      if (!now.hidden) {
        now.style.setProperty('left', `${X(s)}px`);
        now.style.setProperty('top', `${view.t}px`);
        now.style.setProperty('height', `${view.h}px`);
      }
    },
    /** Where an end is on the screen, CSS pixels in the page, at a turn (rad). */
    place(which, turn = null) {
      const r = el.getBoundingClientRect();
      return [r.x + X(which === 'end' ? 1 : 0), r.y + Y(turn ?? turnOf(which))];
    },
  };
}
