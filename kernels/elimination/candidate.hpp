// From a hidden angle to a joint vector: null vector, pair, then the eliminated roles and the dropped one.
#pragma once

#include "elimination/pencil.hpp"

namespace pieper::PIEPER_ISA::general {

// Joint values in role order: cosine and sine of a revolute joint; the length (in c) of a prismatic one.
template <class F> struct Joints { F c[6], s[6]; };

// The two angles' common work: (sn : cn) is a half-angle tangent from the chart, or a length as a ratio.
template <class F>
PIEPER_INLINE void pair_value(F sn, F cn, bool prismatic, double chart_c, double chart_s, F& c, F& s) {
  if (prismatic) {
    c = sn / select(abs(cn) > 1e-200, cn, F(1e-200));
    s = F(0.0);
    return;
  }
  const F n = sn * sn + cn * cn, inv = 1.0 / select(n > 1e-300, n, F(1.0));
  const F a = (cn * cn - sn * sn) * inv, b = 2.0 * sn * cn * inv;
  c = a * chart_c - b * chart_s;
  s = b * chart_c + a * chart_s;
}

// Null vector of the triangle left by `triangulate` (one inverse iteration step with the triangle's own right side).
template <class F> PIEPER_INLINE void null_vector(F (&m)[6][6], const double* start, F* v) {
  F y[6];
  F largest = 1e-300;
  for (int k = 0; k < 6; ++k) largest = max(largest, abs(m[k][k]));
  const F floor = largest * 1e-17;
  for (int k = 0; k < 6; ++k) {
    F t = start[k];
    for (int r = 0; r < k; ++r) t -= m[r][k] * y[r];
    m[k][k] = select(abs(m[k][k]) > floor, m[k][k], floor);
    y[k] = t / m[k][k];
  }
  for (int pass = 0; pass < 2; ++pass) {
    F size = 1e-300;
    for (int k = 0; k < 6; ++k) size = max(size, abs(y[k]));
    const F inv = 1.0 / size;
    for (int k = 5; k >= 0; --k) {
      F t = y[k] * inv;
      for (int r = k + 1; r < 6; ++r) t -= m[k][r] * v[r];
      v[k] = t / m[k][k];
    }
    if (pass == 1) break;
    size = F(1e-300);
    for (int k = 0; k < 6; ++k) size = max(size, abs(v[k]));
    const F again = 1.0 / size;
    for (int k = 0; k < 6; ++k) {
      F t = v[k] * again;
      for (int r = 0; r < k; ++r) t -= m[r][k] * y[r];
      y[k] = t / m[k][k];
    }
  }
}

template <class F> void complete_candidate(const Equations<F>& eq, const RightSide<F>& right, const Frame<F>* link,
                                           const Roles& roles, const Charts& chart, int layout, bool swap,
                                           const double* start, F c3, F s3, Joints<F>& out) {
  F e[6][9], six[6][6], v[6];
  at_angle(eq, c3, s3, e);
  if (layout == kTwelve) core(e, six);
  else arrange<F, 6>(e, layout, six);
  triangulate(six, 6);
  null_vector(six, start, v);
  F ys, yc, xs, xc;
  if (layout == kTwoInPair) {
    ys = v[3];
    xs = v[4];
    yc = xc = v[5];
  } else {
    // (y : 1) is the ratio of the two halves, in the direction in which they are one multiple of the other
    const F aa = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const F ab = v[0] * v[3] + v[1] * v[4] + v[2] * v[5];
    const F bb = v[3] * v[3] + v[4] * v[4] + v[5] * v[5];
    const auto upper = aa > bb;
    ys = select(upper, aa, ab);
    yc = select(upper, ab, bb);
    const F w0 = v[0] * ys + v[3] * yc, w1 = v[1] * ys + v[4] * yc, w2 = v[2] * ys + v[5] * yc;
    const auto first = abs(w0) > abs(w2);
    xs = select(first, w0, w1);
    xc = select(first, w1, w2);
  }
  const int y_role = swap ? 4 : 3, x_role = swap ? 3 : 4;
  pair_value(ys, yc, roles.prismatic[y_role], swap ? chart.c5 : chart.c4, swap ? chart.s5 : chart.s4, out.c[y_role],
             out.s[y_role]);
  pair_value(xs, xc, roles.prismatic[x_role], swap ? chart.c4 : chart.c5, swap ? chart.s4 : chart.s5, out.c[x_role],
             out.s[x_role]);
  out.c[2] = c3;
  out.s[2] = s3;

  Line<F> x;
  for (int i = 0; i < 3; ++i) {
    x.p[i] = link[4].p[i];
    x.l[i] = link[4].r[i][2];
  }
  for (int role = 4; role >= 2; --role) {
    if (roles.prismatic[role]) x.p[2] += out.c[role];
    else turn(x, out.c[role], out.s[role]);
    move(x, link[role - 1]);
  }
  F value[14];
  features(x, value);
  // Role 1 from everything linear in its functions: the six real features, and the turned ones crossed against each
  // other so that role 2 drops out (X_j h_k = X_k h_j).
  F a11 = 0.0, a12 = 0.0, a22 = 0.0, b1 = 0.0, b2 = 0.0;
  auto add = [&](F g1, F g2, F rest) {
    a11 += g1 * g1;
    a12 += g1 * g2;
    a22 += g2 * g2;
    b1 += g1 * rest;
    b2 += g2 * rest;
  };
  for (int m = 0; m < 6; ++m) add(right.real[m][1], right.real[m][2], value[m] - right.real[m][0]);
  for (int j = 0; j < 2; ++j)
    for (int k = j + 1; k < 3; ++k) {
      Complex<F> g[3];
      for (int t = 0; t < 3; ++t) {
        const Complex<F> p = Complex<F>{value[6 + 2 * j], value[7 + 2 * j]} * right.turned[k][t];
        const Complex<F> q = Complex<F>{value[6 + 2 * k], value[7 + 2 * k]} * right.turned[j][t];
        g[t] = {p.re - q.re, p.im - q.im};
      }
      add(g[1].re, g[2].re, 0.0 - g[0].re);
      add(g[1].im, g[2].im, 0.0 - g[0].im);
    }
  F c1 = b1 * a22 - b2 * a12, s1 = b2 * a11 - b1 * a12;
  if (roles.prismatic[0]) {
    const F det = a11 * a22 - a12 * a12;
    out.c[0] =
        select(det > 1e-12 * a11 * a22, c1 / select(det > 1e-300, det, F(1.0)), b1 / select(a11 > 1e-300, a11, F(1.0)));
    out.s[0] = F(0.0);
    c1 = out.c[0];
    s1 = c1 * c1;
  } else {
    const F n = c1 * c1 + s1 * s1, inv = 1.0 / sqrt(select(n > 1e-300, n, F(1.0)));
    c1 = select(n > 1e-300, c1 * inv, F(1.0));
    s1 = select(n > 1e-300, s1 * inv, F(0.0));
    out.c[0] = c1;
    out.s[0] = s1;
  }
  F er = 0.0, ei = 0.0;
  for (int m = 0; m < 4; ++m) {
    const Complex<F>* h = right.turned[m];
    const Complex<F> at = {h[0].re + c1 * h[1].re + s1 * h[2].re, h[0].im + c1 * h[1].im + s1 * h[2].im};
    const Complex<F> t = conj_times(Complex<F>{value[6 + 2 * m], value[7 + 2 * m]}, at);
    er += t.re;
    ei += t.im;
  }
  F n = er * er + ei * ei, inv = 1.0 / sqrt(select(n > 1e-300, n, F(1.0)));
  out.c[1] = select(n > 1e-300, er * inv, F(1.0));
  out.s[1] = select(n > 1e-300, ei * inv, F(0.0));
  // Role 6: carry the first axis of the inverse last link back through the chain.
  F g[3] = {link[5].r[0][0], link[5].r[0][1], link[5].r[0][2]};
  for (int role = 0; role < 5; ++role) {
    const Frame<F>& a = link[role];
    if (!roles.prismatic[role]) {
      const F t = out.c[role] * g[0] + out.s[role] * g[1];
      g[1] = out.c[role] * g[1] - out.s[role] * g[0];
      g[0] = t;
    }
    const F h[3] = {g[0], g[1], g[2]};
    for (int i = 0; i < 3; ++i) g[i] = a.r[0][i] * h[0] + a.r[1][i] * h[1] + a.r[2][i] * h[2];
  }
  n = g[0] * g[0] + g[1] * g[1];
  inv = 1.0 / sqrt(select(n > 1e-300, n, F(1.0)));
  out.c[5] = select(n > 1e-300, g[0] * inv, F(1.0));
  out.s[5] = select(n > 1e-300, g[1] * inv, F(0.0));
}

}  // namespace pieper::PIEPER_ISA::general
