// The pair of equations M f(a) + N f(c) = e (see closed_form/careful/pair.hpp) for many poses at once. It answers only where all is clear.
// A template over the number type; the careful scalar twin is closed_form/careful/pair.hpp.
#pragma once

#include "closed_form/lanes/quartic.hpp"
#include "closed_form/careful/pair.hpp"
#include "lanes/unit_angle.hpp"

namespace pieper::PIEPER_ISA::closed_form {

// The angle of a revolute joint, the way of a sliding one.
template <class F> PIEPER_INLINE F joint_value(Motion<F> m, bool slides) {
  return slides ? m.c : unit_angle_wrapped(m.s, m.c);
}

template <class F> struct PairLanes {
  F M[2][2], N[2][2], e[2];
  bool slides_a, slides_c;
  bool hide_c;   // which joint the quartic is in
  bool apart;    // M (first_c) or N is of rank one whatever the pose: no quartic
  bool first_c;  // which joint comes first where the equations fall apart
  Motion<F> a[4], c[4];
  F angle_a[4], angle_c[4];  // rad, or lengths of the arm
  Mask<F> found[4];
  Mask<F> unclear;
};

// Two roots, of which `room` is the square of half the difference, are about to merge or have just gone.
template <class F> PIEPER_INLINE Mask<F> about_zero(F room, F size) {
  return !((room > kRootsMerge * size) | (room < -kRootsGone * size));
}

// Both values of one joint from b . f(x) = rhs.
template <class F>
PIEPER_INLINE void one_joint(const F* b, F rhs, bool slides, Motion<F>* x, Mask<F>& found, Mask<F>& unclear) {
  if (slides) {
    F disc = b[0] * b[0] + 4.0 * b[1] * rhs, size = b[0] * b[0] + abs(4.0 * b[1] * rhs);
    Mask<F> linear = abs(b[1]) <= kPairLinear * abs(b[0]);
    found = disc >= 0.0;
    // beside it lengths of the arm were added up to rhs: a slide so near zero drowns in their rounding
    unclear = unclear | about_zero(disc, size + abs(b[1])) | !(size > kPairNothing);
    F root = sqrt(max(disc, F(0.0))), t = b[0] + select(b[0] < 0.0, -root, root);
    F near = 2.0 * rhs / select(t == 0.0, F(1.0), t);
    F far = -t / select(linear, F(1.0), 2.0 * b[1]);
    far = select(linear, near, far);
    x[0] = {near, near * near};
    x[1] = {far, far * far};
    return;
  }
  F size2 = b[0] * b[0] + b[1] * b[1], room = size2 - rhs * rhs;
  found = room > 0.0;
  unclear = unclear | about_zero(room, size2) | !(size2 > kPairRounding);
  F k = 1.0 / select(size2 > 0.0, size2, F(1.0)), side = sqrt(max(room, F(0.0)));
  x[0] = {(b[0] * rhs - b[1] * side) * k, (b[1] * rhs + b[0] * side) * k};
  x[1] = {(b[0] * rhs + b[1] * side) * k, (b[1] * rhs - b[0] * side) * k};
}

// A row that annihilates a rank-one 2x2; its larger entry is 1.
template <class F> PIEPER_INLINE void left_null(const F (*A)[2], F* u, Mask<F>& upper, F& size) {
  F r0 = A[0][0] * A[0][0] + A[0][1] * A[0][1], r1 = A[1][0] * A[1][0] + A[1][1] * A[1][1];
  F mixed = A[0][0] * A[1][0] + A[0][1] * A[1][1];
  upper = r0 >= r1;
  size = select(upper, r0, r1);
  F lean = -mixed / select(size > 0.0, size, F(1.0));
  u[0] = select(upper, lean, F(1.0));
  u[1] = select(upper, F(1.0), lean);
}

// The matrix V of one joint is of rank one: a combination of the equations holds the other joint h alone, what is left gives v.
template <class F> __attribute__((noinline)) void solve_apart(PairLanes<F>& s) {
  const bool first_c = s.first_c;
  const auto& V = first_c ? s.M : s.N;
  const auto& H = first_c ? s.N : s.M;
  const bool slides_v = first_c ? s.slides_a : s.slides_c, slides_h = first_c ? s.slides_c : s.slides_a;
  F u[2], size_v, angle[2];
  Mask<F> upper, alone;
  left_null(V, u, upper, size_v);
  F b[2] = {u[0] * H[0][0] + u[1] * H[1][0], u[0] * H[0][1] + u[1] * H[1][1]};
  F size_h = H[0][0] * H[0][0] + H[0][1] * H[0][1] + H[1][0] * H[1][0] + H[1][1] * H[1][1];
  // one order for all poses of an arm; it will do unless the equation of h has nearly vanished
  s.unclear = s.unclear | !((b[0] * b[0] + b[1] * b[1]) > kPairSharp * size_h);
  Motion<F> h[2], v[2];
  one_joint(b, u[0] * s.e[0] + u[1] * s.e[1], slides_h, h, alone, s.unclear);
  F row[2] = {select(upper, V[0][0], V[1][0]), select(upper, V[0][1], V[1][1])};
  F row_h[2] = {select(upper, H[0][0], H[1][0]), select(upper, H[0][1], H[1][1])},
    row_e = select(upper, s.e[0], s.e[1]);
  const bool one_v = slides_v && all(abs(row[1]) <= kPairLinear * abs(row[0])),
             one_h = slides_h && all(abs(b[1]) <= kPairLinear * abs(b[0]));
  for (int i = 0; i < 2; ++i) {
    angle[i] = joint_value(h[i], slides_h);
    Mask<F> found, unclear = mask_of<F>(false);
    one_joint(row, row_e - row_h[0] * h[i].c - row_h[1] * h[i].s, slides_v, v, found, unclear);
    s.unclear = s.unclear | (alone & unclear);
    for (int k = 0; k < 2; ++k) {
      const int n = 2 * i + k;
      s.a[n] = first_c ? v[k] : h[i];
      s.c[n] = first_c ? h[i] : v[k];
      F angle_v = joint_value(v[k], slides_v);
      s.angle_a[n] = first_c ? angle_v : angle[i];
      s.angle_c[n] = first_c ? angle[i] : angle_v;
      s.found[n] = alone & found;
      if ((one_v && k) || (one_h && i)) s.found[n] = mask_of<F>(false);
    }
  }
}

// One Newton step on both equations at once.
template <class F> __attribute__((noinline)) void sharpen(const PairLanes<F>& s, Motion<F>& a, Motion<F>& c,
                                                          Mask<F>& unclear, Mask<F> found) {
  F r[2], ja[2], jc[2];
  for (int k = 0; k < 2; ++k) {
    r[k] = s.e[k] - (s.M[k][0] * a.c + s.M[k][1] * a.s) - (s.N[k][0] * c.c + s.N[k][1] * c.s);
    ja[k] = s.slides_a ? s.M[k][0] + 2.0 * s.M[k][1] * a.c : s.M[k][1] * a.c - s.M[k][0] * a.s;
    jc[k] = s.slides_c ? s.N[k][0] + 2.0 * s.N[k][1] * c.c : s.N[k][1] * c.c - s.N[k][0] * c.s;
  }
  F det = ja[0] * jc[1] - ja[1] * jc[0], scale = ja[0] * ja[0] + ja[1] * ja[1] + jc[0] * jc[0] + jc[1] * jc[1];
  unclear = unclear | (found & !(abs(det) > kPairSharp * scale));
  F k = 1.0 / select(det == 0.0, F(1.0), det);
  F da = (r[0] * jc[1] - r[1] * jc[0]) * k, dc = (ja[0] * r[1] - ja[1] * r[0]) * k;
  unclear = unclear | (found & !((abs(da) < kPairSharpStep) & (abs(dc) < kPairSharpStep)));
  a = s.slides_a ? Motion<F>{a.c + da, (a.c + da) * (a.c + da)} : unit(a.c - a.s * da, a.s + a.c * da);
  c = s.slides_c ? Motion<F>{c.c + dc, (c.c + dc) * (c.c + dc)} : unit(c.c - c.s * dc, c.s + c.c * dc);
}

template <class F> __attribute__((noinline)) void solve_by_quartic(PairLanes<F>& s, F det) {
  const bool hide_c = s.hide_c;
  const auto& V = hide_c ? s.M : s.N;
  const auto& H = hide_c ? s.N : s.M;
  const bool slides_v = hide_c ? s.slides_a : s.slides_c, slides_h = hide_c ? s.slides_c : s.slides_a;
  F E[2][3] = {{s.e[0], -H[0][0], -H[0][1]}, {s.e[1], -H[1][0], -H[1][1]}}, d[2][3];
  for (int k = 0; k < 3; ++k) {
    d[0][k] = E[0][k] * V[1][1] - E[1][k] * V[0][1];
    d[1][k] = V[0][0] * E[1][k] - V[1][0] * E[0][k];
  }
  F g00 = d[0][0] * d[0][0], g01 = 2.0 * d[0][0] * d[0][1], g02 = 2.0 * d[0][0] * d[0][2];
  F g11 = d[0][1] * d[0][1], g12 = 2.0 * d[0][1] * d[0][2], g22 = d[0][2] * d[0][2];
  F scale = g00 + g11 + g22 + det * det;
  if (slides_v) {
    g00 = g00 - det * d[1][0], g01 = g01 - det * d[1][1], g02 = g02 - det * d[1][2];
  } else {
    g00 = g00 + d[1][0] * d[1][0] - det * det, g01 = g01 + 2.0 * d[1][0] * d[1][1], g02 = g02 + 2.0 * d[1][0] * d[1][2];
    g11 = g11 + d[1][1] * d[1][1], g12 = g12 + 2.0 * d[1][1] * d[1][2], g22 = g22 + d[1][2] * d[1][2];
  }
  F f[5], p[4], q[4];
  if (slides_h) {
    f[0] = g00, f[1] = g01, f[2] = g02 + g11, f[3] = g12, f[4] = g22;
  } else {
    f[4] = g00 - g01 + g11;
    f[3] = 2.0 * g02 - 2.0 * g12;
    f[2] = 2.0 * g00 - 2.0 * g11 + 4.0 * g22;
    f[1] = 2.0 * g02 + 2.0 * g12;
    f[0] = g00 + g01 + g11;
  }
  if (slides_h && all((abs(f[3]) + abs(f[4])) <= kPairFree * scale)) {  // a quadratic in disguise
    Motion<F> x[2];
    one_joint(f + 1, -f[0], true, x, s.found[0], s.unclear);
    for (int i = 0; i < 4; ++i) p[i] = x[i % 2].c, q[i] = F(1.0), s.found[i] = i < 2 ? s.found[0] : mask_of<F>(false);
    if (all(abs(f[2]) <= kPairLinear * abs(f[1]))) s.found[1] = mask_of<F>(false);
  } else {
    form_directions(f, kPairFreeUnclear * scale, p, q, s.found, s.unclear);
  }
  F inverse_det = 1.0 / select(det == 0.0, F(1.0), det);
  for (int i = 0; i < 4; ++i) {
    Motion<F> h;
    if (slides_h) {
      Mask<F> far = abs(q[i]) < kPairFar;
      s.found[i] = s.found[i] & !far;
      F x = p[i] / select(far, F(1.0), q[i]);
      h = {x, x * x};
    } else {
      h = {q[i] * q[i] - p[i] * p[i], 2.0 * p[i] * q[i]};
    }
    F v1 = (d[0][0] + d[0][1] * h.c + d[0][2] * h.s) * inverse_det,
      v2 = (d[1][0] + d[1][1] * h.c + d[1][2] * h.s) * inverse_det;
    Motion<F> v = slides_v ? Motion<F>{v1, v1 * v1} : unit(v1, v2);
    s.a[i] = hide_c ? v : h;
    s.c[i] = hide_c ? h : v;
  }
}

template <class F> PIEPER_INLINE void solve_pair(PairLanes<F>& s) {
  s.unclear = mask_of<F>(false);
  if (s.apart) {
    solve_apart(s);
    return;
  }
  const auto& V = s.hide_c ? s.M : s.N;
  F det = V[0][0] * V[1][1] - V[0][1] * V[1][0], size(0.0);
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j) size = size + V[k][j] * V[k][j];
  // one hidden joint for all poses of an arm; where it is badly conditioned the pose is handed back
  s.unclear = s.unclear | !(abs(det) > kPairAlone * size);
  solve_by_quartic(s, det);
#pragma GCC unroll 1
  for (int i = 0; i < 4; ++i) {
    sharpen(s, s.a[i], s.c[i], s.unclear, s.found[i]);
    s.angle_a[i] = joint_value(s.a[i], s.slides_a);
    s.angle_c[i] = joint_value(s.c[i], s.slides_c);
  }
}

}  // namespace pieper::PIEPER_ISA::closed_form
