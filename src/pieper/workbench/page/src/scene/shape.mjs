// What an arm looks like, from its table alone: rods, balls, drums (revolute) and sleeves (prismatic) with their places.
import { jointAxes, reach } from '../kinematics.mjs';
import { position, column, addScaled, sub, norm, dot } from '../matrix.mjs';

/** Sizes that belong to the table and not to a posture. */
export function proportions(table) {
  const n = table.joints.length,
    size = reach(table);
  const thick = Math.min(0.062, 0.075 - 0.002 * n) * size;
  const radius = table.joints.map((_, i) => thick * (1 - (0.52 * i) / Math.max(n - 1, 1)));
  return { size, radius, rest: radius[n - 1] ?? thick * 0.5 };
}

/**
 * Place the parts of an arm at its frames.
 *
 * Joint i's drum sits on its axis. Where two joints share a point, as in a spherical wrist, the later one moves along its own axis
 * towards what it carries, so that each can be seen.
 */
export function shape(table, F, form, q = null) {
  const parts = { rods: [], balls: [], drums: [], sleeves: [], flange: null };
  const { radius, size } = form,
    n = table.joints.length,
    tiny = size * 1e-6;
  const axes = jointAxes(table, F);
  /** A rod, if there is any length to it, and a ball at its far end, where the next one may set off another way. */
  const rod = (a, b, r, ball = true, far = r) => {
    if (norm(sub(b, a)) <= tiny) return;
    parts.rods.push({ a, b, r, far });
    if (ball) parts.balls.push({ at: b, r: far });
  };
  if (n) parts.pedestal = { at: position(F[0]), dir: column(F[0], 2), r: radius[0] * 1.7, h: radius[0] * 0.34 };
  let previous = null;
  axes.forEach(({ point, dir, x }, i) => {
    const r = radius[i],
      joint = table.joints[i],
      o = position(F[i]),
      p = position(F[i + 1]);
    const thin = r * 0.62,
      // a link grows thinner towards what it carries
      wide = r * 0.84,
      next = (radius[i + 1] ?? form.rest) * 0.62,
      before = (radius[i - 1] ?? r) * 0.84;
    if (table.convention === 'standard') {
      const shoulder = addScaled(o, dir, dot(sub(p, o), dir));
      rod(o, shoulder, thin);
      rod(shoulder, p, wide, true, next);
    } else {
      rod(o, point, before, true, thin);
      rod(point, p, thin);
    }
    let at = point;
    const along = dot(sub(p, point), dir);
    if (previous && norm(sub(point, previous.at)) < 0.5 * r && Math.abs(along) > tiny) {
      at = addScaled(point, dir, Math.sign(along) * Math.min(Math.abs(along) * 0.55, previous.r + r * 1.15));
    } else if (i === 0 && Math.abs(along) > 2.2 * r) at = addScaled(point, dir, Math.sign(along) * r * 1.25);
    const h = r * 2.15,
      turned = column(F[i + 1], 0),
      beyond = Boolean(q && outsideOf(joint, q[i]));
    // what stands on the mounting plane ends there
    const up = column(F[0], 2),
      bottom = dot(sub(at, position(F[0])), up) - h / 2;
    if (i === 0 && joint.type === 'R' && Math.abs(dot(dir, up)) > 0.99 && bottom < 0 && bottom > -h)
      at = addScaled(at, up, -bottom);
    if (joint.type === 'R') parts.drums.push({ at, dir, x, turned, r, h, beyond, joint: i });
    else parts.sleeves.push({ at, dir, x, r: r * 0.95, h: r * 3.4, beyond, joint: i });
    previous = { at: point, r };
  });
  if (n) {
    const end = F[n + 1],
      hand = position(F[n]);
    parts.flange = { at: hand, dir: column(F[n], 2), turned: column(F[n], 0), r: form.rest * 0.85, h: form.rest * 0.5 };
    rod(hand, position(end), form.rest * 0.34, false);
    parts.tip = { at: position(end), r: form.rest * 0.42 };
  }
  return parts;
}

/** By how much a joint value lies outside its limits: negative below, positive above, 0 inside. */
export function outsideOf(joint, v) {
  const slack = 1e-9;
  if (joint.lower !== null && v < joint.lower - slack) return v - joint.lower;
  if (joint.upper !== null && v > joint.upper + slack) return v - joint.upper;
  return 0;
}

/** Length of a frame's arrows, in sizes of the arm. */
export const ARROW = 0.13;
/** Points that a picture of the arm must hold. */
export function outline(table, F) {
  const { radius, size } = proportions(table),
    pad = radius[0] ?? 0.05;
  const base = position(F[0]);
  // an empty table is a place for an arm of a metre
  if (!table.joints.length)
    return [-0.4, 0.4].flatMap((v) => [
      [base[0] + v, base[1] + v, 0],
      [base[0] + v, base[1] - v, 1],
    ]);
  const out = [[base[0], base[1], 0], ...F.map(position)];
  for (const { point } of jointAxes(table, F)) out.push(point);
  const tool = F.at(-1),
    tips = [0, 1, 2].map((k) => [3, 7, 11].map((i) => tool[i] + ARROW * size * tool[i - 3 + k]));
  return [
    ...tips,
    ...out.flatMap((p) => [
      [p[0] - pad, p[1] - pad, p[2] - pad],
      [p[0] + pad, p[1] + pad, p[2] + pad],
    ]),
  ];
}
