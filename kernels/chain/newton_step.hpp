// The only Newton step of the kernels: J dq = e by Householder's reflections, damped or not; and how near J is to being singular.
// The step is a template over the number type; the pivots are scalar.
#pragma once

#include <cmath>

#include "lanes/math.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA {

// Householder triangulation of the first `columns` columns of m (rows x width), carrying the rest along. With Ladder, column c
// has nothing below row Width - 1 + c. Returns the product of the diagonal (the determinant up to sign when square).
template <bool Ladder = false, class F, int Rows, int Width> F triangulate(F (&m)[Rows][Width], int columns) {
  F product = 1.0;
  for (int c = 0; c < columns; ++c) {
    const int rows = Ladder && Width + c < Rows ? Width + c : Rows;
    F tail = 0.0;
    for (int i = c + 1; i < rows; ++i) tail += m[i][c] * m[i][c];
    const F x0 = m[c][c];
    F norm = sqrt(tail + x0 * x0);
    norm = select(x0 > 0.0, norm, 0.0 - norm);
    const F head = x0 + norm, size = norm * head;
    const F scale = select(size > kHouseholderZero, 1.0 / select(size > kHouseholderZero, size, F(1.0)), F(0.0));
    for (int j = c + 1; j < Width; ++j) {
      F w = head * m[c][j];
      for (int i = c + 1; i < rows; ++i) w += m[i][c] * m[i][j];
      w = w * scale;
      m[c][j] -= w * head;
      for (int i = c + 1; i < rows; ++i) m[i][j] -= w * m[i][c];
    }
    m[c][c] = 0.0 - norm;
    product = product * norm;
  }
  return product;
}

// The step of n joints that a triangle [R | e] gives, pivots no smaller than `least`, no component longer than `longest`.
template <class F, int Rows>
PIEPER_INLINE void newton_step(const F (&m)[Rows][7], int n, double least, double longest, F* step) {
  F largest = 0.0;
  for (int k = n - 1; k >= 0; --k) {
    F t = m[k][6];
    for (int j = k + 1; j < n; ++j) t -= m[k][j] * step[j];
    const F pivot = m[k][k];
    step[k] = t / select(abs(pivot) > least, pivot, F(least));
    largest = max(largest, abs(step[k]));
  }
  const F shrink = select(largest > longest, longest / select(largest > longest, largest, F(1.0)), F(1.0));
  for (int k = 0; k < n; ++k) step[k] = shrink * step[k];
}

// The step with (J^T J + damping trace(J^T J)) dq = J^T e, J's columns given: a damping a little above rounding keeps singular
// poses finite.
inline void damped_step(int n, const double* error, const double (*J)[6], double damping, double longest,
                        double* step) {
  double m[12][7] = {}, trace = 0;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 6; ++k) m[k][i] = J[i][k], trace += J[i][k] * J[i][k];
  for (int k = 0; k < 6; ++k) m[k][6] = error[k];
  for (int i = 0; i < n; ++i) m[6 + i][i] = std::sqrt(damping * trace + kTiny);
  triangulate<true>(m, n);
  newton_step(m, n, kTiny, longest, step);
}

// The last pivot of an elimination of J's n columns, of those left the longest each time, as a square beside the sum of all: within a
// small factor of the smallest singular value. One column may be left out.
inline double last_pivot(int n, const double (*J)[6], int without = -1) {
  double Q[6][6], total = 0, last = 0;
  bool used[6] = {};
  for (int i = 0; i < n; ++i)
    for (int r = 0; r < 6; ++r) Q[i][r] = J[i][r];
  if (without >= 0) used[without] = true;
  for (int step = 0; step < n - (without >= 0); ++step) {
    int best = -1;
    double most = -1;
    for (int i = 0; i < n; ++i) {
      if (used[i]) continue;
      double s = 0;
      for (int r = 0; r < 6; ++r) s += Q[i][r] * Q[i][r];
      if (step == 0) total += s;
      if (s > most) most = s, best = i;
    }
    if (!(most > 0)) return 0;
    used[best] = true, last = most;
    for (int i = 0; i < n; ++i) {
      if (used[i]) continue;
      double s = 0;
      for (int r = 0; r < 6; ++r) s += Q[i][r] * Q[best][r];
      s /= most;
      for (int r = 0; r < 6; ++r) Q[i][r] -= s * Q[best][r];
    }
  }
  return last / total;
}

}  // namespace pieper::PIEPER_ISA
