// The closed loop of a six-joint chain as the general solver sees it: rigid frames, joint roles, the fourteen features.
//
// The chain closes on itself, Z1 L1 Z2 L2 ... Z6 L6 = 1, with the pose inside one of the links. Starting the loop at another
// joint, or walking it backwards, renames the joints: twelve ways to hand out the same six *roles*
//   1, 2 eliminated by linear algebra; 3 hidden (the one unknown of the eigenvalue problem); 4, 5 the pair whose monomials
//   are the unknown vector; 6 dropped (the features are those of the line of its axis).
#pragma once

#include "lanes/lanes.hpp"

namespace pieper::PIEPER_ISA::general {

template <class F> struct Frame { F r[3][3], p[3]; };

template <class F> struct Complex { F re, im; };
template <class F> PIEPER_INLINE Complex<F> operator*(Complex<F> a, Complex<F> b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class F> PIEPER_INLINE Complex<F> conj_times(Complex<F> a, Complex<F> b) {  // conj(a) b
  return {a.re * b.re + a.im * b.im, a.re * b.im - a.im * b.re};
}

template <class F> Frame<F> spread(const Frame<double>& a) {
  Frame<F> out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.r[i][j] = F(a.r[i][j]);
    out.p[i] = F(a.p[i]);
  }
  return out;
}

template <class F> Frame<F> operator*(const Frame<F>& a, const Frame<F>& b) {
  Frame<F> out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.r[i][j] = a.r[i][0] * b.r[0][j] + a.r[i][1] * b.r[1][j] + a.r[i][2] * b.r[2][j];
    out.p[i] = a.r[i][0] * b.p[0] + a.r[i][1] * b.p[1] + a.r[i][2] * b.p[2] + a.p[i];
  }
  return out;
}

template <class F> Frame<F> inverse(const Frame<F>& a) {
  Frame<F> out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.r[i][j] = a.r[j][i];
    out.p[i] = 0.0 - (a.r[0][i] * a.p[0] + a.r[1][i] * a.p[1] + a.r[2][i] * a.p[2]);
  }
  return out;
}

// A half turn about x on both sides turns an inverse joint motion into a forward one: Z(q)^-1 = X Z(q) X.
template <class F> Frame<F> flipped(const Frame<F>& a) {
  Frame<F> out = a;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if ((i == 0) != (j == 0)) out.r[i][j] = 0.0 - a.r[i][j];
  out.p[1] = 0.0 - a.p[1];
  out.p[2] = 0.0 - a.p[2];
  return out;
}

// How a variant of the elimination hands out the roles. `joint[k]` is the 0-based joint that plays role k + 1.
struct Roles {
  int shift, reverse;
  int joint[6];
  bool prismatic[6];
  int pose_link;  // 0-based role link that holds the pose

  void assign(int first, int backwards, const bool* is_prismatic) {
    shift = first;
    reverse = backwards;
    for (int k = 0; k < 6; ++k) {
      const int at = (k + shift) % 6;
      joint[k] = reverse ? 5 - at : at;
      prismatic[k] = is_prismatic[joint[k]];
      if (loop_link(k) == 5) pose_link = k;
    }
  }
  // Which loop link (5 holds the pose) follows role k, when walking in this variant's direction.
  int loop_link(int k) const {
    const int at = (k + shift) % 6;
    return reverse ? (10 - at) % 6 : at;
  }
};

// The line of an axis: a point on it and its direction, moved along by links and joints.
template <class F> struct Line { F p[3], l[3]; };

template <class F> PIEPER_INLINE void move(Line<F>& x, const Frame<F>& a) {
  const Line<F> y = x;
  for (int i = 0; i < 3; ++i) {
    x.p[i] = a.r[i][0] * y.p[0] + a.r[i][1] * y.p[1] + a.r[i][2] * y.p[2] + a.p[i];
    x.l[i] = a.r[i][0] * y.l[0] + a.r[i][1] * y.l[1] + a.r[i][2] * y.l[2];
  }
}

template <class F> PIEPER_INLINE void move_back(Line<F>& x, const Frame<F>& a) {
  Line<F> y = x;
  for (int i = 0; i < 3; ++i) y.p[i] = y.p[i] - a.p[i];
  for (int i = 0; i < 3; ++i) {
    x.p[i] = a.r[0][i] * y.p[0] + a.r[1][i] * y.p[1] + a.r[2][i] * y.p[2];
    x.l[i] = a.r[0][i] * y.l[0] + a.r[1][i] * y.l[1] + a.r[2][i] * y.l[2];
  }
}

template <class F> PIEPER_INLINE void turn(Line<F>& x, F c, F s) {
  F t = c * x.p[0] - s * x.p[1];
  x.p[1] = s * x.p[0] + c * x.p[1];
  x.p[0] = t;
  t = c * x.l[0] - s * x.l[1];
  x.l[1] = s * x.l[0] + c * x.l[1];
  x.l[0] = t;
}

// Raghavan and Roth's fourteen functions of a line (1993): six that a rotation about z leaves alone,
//   p_z, l_z, p.p, p.l, (p x l)_z, ((p.p) l - 2 (p.l) p)_z,
// and the x, y parts of p, l, p x l, (p.p) l - 2 (p.l) p, which it turns like four complex numbers.
template <class F> PIEPER_INLINE void features(const Line<F>& x, F* out) {
  const F *p = x.p, *l = x.l;
  const F pp = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  const F pl = p[0] * l[0] + p[1] * l[1] + p[2] * l[2];
  const F twice = pl + pl;
  out[0] = p[2];
  out[1] = l[2];
  out[2] = pp;
  out[3] = pl;
  out[4] = p[0] * l[1] - p[1] * l[0];
  out[5] = pp * l[2] - twice * p[2];
  out[6] = p[0];
  out[7] = p[1];
  out[8] = l[0];
  out[9] = l[1];
  out[10] = p[1] * l[2] - p[2] * l[1];
  out[11] = p[2] * l[0] - p[0] * l[2];
  out[12] = pp * l[0] - twice * p[0];
  out[13] = pp * l[1] - twice * p[1];
}

}  // namespace pieper::PIEPER_ISA::general
