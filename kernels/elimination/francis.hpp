// Francis' double-shift QR for several matrices at once: every lane has its own window and shifts, all sweep together.
//
// Deflation and shifts are scalar per lane (a few loads); the sweeps, which are nearly all of the work, run in lockstep over the
// union of the windows. Outside a lane's own window its reflection is the identity, so nothing needs a mask but the
// reflection's making. A template over the number type.
#pragma once

#include "elimination/hessenberg.hpp"

namespace pieper::PIEPER_ISA::general {

// The state of one lane's iteration.
struct Window {
  int low, high, trial, found;
  double norm;
};

// Takes eigenvalues off the lower end of the window while they have converged; afterwards high < 0, or the window has size > 2.
template <class F, int N> void deflate(F (&a)[N][N], int lane_index, Window& w, double* re, double* im) {
  constexpr double eps = 2.220446049250313e-16;
  const int i = lane_index;
  while (w.high >= 0) {
    int low = w.high;
    for (; low > 0; --low) {
      double s = __builtin_fabs(lane(a[low - 1][low - 1], i)) + __builtin_fabs(lane(a[low][low], i));
      // a cluster may keep rounding of the size of the whole matrix alive: after a while that counts as zero too
      if (s == 0 || (w.trial > 15 && s < 0.1 * w.norm)) s = 0.1 * w.norm;
      if (__builtin_fabs(lane(a[low][low - 1], i)) <= eps * s) {
        set_lane(a[low][low - 1], i, 0.0);
        break;
      }
    }
    w.low = low;
    const int h = w.high;
    if (low < h - 1) return;
    const double x = lane(a[h][h], i);
    if (low == h) {
      re[w.found] = x;
      im[w.found++] = 0;
      --w.high;
    } else {
      const double y = lane(a[h - 1][h - 1], i), product = lane(a[h][h - 1], i) * lane(a[h - 1][h], i);
      const double half = 0.5 * (y - x), disc = half * half + product;
      if (disc >= 0) {
        const double z = half + __builtin_copysign(__builtin_sqrt(disc), half);
        re[w.found] = x + z;
        re[w.found + 1] = z != 0 ? x - product / z : x + z;
        im[w.found] = im[w.found + 1] = 0;
      } else {
        re[w.found] = re[w.found + 1] = x + half;
        im[w.found] = __builtin_sqrt(-disc);
        im[w.found + 1] = -im[w.found];
      }
      w.found += 2;
      w.high -= 2;
    }
    w.trial = 0;
  }
}

// The first column of (A - s1)(A - s2), up to scale, for the window's own pair of shifts.
template <class F, int N> void first_column(const F (&a)[N][N], int i, Window& w, double* column) {
  const int h = w.high, k = w.low;
  double x = lane(a[h][h], i), y = lane(a[h - 1][h - 1], i), product = lane(a[h][h - 1], i) * lane(a[h - 1][h], i);
  if (w.trial % 10 == 9) {  // an exceptional pair of shifts breaks a cycle
    const double s = __builtin_fabs(lane(a[h][h - 1], i)) + __builtin_fabs(lane(a[h - 1][h - 2], i));
    x = y = x + 0.75 * s;
    product = -0.4375 * s * s;
  }
  ++w.trial;
  const double z = lane(a[k][k], i), dx = x - z,
               dy = y - z;  // differences first: they are all that is left in a cluster
  column[0] = (dx * dy - product) / lane(a[k + 1][k], i) + lane(a[k][k + 1], i);
  column[1] = lane(a[k + 1][k + 1], i) - z - dx - dy;
  column[2] = lane(a[k + 2][k + 1], i);
  const double size = 1 / (__builtin_fabs(column[0]) + __builtin_fabs(column[1]) + __builtin_fabs(column[2]));
  for (int c = 0; c < 3; ++c) column[c] *= size;
}

// Eigenvalues of upper Hessenberg matrices (destroyed), one a lane. found[i] < N only when lane i met its bound.
template <class F, int N> void hessenberg_eigenvalues(F (&a)[N][N], double (*re)[N], double (*im)[N], int* found) {
  constexpr int W = width_of<F>;
  Window window[W];
  for (int i = 0; i < W; ++i) {
    window[i] = {0, N - 1, 0, 0, 0};
    for (int r = 0; r < N; ++r)
      for (int c = r ? r - 1 : 0; c < N; ++c) window[i].norm += __builtin_fabs(lane(a[r][c], i));
    if (!(window[i].norm < kEigenvalueOverflow)) window[i].high = -1;
  }
  for (;;) {
    F p0 = 0.0, q0 = 0.0, r0 = 0.0, begin = N, end = -1.0;
    int from = N, to = -1;
    for (int i = 0; i < W; ++i) {
      Window& w = window[i];
      deflate(a, i, w, re[i], im[i]);
      if (w.trial == 60) w.high = -1;
      if (w.high < 0) continue;
      double column[3];
      first_column(a, i, w, column);
      set_lane(p0, i, column[0]);
      set_lane(q0, i, column[1]);
      set_lane(r0, i, column[2]);
      set_lane(begin, i, w.low);
      set_lane(end, i, w.high);
      from = w.low < from ? w.low : from;
      to = w.high > to ? w.high : to;
    }
    if (to < 0) break;
    for (int k = from; k < to; ++k) {
      const double at = k;
      const auto first = begin == at;
      const bool third = k + 2 < N;
      F p = select(first, p0, F(0.0)), q = select(first, q0, F(0.0)), r = select(first, r0, F(0.0));
      if (k > from) {
        const auto inside = (begin < at) & (end > at);
        const auto has_third = inside & (end > at + 1.5);
        p = select(inside, a[k][k - 1], p);
        q = select(inside, a[k + 1][k - 1], q);
        if (third) r = select(has_third, a[k + 2][k - 1], r);
      }
      const F norm = sqrt(p * p + q * q + r * r);
      const F s = select(p < 0.0, 0.0 - norm, norm);
      const F head = p + s, size = s * head;
      const F scale = select(size > 0.0, 1.0 / select(size > 0.0, size, F(1.0)), F(0.0));
      if (k > from) {
        const auto inside = (begin < at) & (end > at) & (norm > 0.0);
        a[k][k - 1] = select(inside, 0.0 - s, a[k][k - 1]);
        a[k + 1][k - 1] = select(inside, F(0.0), a[k + 1][k - 1]);
        if (third) a[k + 2][k - 1] = select(inside & (end > at + 1.5), F(0.0), a[k + 2][k - 1]);
      }
      const F v0 = head * scale, v1 = q * scale, v2 = r * scale;  // I - (v0 v1 v2) (head q r)^T
      if (third) {
        for (int j = k; j <= to; ++j) {
          const F t = head * a[k][j] + q * a[k + 1][j] + r * a[k + 2][j];
          a[k][j] -= t * v0;
          a[k + 1][j] -= t * v1;
          a[k + 2][j] -= t * v2;
        }
        const int last = k + 3 < to ? k + 3 : to;
        for (int i = from; i <= last; ++i) {
          const F t = v0 * a[i][k] + v1 * a[i][k + 1] + v2 * a[i][k + 2];
          a[i][k] -= t * head;
          a[i][k + 1] -= t * q;
          a[i][k + 2] -= t * r;
        }
      } else {
        for (int j = k; j <= to; ++j) {
          const F t = head * a[k][j] + q * a[k + 1][j];
          a[k][j] -= t * v0;
          a[k + 1][j] -= t * v1;
        }
        for (int i = from; i <= to; ++i) {
          const F t = v0 * a[i][k] + v1 * a[i][k + 1];
          a[i][k] -= t * head;
          a[i][k + 1] -= t * q;
        }
      }
    }
  }
  for (int i = 0; i < W; ++i) found[i] = window[i].found;
}

}  // namespace pieper::PIEPER_ISA::general
