// Three turning and three sliding joints in any order: orientation alone gives the turns (two ways), position then the slides.
// Scalar.
#pragma once

#include "elimination/solve.hpp"

namespace pieper::PIEPER_ISA::general {

// d with d0 a + d1 b + d2 c = rest by Cramer's rule; false when the three slides depend on each other here.
inline bool slides_between(const Vec3* along, Vec3 rest, double* d) {
  const double det = dot(along[0], cross(along[1], along[2]));
  if (!(__builtin_fabs(det) > kThreeSlidesDepend)) return false;
  for (int i = 0; i < 3; ++i) d[i] = dot(rest, cross(along[(i + 1) % 3], along[(i + 2) % 3])) / det;
  return true;
}

// Returns false when a self-motion is possible: turning axes in line, or dependent slides.
inline bool solve_slides(const Model& model, const Rigid& pose, Found& found) {
  const Rigid* link = model.link[0];
  int turning[3], slide[3], turns = 0, slides = 0;
  for (int k = 0; k < 6; ++k) (model.prismatic[k] ? slide[slides++] : turning[turns++]) = k;
  // rotations R0 Z(a) R1 Z(b) R2 Z(c) R3, the links between turns lumped
  Rigid lump[4];
  for (int part = 0; part < 4; ++part) {
    const int from = part == 0 ? 0 : turning[part - 1] + 1, to = part == 3 ? 6 : turning[part];
    lump[part] = kNoMotion;
    for (int k = from; k <= to; ++k) lump[part] = lump[part] * link[k];
    lump[part].t = {0, 0, 0};
  }
  const Rigid goal = in_lengths(pose, model.scale), k = inverse(lump[0]) * goal * inverse(lump[3]);
  const Rigid &m = lump[1], &n = lump[2];
  const double a = m.x.z * n.z.x + m.y.z * n.z.y, b = m.y.z * n.z.x - m.x.z * n.z.y;
  const double reach = __builtin_sqrt(a * a + b * b), want = k.z.z - m.z.z * n.z.z;
  if (!(reach > kThreeSlidesReach)) return false;
  double ratio = want / reach;
  if (__builtin_fabs(ratio) > 1 + kThreeSlidesReach) return true;
  ratio = ratio > 1 ? 1 : ratio < -1 ? -1 : ratio;
  const double middle = __builtin_atan2(b, a), half = __builtin_atan2(__builtin_sqrt((1 - ratio) * (1 + ratio)), ratio);
  bool isolated = true;
  Roles roles;
  roles.assign(0, 0, model.prismatic);
  Rigid loop[6];
  role_links(model, 0, roles, pose, loop);
  for (int side = -1; side <= 1; side += 2) {
    double q[6] = {};
    q[turning[1]] = middle + side * half;
    const Rigid inner = joint(m, q[turning[1]], false) * n;  // Z(a) inner Z(c) = k
    if (inner.z.x * inner.z.x + inner.z.y * inner.z.y < kThreeSlidesInLine) {
      isolated = false;  // first and last turning axis in line: only their sum counts
      q[turning[2]] = __builtin_atan2(dot(inner.y, k.x), dot(inner.x, k.x));
    } else {
      q[turning[0]] = __builtin_atan2(k.z.y * inner.z.x - k.z.x * inner.z.y, k.z.x * inner.z.x + k.z.y * inner.z.y);
      q[turning[2]] = __builtin_atan2(k.x.z * inner.y.z - k.y.z * inner.x.z, k.x.z * inner.x.z + k.y.z * inner.y.z);
    }
    Vec3 along[3];
    int s = 0;
    auto motion = [&](int i) { return motion_of(q[i], model.prismatic[i]); };
    const Rigid end = walk(
        6, link[0], [&](int i) -> const Rigid& { return link[i + 1]; }, motion, model.prismatic,
        [&](int i, const Rigid& frame) {
          if (model.prismatic[i]) along[s++] = frame.z;
        });
    double d[3];
    if (!slides_between(along, goal.t - end.t, d)) {
      isolated = false;
      continue;
    }
    for (int i = 0; i < 3; ++i) q[slide[i]] = d[i];
    Motion<double> joints[6];
    for (int i = 0; i < 6; ++i) joints[i] = motion(i);
    const Closure<double> closed = polish(loop, roles, joints, 4);
    const double size = 1 + __builtin_fabs(d[0]) + __builtin_fabs(d[1]) + __builtin_fabs(d[2]);
    if (!(closed.residual < kGeneralVerified * size)) {
      isolated = false;  // the outer axes are in line to half the digits: what stands there is not told
      continue;
    }
    for (int i = 0; i < 6; ++i) q[i] = model.prismatic[i] ? joints[i].c : __builtin_atan2(joints[i].s, joints[i].c);
    insert(found, q, closed.sigma, closed.residual, model.prismatic);
  }
  return isolated;
}

}  // namespace pieper::PIEPER_ISA::general
