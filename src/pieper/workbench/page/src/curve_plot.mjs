// The curves of a motion as a plot: limits as dashed lines, where one binds as a thick stroke, events, the present point.
import uPlot from 'uplot';
import { h } from './dom.mjs';
import { colours } from './theme.mjs';
import { limitLines } from './curves.mjs';

const rem = () => parseFloat(getComputedStyle(document.documentElement).fontSize);
const colourOf = (i) => colours.curves[i % colours.curves.length];
/** Room above and below the curves, as a share of what they span. */
const MARGIN = 0.06;

/** From the lowest to the highest value with some room; the limits are in it where they are asked for. */
function span(lo, hi, lines) {
  const all = [lo, hi, ...lines.map((l) => l.value)],
    least = Math.min(...all),
    most = Math.max(...all),
    room = MARGIN * (most - least);
  return most - least > 1e-9 ? [least - room, most + room] : [least - 1, most + 1];
}

/** Dashed lines at what must be kept, in the colour of whose it is; thick strokes where it binds. */
function drawLimits(u, motion, list, lines) {
  const { ctx } = u,
    k = devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  ctx.clip();
  for (const { value, of } of lines) {
    const y = u.valToPos(value, 'y', true);
    ctx.strokeStyle = of === null ? colours.ink : colourOf(of);
    ctx.lineWidth = 1.25 * k;
    ctx.setLineDash([5 * k, 4 * k]);
    ctx.beginPath();
    ctx.moveTo(u.bbox.left, y);
    ctx.lineTo(u.bbox.left + u.bbox.width, y);
    ctx.stroke();
  }
  ctx.setLineDash([]);
  ctx.lineCap = 'round';
  ctx.lineWidth = 4.5 * k;
  list.forEach((s, i) => {
    ctx.strokeStyle = colourOf(i);
    for (const { start, end } of s.binds) {
      const on = motion.xs.map((x, n) => [x, s.values[n]]).filter(([x]) => x >= start - 1e-9 && x <= end + 1e-9);
      ctx.beginPath();
      for (const [x, v] of on) ctx.lineTo(u.valToPos(x, 'x', true), u.valToPos(v, 'y', true));
      ctx.stroke();
    }
  });
  ctx.restore();
}

/**
 * Draw the series of a motion into an element.
 * @param withLimits whether the scale holds the limits; lines that it does not hold are not seen
 * @param pick called with the number of the posture that a hand points at
 * @returns {destroy, resize, point(index), canvas}
 */
export function curvePlot(host, motion, { y, list }, { withLimits, pick }) {
  const grid = { stroke: colours.line, width: 1 },
    font = `${Math.round(0.78 * rem())}px "Inter Variable", system-ui, sans-serif`,
    lines = limitLines(list);
  const axis = {
    stroke: colours.muted,
    grid,
    ticks: { ...grid, size: 4 },
    font,
    labelFont: font,
    labelSize: 1.4 * rem(),
    gap: 4,
  };
  const plot = new uPlot(
    {
      width: host.clientWidth || 600,
      height: host.clientHeight || 180,
      pxAlign: 0,
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
      scales: {
        x: { time: false, range: (_, lo, hi) => [lo, Math.max(hi, motion.xEnd ?? hi, lo + 1e-6)] },
        y: { range: (_, lo, hi) => span(lo, hi, withLimits ? lines : []) },
      },
      series: [
        {},
        ...list.map((s, i) => ({
          label: s.name,
          stroke: colourOf(i),
          width: 1.75,
          pxAlign: 0,
          points: { show: motion.q.length < 3 },
        })),
      ],
      axes: [
        { ...axis, label: motion.xName === 'point' ? 'point number' : 'time, s', size: 2.1 * rem() },
        { ...axis, label: y, size: 4 * rem() },
      ],
      hooks: { draw: [(u) => drawLimits(u, motion, list, lines)], setSize: [() => point()] },
    },
    [motion.xs, ...list.map((s) => s.values)],
    host,
  );
  plot.over.append(
    h('div', { class: 'now' }),
    ...motion.events.map((e) => {
      const el = h('div', { class: `event ${e.stop ? 'stop' : ''}`, title: e.text }, h('span', { text: e.short }));
      el.x = e.x;
      return el;
    }),
  );
  plot.over.addEventListener('pointerdown', (e) => {
    const at = (ev) => {
      const x = plot.posToVal(ev.clientX - plot.over.getBoundingClientRect().left, 'x');
      pick(motion.xs.reduce((best, v, i) => (Math.abs(v - x) < Math.abs(motion.xs[best] - x) ? i : best), 0));
    };
    at(e);
    const end = () => {
      removeEventListener('pointermove', at);
      removeEventListener('pointerup', end);
      removeEventListener('pointercancel', end);
    };
    addEventListener('pointermove', at);
    addEventListener('pointerup', end);
    addEventListener('pointercancel', end);
  });
  let index = 0;
  /** Put the line of the present point and the marks of the events where they belong. */
  function point(k = index) {
    index = k;
    const width = plot.over.clientWidth,
      taken = []; // pixels from and to that words of events stand over, line by line
    for (const el of plot.over.querySelectorAll('.now, .event')) {
      const x = plot.valToPos(el.x ?? motion.xs[index], 'x'),
        leftward = x > width * 0.7;
      el.style.setProperty('left', `${x}px`);
      el.classList.toggle('leftward', leftward);
      const words = el.firstElementChild;
      if (!words) continue;
      // words of events close to each other stand under each other
      const [from, to] = leftward ? [x - words.offsetWidth, x] : [x, x + words.offsetWidth];
      let line = 0;
      while (taken.some((t) => t.line === line && from < t.to && t.from < to)) line += 1;
      taken.push({ line, from, to });
      words.style.setProperty('top', `${line * words.offsetHeight}px`);
    }
  }
  return {
    point,
    canvas: plot.ctx.canvas,
    resize: () => host.clientWidth && plot.setSize({ width: host.clientWidth, height: host.clientHeight }),
    destroy: () => plot.destroy(),
  };
}
