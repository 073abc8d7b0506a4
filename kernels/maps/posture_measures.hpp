// What is measured of one posture of six joints: the determinant of its Jacobian and the smallest singular value.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace pieper {

// det J (6 x 6, row-major, spoilt), by elimination with pivots.
inline double determinant(double* J) {
  double product = 1;
  for (int k = 0; k < 6; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 6; ++i)
      if (std::fabs(J[6 * i + k]) > std::fabs(J[6 * pivot + k])) pivot = i;
    if (J[6 * pivot + k] == 0) return 0;
    if (pivot != k) {
      std::swap_ranges(J + 6 * k, J + 6 * k + 6, J + 6 * pivot);
      product = -product;
    }
    product *= J[6 * k + k];
    for (int i = k + 1; i < 6; ++i) {
      const double f = J[6 * i + k] / J[6 * k + k];
      for (int j = k + 1; j < 6; ++j) J[6 * i + j] -= f * J[6 * k + j];
    }
  }
  return product;
}

// The smallest singular value of J (6 x 6, row-major, spoilt): rows are turned in pairs until each is square to all others
// (Hestenes, 1958); their lengths are the singular values then, small ones as accurate as large ones.
inline double smallest_singular_value(double* J) {
  constexpr int most_sweeps = 30;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool square = true;
    for (int a = 0; a < 5; ++a)
      for (int b = a + 1; b < 6; ++b) {
        double aa = 0, bb = 0, ab = 0;
        for (int i = 0; i < 6; ++i) {
          aa += J[6 * a + i] * J[6 * a + i];
          bb += J[6 * b + i] * J[6 * b + i];
          ab += J[6 * a + i] * J[6 * b + i];
        }
        if (std::fabs(ab) <= std::numeric_limits<double>::epsilon() * std::sqrt(aa * bb)) continue;
        square = false;
        const double z = (bb - aa) / (2 * ab), t = std::copysign(1.0, z) / (std::fabs(z) + std::sqrt(1 + z * z)),
                     c = 1 / std::sqrt(1 + t * t), s = c * t;
        for (int i = 0; i < 6; ++i) {
          const double x = J[6 * a + i], y = J[6 * b + i];
          J[6 * a + i] = c * x - s * y;
          J[6 * b + i] = s * x + c * y;
        }
      }
    if (square) break;
  }
  double least = INFINITY;
  for (int a = 0; a < 6; ++a) {
    double size = 0;
    for (int i = 0; i < 6; ++i) size += J[6 * a + i] * J[6 * a + i];
    least = std::min(least, size);
  }
  return std::sqrt(least);
}

}  // namespace pieper
