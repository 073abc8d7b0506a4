// The Jacobian of an arm at a posture as singular values times joint directions, and the shortest step that it allows. Scalar.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "chain/posture.hpp"

namespace pieper::PIEPER_ISA {

inline double dot_of(const double* a, const double* b, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}
inline double size_of(const double* a, int n) { return std::sqrt(dot_of(a, a, n)); }

// Rows (r x n, r up to 7) turned among each other until they are orthogonal (one-sided Jacobi): each is then a singular value
// times its joint direction, and what is asked of the rows is turned along.
struct SingularRows {
  int r, n;
  std::vector<double> A;
  double b[7];

  double* row(int i) { return &A[i * n]; }

  // The Jacobian's six rows at a posture and what is asked of them, and a seventh row of which nothing is.
  void take(const Posture& arm, const double* e, const double* seventh) {
    n = arm.n, r = seventh ? 7 : 6;
    A.resize(7 * n);
    for (int k = 0; k < n; ++k) {
      double moved[6];
      arm.column(k, moved);
      for (int i = 0; i < 6; ++i) A[i * n + k] = moved[i];
    }
    for (int i = 0; i < 7; ++i) b[i] = e && i < 6 ? e[i] : 0;
    if (seventh) std::copy(seventh, seventh + n, &A[6 * n]);
    diagonalise();
  }

  // What part of the strongest direction the weakest is.
  double weakest() {
    double most = 0, least = INFINITY;
    for (int i = 0; i < r; ++i) {
      const double size = size_of(row(i), n);
      most = std::fmax(most, size), least = std::fmin(least, size);
    }
    return least / most;
  }

  // The shortest step (n) that does what is asked along directions stronger than this part of the strongest.
  void shortest(double cutoff, double* step) {
    double most = 0;
    for (int i = 0; i < r; ++i) most = std::fmax(most, size_of(row(i), n));
    std::fill(step, step + n, 0.0);
    for (int i = 0; i < r; ++i) {
      const double square = dot_of(row(i), row(i), n);
      if (!(std::sqrt(square) > cutoff * most)) continue;
      for (int k = 0; k < n; ++k) step[k] += b[i] / square * row(i)[k];
    }
  }

 private:
  void diagonalise() {
    bool turned = true;
    for (int sweep = 0; sweep < 30 && turned; ++sweep) {
      turned = false;
      for (int i = 0; i < r; ++i)
        for (int j = i + 1; j < r; ++j) turned |= turn(i, j);
    }
  }
  bool turn(int i, int j) {
    double *x = row(i), *y = row(j);
    const double a = dot_of(x, x, n), c = dot_of(y, y, n), d = dot_of(x, y, n);
    if (d * d <= kOrthogonal * kOrthogonal * a * c || d == 0) return false;
    const double zeta = (c - a) / (2 * d), t = (zeta >= 0 ? 1 : -1) / (std::fabs(zeta) + std::sqrt(1 + zeta * zeta));
    const double cos = 1 / std::sqrt(1 + t * t), sin = cos * t;
    for (int k = 0; k < n; ++k) {
      const double u = x[k], v = y[k];
      x[k] = cos * u - sin * v, y[k] = sin * u + cos * v;
    }
    const double u = b[i], v = b[j];
    b[i] = cos * u - sin * v, b[j] = sin * u + cos * v;
    return true;
  }
};

}  // namespace pieper::PIEPER_ISA
