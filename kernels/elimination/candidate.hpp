// From a hidden angle to a joint vector: null vector, pair, then the eliminated roles and the dropped one.
// Templates over the number type.
#pragma once

#include "elimination/pencil.hpp"

namespace pieper::PIEPER_ISA::general {

// The two angles' common work: (sn : cn) is a half-angle tangent from the chart, or a length as a ratio.
template <class F> PIEPER_INLINE Motion<F> pair_value(F sn, F cn, bool prismatic, double chart_c, double chart_s) {
  if (prismatic) return {sn / select(abs(cn) > kInfiniteLength, cn, F(kInfiniteLength)), F(0.0)};
  const F n = sn * sn + cn * cn, inv = 1.0 / select(n > kTiny, n, F(1.0));
  const F a = (cn * cn - sn * sn) * inv, b = 2.0 * sn * cn * inv;
  return {a * chart_c - b * chart_s, b * chart_c + a * chart_s};
}

// Null vector of the triangle left by `triangulate` (one inverse iteration step with the triangle's own right side).
template <class F> PIEPER_INLINE void null_vector(F (&m)[6][6], const double* start, F* v) {
  F y[6];
  F largest = kTiny;
  for (int k = 0; k < 6; ++k) largest = max(largest, abs(m[k][k]));
  const F floor = largest * kNullPivot;
  for (int k = 0; k < 6; ++k) {
    F t = start[k];
    for (int r = 0; r < k; ++r) t -= m[r][k] * y[r];
    m[k][k] = select(abs(m[k][k]) > floor, m[k][k], floor);
    y[k] = t / m[k][k];
  }
  for (int pass = 0; pass < 2; ++pass) {
    F size = kTiny;
    for (int k = 0; k < 6; ++k) size = max(size, abs(y[k]));
    const F inv = 1.0 / size;
    for (int k = 5; k >= 0; --k) {
      F t = y[k] * inv;
      for (int r = k + 1; r < 6; ++r) t -= m[k][r] * v[r];
      v[k] = t / m[k][k];
    }
    if (pass == 1) break;
    size = F(kTiny);
    for (int k = 0; k < 6; ++k) size = max(size, abs(v[k]));
    const F again = 1.0 / size;
    for (int k = 0; k < 6; ++k) {
      F t = v[k] * again;
      for (int r = 0; r < k; ++r) t -= m[r][k] * y[r];
      y[k] = t / m[k][k];
    }
  }
}

template <class F> void complete_candidate(const Equations<F>& eq, const RightSide<F>& right, const RigidT<F>* link,
                                           const Roles& roles, const Charts& chart, int layout, bool swap,
                                           const double* start, F c3, F s3, Motion<F>* out) {
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
  out[y_role] = pair_value(ys, yc, roles.prismatic[y_role], swap ? chart.c5 : chart.c4, swap ? chart.s5 : chart.s4);
  out[x_role] = pair_value(xs, xc, roles.prismatic[x_role], swap ? chart.c4 : chart.c5, swap ? chart.s4 : chart.s5);
  out[2] = {c3, s3};

  Line<F> x = {link[4].t, link[4].z};
  for (int role = 4; role >= 2; --role) {
    if (roles.prismatic[role]) x.p.z += out[role].c;
    else turn(x, out[role].c, out[role].s);
    x = move(link[role - 1], x);
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
    out[0].c = select(det > kSlideRole * a11 * a22, c1 / select(det > kTiny, det, F(1.0)),
                      b1 / select(a11 > kTiny, a11, F(1.0)));
    out[0].s = F(0.0);
    c1 = out[0].c;
    s1 = c1 * c1;
  } else {
    const F n = c1 * c1 + s1 * s1, inv = 1.0 / sqrt(select(n > kTiny, n, F(1.0)));
    c1 = select(n > kTiny, c1 * inv, F(1.0));
    s1 = select(n > kTiny, s1 * inv, F(0.0));
    out[0].c = c1;
    out[0].s = s1;
  }
  F er = 0.0, ei = 0.0;
  for (int m = 0; m < 4; ++m) {
    const Complex<F>* h = right.turned[m];
    const Complex<F> at = {h[0].re + c1 * h[1].re + s1 * h[2].re, h[0].im + c1 * h[1].im + s1 * h[2].im};
    const Complex<F> t = conj_times(Complex<F>{value[6 + 2 * m], value[7 + 2 * m]}, at);
    er += t.re;
    ei += t.im;
  }
  F n = er * er + ei * ei, inv = 1.0 / sqrt(select(n > kTiny, n, F(1.0)));
  out[1].c = select(n > kTiny, er * inv, F(1.0));
  out[1].s = select(n > kTiny, ei * inv, F(0.0));
  // Role 6: carry the first axis of the inverse last link back through the chain.
  Vec3T<F> g = {link[5].x.x, link[5].y.x, link[5].z.x};
  for (int role = 0; role < 5; ++role) {
    const Motion<F> m = out[role];
    if (!roles.prismatic[role]) g = {m.c * g.x + m.s * g.y, m.c * g.y - m.s * g.x, g.z};
    g = turn_back(link[role], g);
  }
  n = g.x * g.x + g.y * g.y;
  inv = 1.0 / sqrt(select(n > kTiny, n, F(1.0)));
  out[5] = {select(n > kTiny, g.x * inv, F(1.0)), select(n > kTiny, g.y * inv, F(0.0))};
}

}  // namespace pieper::PIEPER_ISA::general
