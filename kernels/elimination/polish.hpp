// Newton's method on the loop itself: from an approximate joint vector to one that closes to machine precision.
#pragma once

#include "elimination/candidate.hpp"

namespace pieper::PIEPER_ISA::general {

// What a polish leaves behind, in scaled lengths and radians.
template <class F> struct Closure {
  F residual;  // of position and rotation together, at the returned joints
  F sigma;     // an estimate (from above) of the smallest singular value of the Jacobian
};

// Small rotation of (c, s) by an angle of at most about one half, renormalised.
template <class F> PIEPER_INLINE void advance(F& c, F& s, F d) {
  const F t = d * d;
  const F sd = d * (1.0 + t * (-1.0 / 6 + t * (1.0 / 120 - t * (1.0 / 5040))));
  const F cd = 1.0 + t * (-0.5 + t * (1.0 / 24 + t * (-1.0 / 720 + t * (1.0 / 40320))));
  const F a = c * cd - s * sd, b = s * cd + c * sd;
  const F n = 1.5 - 0.5 * (a * a + b * b);
  c = a * n;
  s = b * n;
}

// Error twist of the loop and, when wanted, its Jacobian: m is [J | error] with J's columns for roles 1..6.
template <class F> PIEPER_INLINE F loop_error(const Frame<F>* link, const Frame<F>& goal, const Roles& roles,
                                              const Joints<F>& q, F (&m)[6][7]) {
  Frame<F> at;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) at.r[i][j] = F(i == j ? 1.0 : 0.0);
    at.p[i] = 0.0;
  }
  F origin[6][3];
  for (int k = 0; k < 6; ++k) {
    for (int i = 0; i < 3; ++i) {
      m[3 + i][k] = at.r[i][2];
      if (roles.prismatic[k]) at.p[i] += q.c[k] * at.r[i][2];
      origin[k][i] = at.p[i];
    }
    if (!roles.prismatic[k])
      for (int i = 0; i < 3; ++i) {
        const F t = at.r[i][0] * q.c[k] + at.r[i][1] * q.s[k];
        at.r[i][1] = at.r[i][1] * q.c[k] - at.r[i][0] * q.s[k];
        at.r[i][0] = t;
      }
    if (k < 5) at = at * link[k];
  }
  for (int k = 0; k < 6; ++k) {
    const F z[3] = {m[3][k], m[4][k], m[5][k]};
    if (roles.prismatic[k]) {
      for (int i = 0; i < 3; ++i) {
        m[i][k] = z[i];
        m[3 + i][k] = 0.0;
      }
    } else {
      const F a[3] = {at.p[0] - origin[k][0], at.p[1] - origin[k][1], at.p[2] - origin[k][2]};
      m[0][k] = z[1] * a[2] - z[2] * a[1];
      m[1][k] = z[2] * a[0] - z[0] * a[2];
      m[2][k] = z[0] * a[1] - z[1] * a[0];
    }
  }
  F w[3] = {F(0.0), F(0.0), F(0.0)}, trace = 0.0, size = 0.0;
  for (int j = 0; j < 3; ++j) {
    w[0] += at.r[1][j] * goal.r[2][j] - at.r[2][j] * goal.r[1][j];
    w[1] += at.r[2][j] * goal.r[0][j] - at.r[0][j] * goal.r[2][j];
    w[2] += at.r[0][j] * goal.r[1][j] - at.r[1][j] * goal.r[0][j];
    trace += at.r[0][j] * goal.r[0][j] + at.r[1][j] * goal.r[1][j] + at.r[2][j] * goal.r[2][j];
  }
  for (int i = 0; i < 3; ++i) {
    m[i][6] = goal.p[i] - at.p[i];
    m[3 + i][6] = 0.5 * w[i];
    size += m[i][6] * m[i][6] + m[3 + i][6] * m[3 + i][6];
  }
  // half a turn away the cross products vanish too: such an end is no end
  return sqrt(size) + select(trace < 1.0, F(1.0), F(0.0));
}

// At most `steps` steps; a lane is done when its residual has stopped shrinking. Near a double root Newton only halves the error
// (and quarters the residual), so it takes a dozen steps more there.
template <class F> Closure<F> polish(const Frame<F>* link, const Roles& roles, Joints<F>& q, int steps) {
  const Frame<F> goal = inverse(link[5]);
  Closure<F> out;
  Joints<F> best = q;
  F m[6][7];
  out.residual = F(1e300);
  out.sigma = F(0.0);
  F before = F(1e300);
  auto active =
      mask_of<F>(true);  // a finished lane is left alone, so that its answer does not depend on its neighbours
  for (int step = 0;; ++step) {
    const F size = loop_error(link, goal, roles, q, m);
    const auto better = (size < out.residual) & active;
    for (int k = 0; k < 6; ++k) {
      best.c[k] = select(better, q.c[k], best.c[k]);
      best.s[k] = select(better, q.s[k], best.s[k]);
    }
    out.residual = select(better, size, out.residual);
    triangulate(m, 6);
    F smallest = abs(m[0][0]);
    for (int k = 1; k < 6; ++k) smallest = min(smallest, abs(m[k][k]));
    const auto done = ((size < 1e-14) & (size > 0.4 * before)) | (size < 3e-16) | ((size < 2e-15) & (smallest > 1e-3));
    const auto lost = size > F(step < 8 ? 1e300 : 0.05);
    before = size;
    active = active & !(done | lost);
    if (step == steps || !any(active)) break;
    F d[6], largest = 0.0;
    for (int k = 5; k >= 0; --k) {
      F t = m[k][6];
      for (int j = k + 1; j < 6; ++j) t -= m[k][j] * d[j];
      const F pivot = m[k][k];
      d[k] = t / select(abs(pivot) > 1e-15, pivot, F(1e-15));
      largest = max(largest, abs(d[k]));
    }
    const F shrink = select(largest > 0.4, 0.4 / select(largest > 0.4, largest, F(1.0)), F(1.0));
    for (int k = 0; k < 6; ++k) {
      if (roles.prismatic[k]) q.c[k] += shrink * d[k];
      else advance(q.c[k], q.s[k], shrink * d[k]);
    }
  }
  // one step of inverse iteration on R^T R
  F y[6], z[6], ny = 0.0, nz = 0.0;
  for (int k = 0; k < 6; ++k) {
    F t = 1.0;
    for (int r = 0; r < k; ++r) t -= m[r][k] * y[r];
    y[k] = t / select(abs(m[k][k]) > 1e-30, m[k][k], F(1e-30));
    ny += y[k] * y[k];
  }
  for (int k = 5; k >= 0; --k) {
    F t = y[k];
    for (int j = k + 1; j < 6; ++j) t -= m[k][j] * z[j];
    z[k] = t / select(abs(m[k][k]) > 1e-30, m[k][k], F(1e-30));
    nz += z[k] * z[k];
  }
  out.sigma = sqrt(ny / select(nz > 1e-300, nz, F(1e-300)));
  q = best;
  return out;
}

}  // namespace pieper::PIEPER_ISA::general
