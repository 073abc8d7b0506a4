// What is drawn against the point number or the time: tool and joints, their speeds, accelerations, what they must keep.
import { frames as forward, singularValues } from './kinematics.mjs';
import { position, norm } from './matrix.mjs';
import { units } from './units.mjs';
import { kindOf } from './panels/joints.mjs';

export const kinds = [
  ['position', 'Position'],
  ['joints', 'Joints'],
  ['speeds', 'Joint speeds'],
  ['accelerations', 'Accelerations'],
  ['toolspeed', 'Tool speed'],
  ['singularity', 'Distance to singularity'],
];

/**
 * A motion that can be played: postures in order.
 * @param xs point numbers or seconds, one a posture; `xEnd` where the axis ends; `seconds` the time of each posture
 * @param limits speeds and accelerations that it keeps, SI, as a program has them; `tight` where one of them binds
 */
export function motionOf({ table, q, xs, xName, xEnd = null, seconds, dq, ddq, events = [], title, ...kept }) {
  const F = q.map((v) => forward(table, v)),
    tool = F.map((f) => position(f[f.length - 1])),
    speeds = dq ?? finiteDifferences(q, seconds);
  return {
    table,
    q,
    xs,
    xName,
    xEnd,
    seconds,
    events,
    title,
    ...kept,
    tool,
    speeds,
    accelerations: ddq ?? finiteDifferences(speeds, seconds),
    toolspeeds: finiteDifferences(tool, seconds).map(norm),
    least: q.map((v, i) => singularValues(table, v, F[i])[0] ?? 0),
  };
}

function finiteDifferences(q, t) {
  return q.map((_, i) => {
    const a = Math.max(i - 1, 0),
      b = Math.min(i + 1, q.length - 1),
      dt = t[b] - t[a];
    return q[i].map((_, j) => (dt > 0 ? (q[b][j] - q[a][j]) / dt : 0));
  });
}

/** Beyond this a limit of a program stands for none. */
const NO_LIMIT = 1e6;
/** What joint i must keep in curves of a kind: [lowest, highest], null where nothing is said. */
function keptBy(motion, kind, i) {
  const joint = motion.table.joints[i];
  if (kind === 'joints') return [joint.lower, joint.upper];
  const said = motion.limits?.[{ speeds: 'speed', accelerations: 'acceleration' }[kind]],
    most = Array.isArray(said) ? said[i] : (said ?? null);
  return most === null || most >= NO_LIMIT ? [null, null] : [-most, most];
}
const BINDS = { speeds: 'speed', accelerations: 'acceleration', toolspeed: 'tool speed' };
/** Stretches on which the limit that curves of a kind show binds, of one joint or of the tool. */
const bindsOn = (motion, kind, joint = null) =>
  (motion.tight ?? []).filter((x) => x.limit === BINDS[kind] && x.joint === joint);
/** What binds at a time, in words. */
export const bindingAt = (motion, t) =>
  (motion.tight ?? [])
    .filter((x) => x.start - 1e-9 <= t && t <= x.end + 1e-9)
    .map((x) => (x.joint ? `${x.limit} of ${x.joint}` : x.limit))
    .join(', ');

/**
 * The series of one kind, in the units shown: [{name, values, limits, binds}], and what the y axis says. `limits` are the
 * lowest and the highest value that is kept, null where there is none; `binds` the stretches on which that limit binds.
 */
export function series(motion, kind) {
  const { table } = motion,
    L = units.factor('length');
  if (kind === 'position')
    return {
      y: `tool, ${units.length}`,
      list: ['X', 'Y', 'Z'].map((name, k) =>
        one(
          name,
          motion.tool.map((p) => p[k] * L),
        ),
      ),
    };
  if (kind === 'singularity') return { y: 'smallest singular value', list: [one('σ min', motion.least)] };
  if (kind === 'toolspeed') {
    const most = motion.limits?.tool_speed ?? null,
      values = motion.toolspeeds.map((v) => v * L);
    return {
      y: `tool, ${units.length}/s`,
      list: [one('tool speed', values, [null, most && most * L], bindsOn(motion, kind))],
    };
  }
  const rows = { joints: motion.q, speeds: motion.speeds, accelerations: motion.accelerations }[kind],
    per = { joints: '', speeds: '/s', accelerations: '/s²' }[kind];
  const kindsHere = new Set(table.joints.map(kindOf));
  const unit = [...kindsHere].map((k) => (k === 'angle' ? units.angle : units.length) + per).join(' or ');
  const list = table.joints.map((j, i) => {
    const by = units.factor(kindOf(j));
    return one(
      `q${i + 1}`,
      rows.map((r) => r[i] * by),
      keptBy(motion, kind, i).map((v) => (v === null ? null : v * by)),
      bindsOn(motion, kind, j.name),
    );
  });
  return { y: unit, list };
}
const one = (name, values, limits = [null, null], binds = []) => ({ name, values, limits, binds });

/** The limits of series as lines: [{value, of}], `of` the number of its series, or null where all have the same. */
export function limitLines(list) {
  const lines = list.flatMap((s, of) => s.limits.filter((v) => v !== null).map((value) => ({ value, of })));
  const at = new Map();
  for (const l of lines) at.set(l.value, [...(at.get(l.value) ?? []), l.of]);
  return [...at].map(([value, whose]) => ({ value, of: whose.length === 1 && list.length > 1 ? whose[0] : null }));
}

