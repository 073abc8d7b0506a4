// Under the picture: play, scrub and speed, and the curves of the motion with their limits and events.
import { button, choice, download, h, perFrame, replace, say, select, setText } from './dom.mjs';
import { state, on, setJoints, tell } from './store.mjs';
import { play, stop } from './animate.mjs';
import { colours } from './theme.mjs';
import { kinds, series, csv, svg, limitLines, bindingAt } from './curves.mjs';
import { curvePlot } from './curve_plot.mjs';
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
/** Kinds of curves whose scale holds their limits. */
const scaled = new Set(['speeds', 'accelerations', 'toolspeed']);

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
  const binds = h('output', { class: 'binds', 'data-testid': 'binds' });
  const limits = button(
    'To the limits',
    {
      class: 'quiet',
      title: 'Scale the curves so that their limits, dashed, are seen; thick is where one binds',
      'data-testid': 'limits-shown',
    },
    () => {
      if (!scaled.delete(kind)) scaled.add(kind);
      draw();
    },
  );
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
      button('×', { class: 'icon', 'aria-label': 'Close the curves' }, () => show(null)),
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
      limits,
      legend,
      binds,
      h(
        'span',
        { class: 'line saves' },
        ...[
          ['CSV', () => download('motion.csv', csv(motion), 'text/csv')],
          ['PNG', png],
          ['Film', shoot],
          ['GIF', () => draw3('gif')],
          ['MP4', () => draw3('mp4')],
          ['SVG', () => download(`${kind}.svg`, svg(motion, kind, colours.curves), 'image/svg+xml')],
        ].map(([t, f]) => button(t, { class: 'quiet', 'aria-label': `Save as ${t}` }, () => motion && f())),
      ),
    ),
    chart,
  );
  els = { root, toggle, scrub, where, marks, chart, legend, limits, binds };
  new ResizeObserver(perFrame(() => plot?.resize())).observe(chart);
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
/** What a motion was planned for was changed: it goes, unless another one is shown by now. */
export const drop = (planned) => planned && planned === motion && show(null);
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
  setText(els.binds, motion.tight ? `Binds: ${bindingAt(motion, motion.seconds[index]) || 'nothing'}` : '');
  plot?.point(index);
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
  plot?.destroy();
  const drawn = series(motion, kind);
  replace(
    els.legend,
    drawn.list.map((s, i) => {
      const dot = h('span', { class: 'swatch' });
      dot.style.setProperty('background', colours.curves[i % colours.curves.length]);
      return h('span', {}, dot, s.name);
    }),
  );
  els.limits.hidden = !limitLines(drawn.list).length;
  els.limits.setAttribute('aria-pressed', String(scaled.has(kind)));
  plot = curvePlot(els.chart, motion, drawn, {
    withLimits: scaled.has(kind),
    pick(k) {
      stop();
      go(k);
    },
  });
  plot.point(index);
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
  const c = plot.canvas,
    out = document.createElement('canvas'),
    ctx = out.getContext('2d');
  out.width = c.width;
  out.height = c.height;
  ctx.fillStyle = colours.panel;
  ctx.fillRect(0, 0, out.width, out.height);
  ctx.drawImage(c, 0, 0);
  out.toBlob((blob) => download(`${kind}.png`, blob));
}
