// Newton's method on the loop itself: from an approximate joint vector to one that closes to machine precision.
// A template over the number type: the step of chain/newton_step.hpp undamped, for candidates in lanes; the careful closed forms damp it.
#pragma once

#include "elimination/candidate.hpp"

namespace pieper::PIEPER_ISA::general {

// What a polish leaves behind, in scaled lengths and radians.
template <class F> struct Closure {
  F residual;  // of position and rotation together, at the returned joints
  F sigma;     // an estimate (from above) of the smallest singular value of the Jacobian
};

// Small rotation of (c, s) by an angle of at most about one half, renormalised.
template <class F> PIEPER_INLINE Motion<F> advanced(Motion<F> m, F d) {
  const F t = d * d;
  const F sd = d * (1.0 + t * (-1.0 / 6 + t * (1.0 / 120 - t * (1.0 / 5040))));
  const F cd = 1.0 + t * (-0.5 + t * (1.0 / 24 + t * (-1.0 / 720 + t * (1.0 / 40320))));
  const F a = m.c * cd - m.s * sd, b = m.s * cd + m.c * sd;
  const F n = 1.5 - 0.5 * (a * a + b * b);
  return {a * n, b * n};
}

// How far the loop is from closing: m is [J | error] with J's columns for roles 1..6.
template <class F> PIEPER_INLINE F loop_error(const RigidT<F>* link, const RigidT<F>& goal, const Roles& roles,
                                              const Motion<F>* q, F (&m)[6][7]) {
  F column[6][6];
  const RigidT<F> nothing = spread<F>(kNoMotion);
  const Miss<F> miss = missed_by(
      6, nothing, [&](int k) { return k < 5 ? link[k] : nothing; }, [&](int k) { return q[k]; }, roles.prismatic, goal,
      column);
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) m[i][k] = column[k][i];
  m[0][6] = miss.p.x, m[1][6] = miss.p.y, m[2][6] = miss.p.z, m[3][6] = miss.w.x, m[4][6] = miss.w.y,
  m[5][6] = miss.w.z;
  const F trace = dot(miss.end.x, goal.x) + dot(miss.end.y, goal.y) + dot(miss.end.z, goal.z);
  // half a turn away the cross products vanish too: such an end is no end
  return sqrt(dot(miss.p, miss.p) + dot(miss.w, miss.w)) + select(trace < 1.0, F(1.0), F(0.0));
}

// At most `steps` steps; a lane is done when its residual has stopped shrinking. Near a double root Newton only halves the error
// (and quarters the residual), so it takes a dozen steps more there.
template <class F> Closure<F> polish(const RigidT<F>* link, const Roles& roles, Motion<F>* q, int steps) {
  const RigidT<F> goal = inverse(link[5]);
  Closure<F> out;
  Motion<F> best[6];
  for (int k = 0; k < 6; ++k) best[k] = q[k];
  F m[6][7];
  out.residual = F(kEndless);
  out.sigma = F(0.0);
  F before = F(kEndless);
  auto active =
      mask_of<F>(true);  // a finished lane is left alone, so that its answer does not depend on its neighbours
  for (int step = 0;; ++step) {
    const F size = loop_error(link, goal, roles, q, m);
    const auto better = (size < out.residual) & active;
    for (int k = 0; k < 6; ++k) {
      best[k].c = select(better, q[k].c, best[k].c);
      best[k].s = select(better, q[k].s, best[k].s);
    }
    out.residual = select(better, size, out.residual);
    triangulate(m, 6);
    F smallest = abs(m[0][0]);
    for (int k = 1; k < 6; ++k) smallest = min(smallest, abs(m[k][k]));
    const auto done = ((size < kPolishStalled) & (size > 0.4 * before)) | (size < kPolishDone) |
                      ((size < kPolishDoneRegular) & (smallest > kPolishRegular));
    const auto lost = size > F(step < 8 ? kEndless : kPolishLost);
    before = size;
    active = active & !(done | lost);
    if (step == steps || !any(active)) break;
    F d[6];
    newton_step(m, 6, kPolishPivot, kPolishLongestStep, d);
    for (int k = 0; k < 6; ++k) {
      const Motion<F> next = roles.prismatic[k] ? Motion<F>{q[k].c + d[k], q[k].s} : advanced(q[k], d[k]);
      q[k].c = select(active, next.c, q[k].c);
      q[k].s = select(active, next.s, q[k].s);
    }
  }
  // one step of inverse iteration on R^T R
  F y[6], z[6], ny = 0.0, nz = 0.0;
  for (int k = 0; k < 6; ++k) {
    F t = 1.0;
    for (int r = 0; r < k; ++r) t -= m[r][k] * y[r];
    y[k] = t / select(abs(m[k][k]) > kPolishSigmaPivot, m[k][k], F(kPolishSigmaPivot));
    ny += y[k] * y[k];
  }
  for (int k = 5; k >= 0; --k) {
    F t = y[k];
    for (int j = k + 1; j < 6; ++j) t -= m[k][j] * z[j];
    z[k] = t / select(abs(m[k][k]) > kPolishSigmaPivot, m[k][k], F(kPolishSigmaPivot));
    nz += z[k] * z[k];
  }
  out.sigma = sqrt(ny / select(nz > kTiny, nz, F(kTiny)));
  for (int k = 0; k < 6; ++k) q[k] = best[k];
  return out;
}

}  // namespace pieper::PIEPER_ISA::general