export function csv(motion) {
  const deg = units.angle,
    mm = units.length,
    { table } = motion;
  const unit = (j) => (kindOf(j) === 'angle' ? deg : mm);
  const head = [
    motion.xName.replace(' ', '_'),
    'time_s',
    `X_${mm}`,
    `Y_${mm}`,
    `Z_${mm}`,
    ...table.joints.map((j, i) => `q${i + 1}_${unit(j)}`),
    ...table.joints.map((j, i) => `dq${i + 1}_${unit(j)}_per_s`),
    'sigma_min',
  ];
  const n = (v) => String(Number(v.toPrecision(10)));
  const lines = motion.q.map((q, i) =>
    [
      motion.xs[i],
      motion.seconds[i],
      ...motion.tool[i].map((v) => v * units.factor('length')),
      ...q.map((v, j) => v * units.factor(kindOf(table.joints[j]))),
      ...motion.speeds[i].map((v, j) => v * units.factor(kindOf(table.joints[j]))),
      motion.least[i],
    ]
      .map(n)
      .join(','),
  );
  return [head.join(','), ...lines].join('\n') + '\n';
}

/** The same curves as an SVG that stands alone: white paper, black axes, colours and dashes that survive grey printing. */
export function svg(motion, kind, colours) {
  const { y, list } = series(motion, kind),
    W = 720,
    H = 380,
    box = { l: 66, r: 96, t: 34, b: 48 };
  const xs = motion.xs,
    all = list.flatMap((s) => s.values);
  const last = motion.xEnd ?? xs[xs.length - 1],
    x0 = xs[0],
    x1 = last > x0 ? last : x0 + 1;
  let [y0, y1] = [Math.min(...all), Math.max(...all)];
  if (!(y1 - y0 > 1e-9)) {
    y0 -= 1;
    y1 += 1;
  }
  const X = (v) => box.l + ((v - x0) / (x1 - x0)) * (W - box.l - box.r),
    Y = (v) => H - box.b - ((v - y0) / (y1 - y0)) * (H - box.t - box.b);
  const ticks = (a, b) => {
    const raw = (b - a) / 6,
      ten = 10 ** Math.floor(Math.log10(raw)),
      step = [1, 2, 5, 10].map((k) => k * ten).find((s) => s >= raw);
    return Array.from({ length: 12 }, (_, i) => (Math.ceil(a / step) + i) * step).filter((v) => v <= b + step * 1e-6);
  };
  const f = (v) => v.toFixed(2),
    name = (v) => String(Number(v.toPrecision(6)));
  const esc = (t) => t.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);
  const dash = ['', '7 3', '2 3', '9 3 2 3', '5 2 1 2 1 2', '12 4', '1 2', '6 6'];
  const parts = [
    `<rect width="${W}" height="${H}" fill="#fff"/>`,
    `<text x="${box.l}" y="20" font-weight="600">${esc(motion.title)}</text>`,
  ];
  for (const v of ticks(y0, y1))
    parts.push(
      `<path d="M${box.l} ${f(Y(v))}H${W - box.r}" stroke="#ddd"/><text x="${box.l - 8}" y="${f(Y(v) + 4)}" text-anchor="end">${name(v)}</text>`,
    );
  for (const v of ticks(x0, x1))
    parts.push(
      `<path d="M${f(X(v))} ${H - box.b}v5" stroke="#333"/><text x="${f(X(v))}" y="${H - box.b + 20}" text-anchor="middle">${name(v)}</text>`,
    );
  parts.push(`<path d="M${box.l} ${box.t}V${H - box.b}H${W - box.r}" fill="none" stroke="#333"/>`);
  for (const e of motion.events)
    if (Number.isFinite(e.x))
      parts.push(
        `<path d="M${f(X(e.x))} ${box.t}V${H - box.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${f(X(e.x) + 4)}" y="${box.t + 10}" fill="#b42318" font-size="11">${esc(e.short)}</text>`,
      );
  for (const { value, of } of limitLines(list))
    if (value >= y0 && value <= y1)
      parts.push(
        `<path d="M${box.l} ${f(Y(value))}H${W - box.r}" stroke="${of === null ? '#333' : colours[of % colours.length]}" stroke-dasharray="2 5"/>`,
      );
  list.forEach((s, i) => {
    const c = colours[i % colours.length],
      at = s.values[s.values.length - 1];
    parts.push(
      `<polyline fill="none" stroke="${c}" stroke-width="1.8" stroke-dasharray="${dash[i % dash.length]}" points="${s.values.map((v, k) => `${f(X(xs[k]))},${f(Y(v))}`).join(' ')}"/>`,
      `<path d="M${W - box.r + 12} ${box.t + 8 + 18 * i}h22" stroke="${c}" stroke-width="2" stroke-dasharray="${dash[i % dash.length]}"/><text x="${W - box.r + 40}" y="${box.t + 12 + 18 * i}"><title>${f(at)}</title>${esc(s.name)}</text>`,
    );
  });
  parts.push(
    `<text x="${(box.l + W - box.r) / 2}" y="${H - 8}" text-anchor="middle">${esc(motion.xName)}</text>`,
    `<text transform="translate(16 ${(box.t + H - box.b) / 2}) rotate(-90)" text-anchor="middle">${esc(y)}</text>`,
  );
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${W} ${H}" width="${W}" height="${H}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${parts.join('')}</svg>\n`;
}
