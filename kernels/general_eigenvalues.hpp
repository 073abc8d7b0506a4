// Eigenvalues of a small real matrix: Householder's Hessenberg form in lanes, then Francis' double-shift QR (1961).
//
// LAPACK is not linked: for 16 x 16 its call overhead and blocking cost more than the arithmetic. Only eigenvalues are wanted, so the
// reflections of the QR steps touch the active window alone.
#pragma once

#include "lanes.hpp"

namespace pieper::PIEPER_ISA::general {

template <class F, int N> void hessenberg(F (&a)[N][N]) {
  for (int k = 0; k + 2 < N; ++k) {
    F tail = 0.0;
    for (int i = k + 2; i < N; ++i) tail += a[i][k] * a[i][k];
    const F x0 = a[k + 1][k];
    F norm = sqrt(tail + x0 * x0);
    norm = select(x0 > 0.0, norm, 0.0 - norm);
    const F head = x0 + norm, size = norm * head;
    const F scale = select(size > 1e-290, 1.0 / select(size > 1e-290, size, F(1.0)), F(0.0));
    F v[N];
    v[k + 1] = head;
    for (int i = k + 2; i < N; ++i) v[i] = a[i][k];
    for (int j = k + 1; j < N; ++j) {
      F w = 0.0;
      for (int i = k + 1; i < N; ++i) w += v[i] * a[i][j];
      w = w * scale;
      for (int i = k + 1; i < N; ++i) a[i][j] -= w * v[i];
    }
    for (int i = 0; i < N; ++i) {
      F w = 0.0;
      for (int j = k + 1; j < N; ++j) w += a[i][j] * v[j];
      w = w * scale;
      for (int j = k + 1; j < N; ++j) a[i][j] -= w * v[j];
    }
    a[k + 1][k] = 0.0 - norm;
    for (int i = k + 2; i < N; ++i) a[i][k] = 0.0;
  }
}

// Scales rows against columns by powers of two until their sums are alike (Osborne, 1960; Parlett and Reinsch, 1969).
template <int N> void balance(double (&a)[N][N]) {
  for (int sweep = 0, changed = 1; sweep < 6 && changed; ++sweep) {
    changed = 0;
    for (int i = 0; i < N; ++i) {
      double c = 0, r = 0;
      for (int j = 0; j < N; ++j)
        if (j != i) {
          c += __builtin_fabs(a[j][i]);
          r += __builtin_fabs(a[i][j]);
        }
      if (!(c > 0) || !(r > 0)) continue;
      double f = 1, s = c + r;
      for (int guard = 0; c < r / 2 && guard < 200; ++guard) f *= 2, c *= 4;
      for (int guard = 0; c >= r * 2 && guard < 200; ++guard) f /= 2, c /= 4;
      if ((c + r) / f < 0.9 * s) {
        changed = 1;
        for (int j = 0; j < N; ++j) a[i][j] /= f;
        for (int j = 0; j < N; ++j) a[j][i] *= f;
      }
    }
  }
}

// Eigenvalues of an upper Hessenberg matrix (destroyed). Returns how many were found; fewer than N only when the
// iteration met its bound.
template <int N> int hessenberg_eigenvalues(double (&a)[N][N], double* re, double* im) {
  constexpr double eps = 2.220446049250313e-16;
  double norm = 0;
  for (int i = 0; i < N; ++i)
    for (int j = i ? i - 1 : 0; j < N; ++j) norm += __builtin_fabs(a[i][j]);
  if (!(norm < 1e290)) return 0;
  int high = N - 1, found = 0, trial = 0;
  while (high >= 0) {
    int low = high;
    for (; low > 0; --low) {
      double s = __builtin_fabs(a[low - 1][low - 1]) + __builtin_fabs(a[low][low]);
      // a cluster may keep rounding of the size of the whole matrix alive: after a while that counts as zero too
      if (s == 0 || (trial > 15 && s < 0.1 * norm)) s = 0.1 * norm;
      if (__builtin_fabs(a[low][low - 1]) <= eps * s) {
        a[low][low - 1] = 0;
        break;
      }
    }
    if (low == high) {
      re[found] = a[high][high];
      im[found++] = 0;
      --high;
      trial = 0;
      continue;
    }
    double x = a[high][high], y = a[high - 1][high - 1], w = a[high][high - 1] * a[high - 1][high];
    if (low == high - 1) {
      const double half = 0.5 * (y - x), disc = half * half + w;
      if (disc >= 0) {
        const double z = half + __builtin_copysign(__builtin_sqrt(disc), half);
        re[found] = x + z;
        re[found + 1] = z != 0 ? x - w / z : x + z;
        im[found] = im[found + 1] = 0;
      } else {
        re[found] = re[found + 1] = x + half;
        im[found] = __builtin_sqrt(-disc);
        im[found + 1] = -im[found];
      }
      found += 2;
      high -= 2;
      trial = 0;
      continue;
    }
    if (trial == 60) return found;
    if (trial % 10 == 9) {  // an exceptional pair of shifts breaks a cycle
      const double s = __builtin_fabs(a[high][high - 1]) + __builtin_fabs(a[high - 1][high - 2]);
      x = y = x + 0.75 * s;
      w = -0.4375 * s * s;
    }
    ++trial;
    int start = high - 2;
    double p = 0, q = 0, r = 0;
    for (;; --start) {  // two consecutive small subdiagonal elements also allow a start
      const double z = a[start][start], dx = x - z, dy = y - z;  // differences first: they are all that is left in a cluster
      p = (dx * dy - w) / a[start + 1][start] + a[start][start + 1];
      q = a[start + 1][start + 1] - z - dx - dy;
      r = a[start + 2][start + 1];
      const double s = __builtin_fabs(p) + __builtin_fabs(q) + __builtin_fabs(r);
      p /= s;
      q /= s;
      r /= s;
      if (start == low) break;
      const double u = __builtin_fabs(a[start][start - 1]) * (__builtin_fabs(q) + __builtin_fabs(r));
      const double v = __builtin_fabs(p) * (__builtin_fabs(a[start - 1][start - 1]) + __builtin_fabs(z) +
                                            __builtin_fabs(a[start + 1][start + 1]));
      if (u <= eps * v) break;
    }
    for (int k = start; k < high; ++k) {
      const bool three = k + 2 <= high;
      if (k > start) {
        p = a[k][k - 1];
        q = a[k + 1][k - 1];
        r = three ? a[k + 2][k - 1] : 0;
      }
      double s = __builtin_sqrt(p * p + q * q + r * r);
      if (s == 0) continue;
      s = __builtin_copysign(s, p);
      if (k > start) {
        a[k][k - 1] = -s;
        a[k + 1][k - 1] = 0;
        if (three) a[k + 2][k - 1] = 0;
      } else if (start > low) {
        a[k][k - 1] = -a[k][k - 1];
      }
      const double head = p + s, scale = 1 / (s * head);
      const double v0 = head * scale, v1 = q * scale, v2 = r * scale;  // I - (v0 v1 v2) (head q r)^T
      if (three) {
        for (int j = k; j <= high; ++j) {
          const double t = head * a[k][j] + q * a[k + 1][j] + r * a[k + 2][j];
          a[k][j] -= t * v0;
          a[k + 1][j] -= t * v1;
          a[k + 2][j] -= t * v2;
        }
        const int last = k + 3 < high ? k + 3 : high;
        for (int i = low; i <= last; ++i) {
          const double t = v0 * a[i][k] + v1 * a[i][k + 1] + v2 * a[i][k + 2];
          a[i][k] -= t * head;
          a[i][k + 1] -= t * q;
          a[i][k + 2] -= t * r;
        }
      } else {
        for (int j = k; j <= high; ++j) {
          const double t = head * a[k][j] + q * a[k + 1][j];
          a[k][j] -= t * v0;
          a[k + 1][j] -= t * v1;
        }
        for (int i = low; i <= high; ++i) {
          const double t = v0 * a[i][k] + v1 * a[i][k + 1];
          a[i][k] -= t * head;
          a[i][k + 1] -= t * q;
        }
      }
    }
  }
  return found;
}

}  // namespace pieper::PIEPER_ISA::general
