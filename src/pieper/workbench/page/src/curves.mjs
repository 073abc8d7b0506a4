// What is drawn against the point number or the time: tool position, joints, joint speeds, distance to singularity.
import { frames as forward, singularValues } from './kinematics.mjs';
import { position } from './matrix.mjs';
import { units } from './units.mjs';
import { kindOf } from './panels/joints.mjs';

export const kinds = [
  ['position', 'Position'],
  ['joints', 'Joints'],
  ['speeds', 'Joint speeds'],
  ['singularity', 'Distance to singularity'],
];

/**
 * A motion that can be played: postures in order.
 * @param xs point numbers or seconds, one a posture; `xEnd` where the axis ends; `seconds` the time of each posture
 */
export function motionOf({ table, q, xs, xName, xEnd = null, seconds, dq = null, events = [], title }) {
  const F = q.map((v) => forward(table, v));
  return {
    table,
    q,
    xs,
    xName,
    xEnd,
    seconds,
    events,
    title,
    tool: F.map((f) => position(f[f.length - 1])),
    speeds: dq ?? finiteDifferences(q, seconds),
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

/** The series of one kind, in the units shown: [{name, values}], and what the y axis says. */
export function series(motion, kind) {
  const { table } = motion,
    L = units.factor('length');
  if (kind === 'position')
    return {
      y: `tool, ${units.length}`,
      list: ['X', 'Y', 'Z'].map((name, k) => ({ name, values: motion.tool.map((p) => p[k] * L) })),
    };
  if (kind === 'singularity') return { y: 'smallest singular value', list: [{ name: 'σ min', values: motion.least }] };
  const rows = kind === 'joints' ? motion.q : motion.speeds,
    per = kind === 'joints' ? '' : '/s';
  const kindsHere = new Set(table.joints.map(kindOf));
  const unit = [...kindsHere].map((k) => (k === 'angle' ? units.angle : units.length) + per).join(' or ');
  return {
    y: unit,
    list: table.joints.map((j, i) => ({ name: `q${i + 1}`, values: rows.map((r) => r[i] * units.factor(kindOf(j))) })),
  };
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
