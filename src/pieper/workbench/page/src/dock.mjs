// Under the picture: play, scrub and speed, and the curves of the motion with their events.
import uPlot from 'uplot';
import { button, choice, download, h, perFrame, replace, say, select, setText } from './dom.mjs';
import { state, on, setJoints, tell } from './store.mjs';
import { play, stop } from './animate.mjs';
import { colours } from './theme.mjs';
import { kinds, series, csv, svg } from './curves.mjs';
import { fixed } from './units.mjs';
import { showMotionRoom } from './scene/arm.mjs';
import { keepInView, withPicture } from './scene/view.mjs';
import { film, drawn } from './film.mjs';

let motion = null,
  plot = null,
  kind = 'joints',
  index = 0,
  speed = 1,
  els = null;

export function build(root) {
  const toggle = button('Play', { class: 'primary', 'data-testid': 'play' }, playOrPause);
  const scrub = h('input', {
    type: 'range',
    min: '0',
    max: '1',
    step: '1',
    value: '0',
    'aria-label': 'Point of the motion',
    'data-testid': 'scrub',
    on: {
      input: () => {
        stop();
        go(Number(scrub.value));
      },
    },
  });
  const where = h('output', { class: 'where', 'data-testid': 'where' });
  const marks = h('div', { class: 'marks' });
  const chart = h('div', { class: 'chart', 'data-testid': 'chart' });
  const legend = h('div', { class: 'legend' });
  root.append(
    h(
      'div',
      { class: 'dock-bar' },
      toggle,
      select(
        'Speed',
        [
          ['0.25', '¼×'],
          ['0.5', '½×'],
          ['1', '1×'],
          ['2', '2×'],
          ['4', '4×'],
          ['10', '10×'],
        ],
        '1',
        (v) => {
          speed = Number(v);
        },
        { 'data-testid': 'speed' },
      ),
      h('div', { class: 'scrubber' }, scrub, marks),
      where,
      h(
        'span',
        { class: 'line' },
        ...[
          ['CSV', () => download('motion.csv', csv(motion), 'text/csv')],
          ['PNG', png],
          ['Film', shoot],
          ['GIF', () => draw3('gif')],
          ['MP4', () => draw3('mp4')],
          ['SVG', () => download(`${kind}.svg`, svg(motion, kind, colours.curves), 'image/svg+xml')],
        ].map(([t, f]) => button(t, { class: 'quiet', 'aria-label': `Save as ${t}` }, () => motion && f())),
        button('×', { class: 'icon', 'aria-label': 'Close the curves' }, () => show(null)),
      ),
    ),
    h(
      'div',
      { class: 'dock-bar second' },
      choice(
        'Curves',
        kinds,
        kind,
        (k) => {
          kind = k;
          draw();
        },
        'curves',
      ),
      legend,
    ),
    chart,
  );
  els = { root, toggle, scrub, where, marks, chart, legend };
  new ResizeObserver(
    perFrame(() => plot && chart.clientWidth && plot.setSize({ width: chart.clientWidth, height: chart.clientHeight })),
  ).observe(chart);
  on(['units', 'theme'], draw);
  on('moving', (yes) => setText(toggle, yes && playing ? 'Pause' : 'Play'));
  on('table', (what) => {
    if (motion && !['postures', 'name', 'gripper'].includes(what)) show(null);
  });
}

/** Show a motion, or nothing. */
export function show(next) {
  stop();
  motion = next;
  state.motion = next;
  els.root.hidden = !next;
  if (plot) {
    plot.destroy();
    plot = null;
  }
  showMotionRoom(next?.table ?? null, next?.q ?? []);
  if (!next) {
    tell('motion');
    return;
  }
  els.scrub.max = String(Math.max(next.q.length - 1, 0));
  const span = next.xs[next.xs.length - 1] - next.xs[0] || 1;
  replace(
    els.marks,
    next.events.map((e) => {
      const m = h('span', { class: 'event-mark', title: e.text });
      m.style.setProperty('left', `${Math.min((100 * (e.x - next.xs[0])) / span, 100)}%`);
      return m;
    }),
    (next.tight ?? []).map((x) => {
      const m = h('span', { class: 'tight-mark', title: x.text });
      m.style.setProperty('left', `${(100 * (x.start - next.xs[0])) / span}%`);
      m.style.setProperty('width', `${(100 * (x.end - x.start)) / span}%`);
      return m;
    }),
  );
  draw();
  tell('motion');
  if (next.q.length) go(0);
  requestAnimationFrame(() => keepInView());
}
export const current = () => motion;
/** Which posture of the motion is shown. */
export const at = () => index;

/** Bring the arm to posture k of the motion. */
export function go(k) {
  if (!motion?.q.length) return;
  index = Math.min(Math.max(Math.round(k), 0), motion.q.length - 1);
  els.scrub.value = String(index);
  els.scrub.style.setProperty('--at', `${motion.q.length > 1 ? (100 * index) / (motion.q.length - 1) : 0}%`);
  setText(
    els.where,
    motion.xName === 'point'
      ? `point ${index + 1} of ${motion.q.length}`
      : `${fixed(motion.xs[index], 2)} s of ${fixed(motion.xs[motion.xs.length - 1], 2)} s`,
  );
  els.scrub.setAttribute('aria-valuetext', els.where.textContent);
  setJoints(motion.q[index].slice(), 'scrub');
  tell('played', motion.seconds[index]);
  point();
}

let playing = false;
function playOrPause(_, ended) {
  if (playing) {
    stop();
    return;
  }
  if (!motion?.q.length) return;
  const t = motion.seconds,
    whole = t[t.length - 1] || 1;
  const from = index >= motion.q.length - 1 ? 0 : t[index] / whole;
  playing = true;
  play(
    whole / speed,
    from,
    (s) => {
      let k = index <= motion.q.length - 1 && t[index] <= s * whole ? index : 0;
      while (k < t.length - 1 && t[k + 1] <= s * whole + 1e-9) k += 1;
      go(k);
    },
    () => {
      playing = false;
      setText(els.toggle, 'Play');
      ended?.();
    },
  );
  setText(els.toggle, 'Pause');
}

function draw() {
  if (!motion || !els) return;
  if (plot) {
    plot.destroy();
    plot = null;
  }
  const { y, list } = series(motion, kind),
    grid = { stroke: colours.line, width: 1 },
    font = `${Math.round(0.78 * rem())}px "Inter Variable", system-ui, sans-serif`;
  replace(
    els.legend,
    list.map((s, i) => {
      const dot = h('span', { class: 'swatch' });
      dot.style.setProperty('background', colours.curves[i % colours.curves.length]);
      return h('span', {}, dot, s.name);
    }),
  );
  const axis = {
    stroke: colours.muted,
    grid,
    ticks: { ...grid, size: 4 },
    font,
    labelFont: font,
    labelSize: 1.4 * rem(),
    gap: 4,
  };
  plot = new uPlot(
    {
      width: els.chart.clientWidth || 600,
      height: els.chart.clientHeight || 180,
      pxAlign: 0,
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
      scales: {
        x: { time: false, range: (_, lo, hi) => [lo, Math.max(hi, motion.xEnd ?? hi, lo + 1e-6)] },
        y: {
          range: (_, lo, hi) => (hi - lo > 1e-9 ? [lo - 0.06 * (hi - lo), hi + 0.06 * (hi - lo)] : [lo - 1, hi + 1]),
        },
      },
      series: [
        {},
        ...list.map((s, i) => ({
          label: s.name,
          stroke: colours.curves[i % colours.curves.length],
          width: 1.75,
          pxAlign: 0,
          points: { show: motion.q.length < 3 },
        })),
      ],
      axes: [
        { ...axis, label: motion.xName === 'point' ? 'point number' : 'time, s', size: 2.1 * rem() },
        { ...axis, label: y, size: 4 * rem() },
      ],
    },
    [motion.xs, ...list.map((s) => s.values)],
    els.chart,
  );
  const line = h('div', { class: 'now' });
  plot.over.append(
    line,
    ...motion.events.map((e) => {
      const el = h('div', { class: `event ${e.stop ? 'stop' : ''}`, title: e.text }, h('span', { text: e.short }));
      el.x = e.x;
      return el;
    }),
  );
  plot.over.addEventListener('pointerdown', (e) => {
    const at = (ev) => go(nearestIndex(plot.posToVal(ev.clientX - plot.over.getBoundingClientRect().left, 'x')));
    stop();
    at(e);
    const move = (ev) => at(ev),
      end = () => {
        removeEventListener('pointermove', move);
        removeEventListener('pointerup', end);
      };
    addEventListener('pointermove', move);
    addEventListener('pointerup', end);
  });
  plot.hooks.setSize = [point];
  point();
}
const rem = () => parseFloat(getComputedStyle(document.documentElement).fontSize);
const nearestIndex = (x) =>
  motion.xs.reduce((best, v, i) => (Math.abs(v - x) < Math.abs(motion.xs[best] - x) ? i : best), 0);
/** Put the line of the present point and the marks of the events where they belong. */
function point() {
  if (!plot) return;
  const width = plot.over.clientWidth;
  for (const el of plot.over.querySelectorAll('.now, .event')) {
    const x = plot.valToPos(el.x ?? motion.xs[index], 'x');
    el.style.setProperty('left', `${x}px`);
    el.classList.toggle('leftward', x > width * 0.7);
  }
}

/** Have the library draw it, from where the picture is looked at. */
async function draw3(kind) {
  say(`Drawing the ${kind.toUpperCase()} …`);
  try {
    const made = await drawn(motion, kind, speed, (done, of) =>
      say(`Drawing the ${kind.toUpperCase()}: ${done} of ${of} pictures`),
    );
    if (made) download(made.name, made.blob);
  } catch (error) {
    say(error.message, 'wrong');
  }
}

/** Play it from its beginning and keep what is seen. */
async function shoot() {
  stop();
  go(0);
  try {
    const made = await withPicture((canvas) => film(canvas, () => new Promise((done) => playOrPause(null, done))));
    download('motion.webm', made);
  } catch (error) {
    say(error.message, 'wrong');
  }
}

function png() {
  const c = plot.ctx.canvas,
    out = document.createElement('canvas'),
    ctx = out.getContext('2d');
  out.width = c.width;
  out.height = c.height;
  ctx.fillStyle = colours.panel;
  ctx.fillRect(0, 0, out.width, out.height);
  ctx.drawImage(c, 0, 0);
  out.toBlob((blob) => download(`${kind}.png`, blob));
}
